// A timing function with two handles, and a ball that follows it.
import { easing } from "casteljau/easing";
import { animate, find, makeDraggable, setAttributes } from "../picture.js";
import { FIRST_CURVE, graphOf, valueAt, yOf } from "./graph.js";

const [MOVE_MS, REST_MS] = [1100, 600];
const HALF_MS = MOVE_MS + REST_MS;

const box = find('[data-thing="easing"]');
const svg = find("svg", box);
const ball = find(".ball", svg);
const text = find("code", box);
const curve = [...FIRST_CURVE];
let ease = easing("linear");

function draw() {
  const { points, levers, path, css } = graphOf(curve);
  for (const [i, mark] of marks.entries()) setAttributes(mark, { cx: points[i][0], cy: points[i][1] });
  find(".lever", svg).setAttribute("d", levers);
  find(".line", svg).setAttribute("d", path);
  text.textContent = css;
  ease = easing(css);
}

/** @type {SVGElement[]} */
const marks = [...svg.querySelectorAll(".handle")];
for (const [i, mark] of marks.entries())
  makeDraggable(svg, mark, {
    label: `Handle ${i + 1} of the timing function`,
    position: () => graphOf(curve).points[i],
    move(x, y) {
      curve.splice(2 * i, 2, ...valueAt(x, y));
      draw();
    },
  });
draw();

animate(svg, box, (ms) => {
  if (ms === 0) return; // with reduced motion the ball stays at the end
  const time = ms % (2 * HALF_MS);
  const value = ease(Math.min(1, (time % HALF_MS) / MOVE_MS));
  ball.setAttribute("cy", yOf(time < HALF_MS ? value : 1 - value).toFixed(1));
});
