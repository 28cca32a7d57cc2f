// Loads the scripts of the figures that are on the page: <fig-bytes> is www/figures/fig-bytes.js.
import { shareAll } from "./shared-points.js";

/** @type {Record<string, () => Promise<unknown>>} */
const SCRIPTS = import.meta.glob("../figures/*.js");

const tags = new Set(Array.from(document.querySelectorAll("main :not(:defined)"), ({ localName }) => localName));
for (const tag of tags) void SCRIPTS[`../figures/${tag}.js`]?.();

shareAll(document);
if (document.querySelector("bezier-surface:is([data-surface], [data-view])")) {
  const { showSurfaces } = await import("../figures/lib/surfaces.js");
  await customElements.whenDefined("bezier-surface");
  showSurfaces();
}
