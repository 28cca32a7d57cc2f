// What the element says.
import { MISSING } from "../loading.js";

export const MODEL_NAMES: Record<string, string> = {
  teapot: "Teapot",
  teacup: "Teacup",
  teaspoon: "Teaspoon",
  patch: "One patch",
};
export const SHADING_NAMES: Record<string, string> = {
  smooth: "Smooth",
  flat: "Flat",
  normals: "Normals",
  gaussian: "Gaussian curvature",
  mean: "Mean curvature",
  patches: "Patch colours",
};
export const DETAIL_NAMES: Record<string, string> = {
  segments: "by segments",
  tolerance: "by tolerance",
  pixels: "by pixels",
  flatness: "until flat enough",
};
export const EVALUATION_NAMES: Record<string, string> = {
  cpu: "WebAssembly",
  forward: "forward differences",
  gpu: "graphics card",
};
export const LAYER_NAMES: Record<string, string> = {
  surface: "surface",
  mesh: "mesh",
  isocurves: "iso-curves",
  tubes: "tubes",
  ribbons: "ribbons",
  net: "control net",
  casteljau: "de Casteljau",
  place: "place",
  derivatives: "derivatives",
  names: "names",
};
/** What there is to say of the picture. */
export const STATES = {
  coming: "",
  missing: MISSING,
  webgl: "",
  flat: "This browser has no WebGL2, so the surface is drawn as lines.",
  lost: "The WebGL context was lost. The picture returns when it is restored.",
};
/** What each step of de Casteljau's algorithm shows. */
export const STEP_WORDS = [
  "The curve of row 0 is evaluated at u.",
  "The curves of the other rows are evaluated at the same u.",
  "The four points are the control points of one more curve.",
  "This curve is evaluated at v: the result is S(u, v).",
];
export const INSTRUCTIONS =
  "Drag to rotate, with Shift to move the picture; zoom with two fingers. Keys: the arrow keys rotate, with Shift they move the picture; plus and minus zoom; 0 restores the first view; Ctrl+Z undoes, Ctrl+Y redoes.";

/** Two figures that count. */
export function figures(x: number) {
  return x === 0 ? "0" : x < 1e-4 || x >= 1e6 ? x.toExponential(1) : String(Number(x.toPrecision(2)));
}

/** An upper bound with two figures: rounded up, so that it is still one. */
export function upperBound(x: number) {
  const unit = 10 ** (Math.floor(Math.log10(x)) - 1);
  const rounded = Number(x.toPrecision(2));
  return figures(x === 0 || rounded >= x ? rounded : rounded + unit);
}
