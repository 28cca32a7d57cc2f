// The page is the drawing surface; this starts it and keeps the settings in the address.
import "../parts/page.js";
import { keepInAddress } from "../figures/lib/address.js";
import { checkedSettings, InkPad } from "./ink-pad.js";

customElements.define("ink-pad", InkPad);
const pad = /** @type {InkPad} */ (document.querySelector("ink-pad"));

keepInAddress(pad, {
  read: (state) => {
    pad.settings = checkedSettings(state);
  },
  write: () => pad.settings,
});
