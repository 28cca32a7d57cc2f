// Loads the script of each kind of figure when one is near the window: <fig-bytes> is www/figures/fig-bytes.js.
import { shareAll } from "./shared-points.js";
import { whenNear } from "./when-near.js";

/** @type {Record<string, () => Promise<unknown>>} */
const SCRIPTS = import.meta.glob("../figures/*.js");

for (const figure of document.querySelectorAll("main :not(:defined)")) {
  const load = SCRIPTS[`../figures/${figure.localName}.js`];
  if (load) whenNear(figure, () => void load());
}

shareAll(document);
// Not awaited here: the scripts that follow in the bundle define the elements.
if (document.querySelector("bezier-surface:is([data-surface], [data-view])"))
  void customElements
    .whenDefined("bezier-surface")
    .then(() => import("../figures/lib/surfaces.js"))
    .then(({ showSurfaces }) => showSurfaces());
