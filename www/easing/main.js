// Defines the tool, and keeps its curve in the address.
import "../parts/page.js";
import { keepInAddress } from "../figures/lib/address.js";
import { EasingLab } from "./easing-lab.js";
import { parse, rounded } from "./value.js";

customElements.define("easing-lab", EasingLab);
const lab = /** @type {EasingLab} */ (document.querySelector("easing-lab"));

keepInAddress(lab, {
  read: (state) => {
    const { curve } = /** @type {{ curve: number[] }} */ (state);
    if (!Array.isArray(curve)) throw new RangeError("expected curve, a list of four numbers");
    lab.set(parse(curve.join(",")));
  },
  write: () => ({ curve: rounded(lab.value) }),
});
