// The chapter on curves: the elements and figures that it shows, and what joins them on this page.
import "../parts/page.js";
import "../figures/index.js";
import "./fig-affine.js";
import "./fig-speed.js";
import { byDegree } from "./degrees.js";
import { matrixEditor } from "./matrix.js";
import { hermiteReadout } from "./hermite.js";
import { shareAll } from "./shared.js";
import { steerFrom } from "./steer.js";
import { layTargets } from "./target.js";
import { treeReadout } from "./tree.js";
import { zoomButtons } from "./zoom.js";

const get = (/** @type {string} */ id) => /** @type {any} */ (document.getElementById(id));

layTargets(document);
await customElements.whenDefined("bezier-applet");
shareAll(document);
steerFrom(document);
matrixEditor(get("matrix"), get("basis"));
hermiteReadout(get("hermite"), get("tangents"));
treeReadout(get("tree"), get("recursion"));
byDegree({ element: get("elevation"), more: get("elevate"), less: get("reduce"), words: get("elevated") });
zoomButtons(document.querySelectorAll("[data-zoom]"), get("zoom"));
