// Pictures of the recipes for the grid of /recipes/: what each shows first, drawn by the package while the site is built.
import { Curve, easing, InkStroke, Path, Spline } from "casteljau";
import { NurbsCurve } from "casteljau/nurbs";
import { cameraPicture, inkPicture, shapesPicture } from "./home-pictures.js";
import { surfacePoster } from "./surface-posters.js";

/** @typedef {[number, number]} Point */
/** @typedef {{ toSVG(options?: { precision: number }): string }} Drawn */

const [WIDTH, HEIGHT] = [320, 200];
const HEART = "M100 180C20 120 10 70 45 45C70 28 92 42 100 66C108 42 130 28 155 45C190 70 180 120 100 180Z";

/** @param {string} className @param {string | Drawn} shape */
const path = (className, shape) =>
  `<path class="${className}" d="${typeof shape === "string" ? shape : shape.toSVG({ precision: 1 })}"/>`;
/** @param {string} className @param {{ x: number, y: number }} point */
const dot = (className, { x, y }, radius = 5) =>
  `<circle class="${className}" cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${radius}"/>`;
/** @param {readonly Point[]} points */
const lines = (points) => `M${points.map((point) => point.map((x) => x.toFixed(1)).join(" ")).join("L")}`;

function textAlongPath() {
  const curve = new Curve([
    [24, 150],
    [100, 24],
    [190, 180],
    [296, 78],
  ]);
  return `<path id="text-along-path-line" class="rule" d="${curve.toSVG()}"/><text dy="-7" class="letters"><textPath href="#text-along-path-line">Each letter stands on the curve.</textPath></text>${curve
    .points()
    .map((point) => dot("handle", point, 6))
    .join("")}`;
}

function hitTesting() {
  const heart = Path.fromSVG(HEART).transform([1, 0, 0, 1, 0, -8]);
  const curve = Path.fromSVG("M190 160C205 20 275 20 265 100S300 160 305 40");
  /** @type {Point} */
  const tested = [160, 120];
  const nearest = curve.nearest(tested);
  const { x, y } = nearest?.point ?? { x: 0, y: 0 };
  return `${path("letter", heart)}${path("line", curve)}${path("lever", lines([tested, [x, y]]))}${dot("anchor", { x, y })}${dot("handle", { x: tested[0], y: tested[1] }, 7)}`;
}

function simplifyStroke() {
  const points = Array.from(
    { length: 121 },
    (_, i) =>
      /** @type {Point} */ ([
        16 + 2.4 * i,
        100 + 52 * Math.sin(i / 14) + 2.4 * Math.sin(i * 2.7) + 1.6 * Math.cos(i * 5.1),
      ]),
  );
  const spline = Spline.fit(points, { tolerance: 5 });
  const joints = Array.from({ length: spline.segmentCount + 1 }, (_, k) => dot("anchor", spline.eval(k)));
  return `${path("lever", lines(points))}${path("line", spline)}${joints.join("")}`;
}

function iconIntersections() {
  const heart = Path.fromSVG(HEART).transform([1, 0, 0, 1, 20, -8]);
  const star = Path.polygon(
    Array.from({ length: 10 }, (_, i) => {
      const [radius, angle] = [i % 2 ? 34 : 78, (i * Math.PI) / 5 - Math.PI / 2];
      return /** @type {Point} */ ([205 + radius * Math.cos(angle), 105 + radius * Math.sin(angle)]);
    }),
  );
  const found = heart.intersections(star).map(({ point }) => dot("crossing", point));
  return `${path("letter", heart)}${path("letter", star)}${found.join("")}`;
}

function booleanOperations() {
  const { union, leaf, at, crossings } = shapesPicture();
  const dots = crossings.map(([x, y]) => dot("crossing", { x: Number(x), y: Number(y) }, 4));
  return `${path("letter", union)}<path class="lever" d="${leaf}" transform="translate(${at})"/>${dots.join("")}`;
}

function shapeBuilder() {
  const circles = [
    [122, 76],
    [198, 76],
    [160, 134],
  ].map((centre) => Path.circle(/** @type {Point} */ (centre), 60));
  const faces = Path.faces(circles);
  return faces
    .map(({ path: face, inside }) => path(inside[0] && !inside[1] ? "letter chosen" : "letter", face))
    .join("");
}

