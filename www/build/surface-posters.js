// Draws every <bezier-surface …></bezier-surface> into the page while the site is built, as lines: the picture that is there
// before the element starts, without JavaScript, and on paper where it was not seen yet.
import { boundingSphereOf, HOME, moved, pixelMatrix, placeOf, cameraMatricesOf } from "#js/elements/surface/camera.js";
import { framingPoints, surfaceNamed } from "#js/elements/surface/models.js";
import * as rational from "#js/elements/surface/rational.js";
import { settingsOf } from "#js/elements/surface/settings.js";
import { RationalCurve } from "#js/nurbs.js";
import { SURFACES } from "../figures/lib/surfaces.js";
import { vase } from "./vase.js";

const [WIDTH, HEIGHT] = [600, 400];
/** Curves that divide each patch into so many strips: one patch can have more than thirty-two. */
const [FEW, MANY] = [2, 6];
/** Below so many patches there is room for many. */
const ROOM = 4;

/** Surfaces that scripts give to elements, by `data-surface` or by id. @type {Record<string, () => any>} */
const GIVEN = { ...SURFACES, "vase-surface": vase };

/**
 * The attributes of a tag; those without a value are "".
 *
 * @param {string} tag
 * @returns {Record<string, string>}
 */
const attributesOf = (tag) =>
  Object.fromEntries(
    Array.from(tag.matchAll(/\s([\w-]+)(?:="([^"]*)"|='([^']*)')?/g), ([, name, value, other]) => [
      name,
      value ?? other ?? "",
    ]),
  );

/**
 * The curves of the surface with these attributes, as an SVG. Curves with weights are projected exactly. The control points of
 * the others are put where the lens shows them: for so long a lens the curve through those is the picture of the curve, but for a
 * hair.
 *
 * @param {Record<string, string>} attributes
 * @returns {string}
 */
export function surfacePoster(attributes) {
  const settings = settingsOf(/** @type {any} */ (attributes));
  const given = GIVEN[attributes["data-surface"] ?? attributes.id]?.();
  const surface = given ?? surfaceNamed(settings, rational);
  const sphere = boundingSphereOf(given?.vertices ?? framingPoints(settings, rational), settings.up);
  const view = moved(HOME, JSON.parse(attributes["data-view"] ?? "{}"));
  const matrices = cameraMatricesOf(view, sphere, WIDTH, HEIGHT);
  const lines = surface.patchCount < ROOM ? MANY : FEW;
  const path = surface
    .isocurves({ lines })
    .map((/** @type {any} */ curve) => ("weights" in curve ? projected(curve, matrices) : pathOf(curve, matrices)))
    .join("");
  return `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${attributes.label ?? "A surface of Bézier patches"}"><path d="${path}" fill="none" stroke="currentColor" stroke-opacity="0.6"/></svg>`;
}

/** @param {import("casteljau/nurbs").RationalCurve<3>} curve @param {import("#js/elements/surface/camera.js").CameraMatrices} matrices */
function projected(curve, matrices) {
  const image = curve.transform(pixelMatrix(matrices, WIDTH, HEIGHT));
  const points = image.points().map(({ x, y }) => [x, y]);
  return new RationalCurve(points, image.weights()).toSVG({ precision: 1 });
}

/** @param {import("casteljau/surfaces").Curve} curve @param {import("#js/elements/surface/camera.js").CameraMatrices} matrices */
function pathOf(curve, matrices) {
  const points = curve.controlPoints();
  const places = Array.from({ length: points.length / 3 }, (_, k) => placeOf(matrices, points, 3 * k) ?? [0, 0]);
  const [first, ...rest] = places.map((place) => place.map((x) => x.toFixed(1)).join(" "));
  return `M${first}${rest.length === 3 ? "C" : rest.length === 2 ? "Q" : "L"}${rest.join(" ")}`;
}

/** Draws the picture into every `<bezier-surface>` of a page that holds no elements. @param {string} html */
export const addSurfacePosters = (html) =>
  html.replace(
    /(<bezier-surface\b((?:[^>"']|"[^"]*"|'[^']*')*)>)[^<]*(?=<\/bezier-surface>)/g,
    (_, tag, attributes) => tag + surfacePoster(attributesOf(attributes)),
  );
