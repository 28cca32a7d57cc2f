import { Spline } from "casteljau";
import { positionIn } from "./draggable.js";

const svg = document.querySelector("#simplify-stroke-picture");
const [polyline, path, joints] = svg.children;
const form = svg.nextElementSibling;
const output = form.nextElementSibling;
const tolerance = form.querySelector("input");

/** What is there before you draw: a wave with the noise of a hand. */
let points = Array.from({ length: 121 }, (_, i) => [
  20 + 3 * i,
  100 + 60 * Math.sin(i / 14) + 1.2 * Math.sin(i * 2.7) + 0.8 * Math.cos(i * 5.1),
]);

function draw() {
  polyline.setAttribute("points", points.join(" "));
  if (points.length < 2) return;
  const spline = Spline.fit(points, { tolerance: Number(tolerance.value) });
  path.setAttribute("d", spline.toSVG());
  const ends = Array.from({ length: spline.segmentCount + 1 }, (_, k) => spline.eval(k));
  joints.innerHTML = ends.map(({ x, y }) => `<circle class="mark" cx="${x}" cy="${y}" r="4"/>`).join("");
  output.textContent = `${points.length} points, ${spline.segmentCount} cubic segments`;
}

function add(event) {
  const { x, y } = positionIn(svg, event);
  points.push([x, y]);
}

svg.addEventListener("pointerdown", (event) => {
  svg.setPointerCapture(event.pointerId);
  points = [];
  add(event);
  draw();
});
svg.addEventListener("pointermove", (event) => {
  if (!svg.hasPointerCapture(event.pointerId)) return;
  for (const each of event.getCoalescedEvents()) add(each);
  draw();
});
tolerance.addEventListener("input", draw);
draw();