/** A circle and its control polygon, a square. */
function exactCircle() {
  const circle = NurbsCurve.circle([WIDTH / 2, HEIGHT / 2], 78);
  const points = circle.points();
  const polygon = lines(points.map(({ x, y }) => /** @type {Point} */ ([x, y])));
  return `${path("lever", polygon)}${path("line", circle)}${points
    .slice(1)
    .map((point) => dot("anchor", point))
    .join("")}`;
}

function strokeOutline() {
  const line = Path.fromSVG("M40 160L90 50C150 30 170 150 200 140S270 60 285 70");
  return `${path("letter", line.stroke(34, { join: "round", cap: "round" }))}${path("lever", line)}`;
}

function brushStroke() {
  const ink = new InkStroke({ size: 22, taper: { start: 40, end: 60 }, thinning: 0.7 });
  for (let i = 0; i <= 61; i++) ink.append(24 + 4.4 * i, 100 + 58 * Math.sin(i / 9), {});
  return `${path("fill", ink.outline())}`;
}

function cameraFlight() {
  const { shadow, ribs, path: flight } = cameraPicture();
  return `${path("shadow", shadow)}${path("ribs", ribs)}${path("line", flight)}`;
}

/** Profile and parallels of the vase, seen from above by a little. */
function vase() {
  const side = new Curve([
    [28, 0],
    [46, 35],
    [10, 75],
    [24, 100],
  ]);
  const [SCALE, TILT] = [1.5, 0.3];
  const place = (/** @type {number} */ radius, /** @type {number} */ z) =>
    /** @type {Point} */ ([WIDTH / 2 + SCALE * radius, 178 - SCALE * z]);
  const parallels = Array.from({ length: 15 }, (_, k) => {
    const { x, y } = side.eval(k / 14);
    const [, cy] = place(0, y);
    return `<ellipse class="line thin" cx="${WIDTH / 2}" cy="${cy.toFixed(1)}" rx="${(SCALE * x).toFixed(1)}" ry="${(SCALE * TILT * x).toFixed(1)}"/>`;
  });
  const sides = [1, -1].map((sign) => path("line", side.transform([sign * SCALE, 0, 0, -SCALE, WIDTH / 2, 178])));
  return `${parallels.join("")}${sides.join("")}`;
}

function easingToLinear() {
  const ease = easing(0.3, -0.3, 0.2, 1.4);
  const place = (/** @type {number} */ x, /** @type {number} */ y) =>
    /** @type {Point} */ ([60 + 200 * x, 165 - 130 * y]);
  const exact = Array.from({ length: 101 }, (_, i) => place(i / 100, ease(i / 100)));
  const stops = easing(ease.toLinear(0.02));
  const css = ease.toLinear(0.02);
  const corners = stopsOf(css).map(([x]) => place(x, stops(x)));
  return `${path("rule", "M60 165H260M60 35H260M60 165V35")}${path("lever", lines(corners))}${path("line", lines(exact))}${corners.map(([x, y]) => dot("anchor", { x, y }, 4)).join("")}`;
}

/** The inputs of a linear(), 0 to 1. @param {string} css @returns {[number][]} */
function stopsOf(css) {
  const items = css.slice(css.indexOf("(") + 1, -1).split(",");
  return items.map((item, i) => {
    const percent = /([\d.]+)%/.exec(item);
    return [percent ? Number(percent[1]) / 100 : i / (items.length - 1)];
  });
}

/** By the names of the recipes. @type {Record<string, () => string>} */
const PICTURES = {
  "text-along-path": textAlongPath,
  "hit-testing": hitTesting,
  "simplify-stroke": simplifyStroke,
  "icon-intersections": iconIntersections,
  "boolean-operations": booleanOperations,
  "shape-builder": shapeBuilder,
  "exact-circle": exactCircle,
  "stroke-outline": strokeOutline,
  "brush-stroke": brushStroke,
  ink: () => path("fill", inkPicture()),
  "camera-flight": cameraFlight,
  "stl-for-printing": vase,
  "easing-to-linear": easingToLinear,
};

/** The picture of a recipe as an SVG. @param {string} name */
export function recipePicture(name) {
  if (name === "teapot-three" || name === "vase")
    return surfacePoster(name === "vase" ? { id: "vase-surface", up: "y" } : { model: "teapot" })
      .replace(/role="img" aria-label="[^"]*"/, 'aria-hidden="true"')
      .replace('stroke="currentColor" stroke-opacity="0.6"', 'class="line thin"');
  const picture = PICTURES[name];
  if (!picture) throw new Error(`expected a picture of the recipe ${name} in www/build/recipe-pictures.js`);
  return `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" aria-hidden="true">${picture()}</svg>`;
}
