// Defines the figures of the chapters. They belong to the site, not to the package.
import { FigBinomial } from "./fig-binomial.js";
import { FigBytes } from "./fig-bytes.js";
import { FigCompare } from "./fig-compare.js";
import { FigCosts } from "./fig-costs.js";
import { FigCurve3d } from "./fig-curve-3d.js";
import { FigParabola } from "./fig-parabola.js";
import { FigPyramid } from "./fig-pyramid.js";
import { FigReorder } from "./fig-reorder.js";
import { FigRounding } from "./fig-rounding.js";

/** @type {Record<string, CustomElementConstructor>} */
const FIGURES = {
  "fig-binomial": FigBinomial,
  "fig-bytes": FigBytes,
  "fig-compare": FigCompare,
  "fig-costs": FigCosts,
  "fig-curve-3d": FigCurve3d,
  "fig-parabola": FigParabola,
  "fig-pyramid": FigPyramid,
  "fig-reorder": FigReorder,
  "fig-rounding": FigRounding,
};

for (const [name, figure] of Object.entries(FIGURES)) {
  if (!customElements.get(name)) customElements.define(name, figure);
}
