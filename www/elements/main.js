// The elements themselves, the playground, what the form would send, and the frame that is as tall as what is in it.
import "../parts/page.js";
import { startPlayground } from "./playground.js";

startPlayground(/** @type {HTMLElement} */ (document.querySelector(".playground")));

const form = /** @type {HTMLFormElement} */ (document.getElementById("figure-form"));
const sent = /** @type {HTMLOutputElement} */ (document.getElementById("sent"));
const show = () => (sent.textContent = new URLSearchParams(/** @type {any} */ (new FormData(form))).toString());

for (const type of ["input", "change"]) form.addEventListener(type, show);
void customElements.whenDefined("bezier-easing").then(show);

addEventListener("message", ({ data, source }) => {
  if (data?.casteljau !== "height") return;
  const frame = [...document.querySelectorAll("iframe")].find((each) => each.contentWindow === source);
  if (frame) frame.height = data.height;
});
