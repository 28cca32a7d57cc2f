// The teapot: a picture until it is wanted, then <bezier-surface> with the same view.
import { find, whenWanted } from "../picture.js";
import { TEAPOT, TEAPOT_VIEW } from "./teapot-view.js";

const box = find('[data-thing="teapot"]');
/** @type {HTMLElement} */
const picture = find(".picture", box);
/** @type {HTMLButtonElement} */
const button = find("button", box);
/** @type {Promise<void> | undefined} */
let starting;

async function start() {
  button.disabled = true;
  button.textContent = "Loading …";
  await import("casteljau/elements/surface");
  const surface = /** @type {any} */ (document.createElement("bezier-surface"));
  for (const [name, value] of Object.entries(TEAPOT)) surface.setAttribute(name, value);
  surface.setAttribute("label", "The Utah teapot. Drag a control point, or beside the teapot to turn it");
  const { width, height } = picture.getBoundingClientRect();
  surface.style.setProperty("--bz-aspect", `${width} / ${height}`);
  picture.append(surface);
  await surface.updateComplete;
  surface.view = { ...surface.view, ...TEAPOT_VIEW };
  picture.classList.add("live");
  picture.removeAttribute("role");
  picture.removeAttribute("aria-label");
  const hadFocus = document.activeElement === button;
  button.hidden = true;
  if (hadFocus) surface.focus();
}

const startOnce = () => (starting ??= start());
button.hidden = false;
button.addEventListener("click", startOnce);
whenWanted(picture, startOnce);
