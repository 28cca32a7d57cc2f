// What the element says.
import { missing } from "../loading.js";
import { translated, translatedTable } from "../../editor/translations.js";

export const MODEL_NAMES: Record<string, string> = translatedTable({
  teapot: "Teapot",
  teacup: "Teacup",
  teaspoon: "Teaspoon",
  patch: "One patch",
  sphere: "Sphere",
  torus: "Torus",
  cylinder: "Cylinder",
  cone: "Cone",
});
export const SHADING_NAMES: Record<string, string> = translatedTable({
  smooth: "Smooth",
  flat: "Flat",
  normals: "Normals",
  gaussian: "Gaussian curvature",
  mean: "Mean curvature",
  patches: "Patch colours",
});
export const DETAIL_NAMES: Record<string, string> = translatedTable({
  segments: "by segments",
  tolerance: "by tolerance",
  pixels: "by pixels",
  flatness: "until flat enough",
});
export const EVALUATION_NAMES: Record<string, string> = translatedTable({
  cpu: "WebAssembly",
  forward: "forward differences",
  gpu: "graphics card",
});
export const LAYER_NAMES: Record<string, string> = translatedTable({
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
});
export const PART_NAMES: Record<string, string> = translatedTable({
  lid: "lid",
  rim: "rim",
  body: "body",
  handle: "handle",
  spout: "spout",
  bottom: "bottom",
});
export const HEIGHT_NAMES: Record<string, string> = translatedTable({
  squashed: "squashed, as usual",
  original: "Newell’s, 4/3 as tall",
});
/** The message about the picture in each of its states. */
export const STATES = {
  loading: () => "",
  missing,
  webgl: () => "",
  flat: () => translated("This browser has no WebGL2, so the surface is drawn as lines."),
  lost: () => translated("The WebGL context was lost. The picture returns when it is restored."),
};
/** What each step of de Casteljau's algorithm shows. */
export const STEP_WORDS = [
  () => translated("The curve of row 0 is evaluated at u."),
  () => translated("The curves of the other rows are evaluated at the same u."),
  () => translated("The four points are the control points of one more curve."),
  () => translated("This curve is evaluated at v: the result is S(u, v)."),
];
export const instructions = () =>
  translated(
    "Drag to rotate, with Shift to move the picture; zoom with two fingers. Keys: the arrow keys rotate, with Shift they move the picture; plus and minus zoom; 0 restores the first view; Ctrl+Z undoes, Ctrl+Y redoes.",
  );

/** A number with two significant digits. */
export function twoDigits(x: number) {
  return x === 0 ? "0" : x < 1e-4 || x >= 1e6 ? x.toExponential(1) : String(Number(x.toPrecision(2)));
}

/** An upper bound with two significant digits: rounded up, so that it is still one. */
export function upperBound(x: number) {
  const unit = 10 ** (Math.floor(Math.log10(x)) - 1);
  const rounded = Number(x.toPrecision(2));
  return twoDigits(x === 0 || rounded >= x ? rounded : rounded + unit);
}
