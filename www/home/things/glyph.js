// The outline of a letter: a closed spline of lines and cubics, whose smooth joints stay smooth while points move.
import { Curve, Spline } from "casteljau/core";
import { append, find, makeDraggable, setAttributes } from "../picture.js";

/** Joints that turn by less, in radians, stay smooth. */
const MAX_SMOOTH_ANGLE = 0.1;
/** The joint whose handles are shown first. */
const FIRST_JOINT = 5;

const svg = find('[data-thing="glyph"] svg');
const outline = find(".letter", svg);
const lever = find(".lever", svg);
const group = find(".marks", svg);

/** The curves of path data with absolute M, L, C and Z. @param {string} d */
function curvesOf(d) {
  /** @type {Curve[]} */
  const curves = [];
  /** @type {number[]} */
  let at = [];
  for (const [, command, rest] of d.matchAll(/([MLCZ])([^MLCZ]*)/g)) {
    const numbers = (rest.match(/-?[\d.]+/g) ?? []).map(Number);
    if (command === "M") at = numbers.splice(0, 2);
    const size = command === "C" ? 6 : 2;
    for (let i = 0; i < numbers.length; i += size) {
      const flat = [...at, ...numbers.slice(i, i + size)];
      curves.push(new Curve(flat));
      at = flat.slice(-2);
    }
  }
  return curves;
}

let spline = Spline.fromCurves(curvesOf(outline.getAttribute("d")), { closed: true });
const { segmentCount: count, degrees } = spline;
const isSmooth = degrees.map((_, k) => spline.continuity(k).angle < MAX_SMOOTH_ANGLE);
/** @type {Record<number, "g1">} */
const joints = Object.fromEntries(isSmooth.flatMap((smooth, k) => (smooth ? [[k, "g1"]] : [])));
/** The index of the control point at each joint. */
const indices = degrees.map((_, k) => degrees.slice(0, k).reduce((a, b) => a + b, 0));
const total = degrees.reduce((a, b) => a + b);
let selected = FIRST_JOINT;

/** The control points before and after a joint, or -1 beside a line. @param {number} k */
const handlesOf = (k) => [
  degrees[(k + count - 1) % count] > 1 ? (indices[k] + total - 1) % total : -1,
  degrees[k] > 1 ? indices[k] + 1 : -1,
];

/** @type {{ mark: SVGElement, index: () => number }[]} */
const marks = [];

function draw() {
  const points = spline.points();
  outline.setAttribute("d", spline.toSVG({ precision: 1 }));
  for (const { mark, index } of marks) {
    const point = points[index()];
    mark.style.display = point ? "" : "none";
    if (point) setAttributes(mark, { cx: point.x.toFixed(1), cy: point.y.toFixed(1) });
  }
  const joint = points[indices[selected]];
  const ends = handlesOf(selected).flatMap((i) => points[i] ?? []);
  lever.setAttribute("d", ends.map(({ x, y }) => `M${joint.x} ${joint.y}L${x} ${y}`).join(""));
}

/** @param {SVGElement} mark @param {string} label @param {() => number} index of the control point, or -1 */
function add(mark, label, index) {
  marks.push({ mark, index });
  makeDraggable(svg, mark, {
    label,
    position: () => {
      const { x, y } = spline.points()[index()];
      return [x, y];
    },
    move(x, y) {
      spline = spline.movePoint(index(), [x, y], { joints });
      draw();
    },
  });
}

for (const [k, smooth] of isSmooth.entries()) {
  if (!smooth) continue;
  const mark = append(group, "circle", { class: "anchor", r: 4.5 });
  mark.addEventListener("focus", () => {
    selected = k;
    draw();
  });
  add(mark, `Joint ${k + 1}, smooth`, () => indices[k]);
}
for (const [side, name] of ["before", "after"].entries())
  add(append(group, "circle", { class: "handle", r: 5 }), `Handle ${name} the joint`, () => handlesOf(selected)[side]);
draw();
