import { Path, Spline } from "casteljau";
import { positionIn } from "./draggable.js";

const svg = document.querySelector("#brush-stroke-picture");
const [area, line] = svg.children;
const form = svg.nextElementSibling;
const output = form.nextElementSibling;

/** What is there before you draw: a wave, with a pressure between 0 and 1. */
let samples = Array.from({ length: 61 }, (_, i) => ({
  x: 50 + 5 * i,
  y: 100 + 55 * Math.sin(i / 9),
  pressure: 0.55 + 0.45 * Math.cos(i / 5),
}));

function draw() {
  let length = 0;
  const lengths = samples.map(({ x, y }, i) => {
    if (i > 0) length += Math.hypot(x - samples[i - 1].x, y - samples[i - 1].y);
    return length;
  });
  const { width, taper } = form.elements;
  const stops = samples.map(({ pressure }, i) => {
    const position = length > 0 ? lengths[i] / length : 0;
    const end = taper.checked ? Math.min(1, 5 * position, 5 * (1 - position)) : 1;
    return [position, width.value * pressure * end];
  });
  const points = samples.map(({ x, y }) => [x, y]);
  const spline =
    length > 0 ? Spline.fit(points, { tolerance: 0.5 }) : new Spline([points[0], points[0]], { degree: 1 });
  const brush = { stops: length > 0 ? stops : [[0, width.value / 2]], interpolation: "smooth" };
  const outline = Path.from(spline).stroke(brush, { join: "round", cap: "round", tolerance: 0.1 }).simplify(0.15);
  area.setAttribute("d", outline.toSVG());
  line.setAttribute("d", spline.toSVG());
  const segments = outline.subpaths.reduce((sum, subpath) => sum + subpath.segmentCount, 0);
  output.textContent = `${samples.length} points, an outline of ${segments} segments`;
}

/** Pens report their pressure; for a mouse or a finger, slow is thick. */
function add(event) {
  const { x, y } = positionIn(svg, event);
  const last = samples.at(-1);
  const step = last ? Math.hypot(x - last.x, y - last.y) : 0;
  if (last && step < 1) return;
  const slow = Math.max(0.15, 1 - step / 16);
  const pressure = event.pointerType === "pen" ? event.pressure : last ? 0.7 * last.pressure + 0.3 * slow : 0.6;
  samples.push({ x, y, pressure });
}

svg.addEventListener("pointerdown", (event) => {
  svg.setPointerCapture(event.pointerId);
  samples = [];
  add(event);
  draw();
});
svg.addEventListener("pointermove", (event) => {
  if (!svg.hasPointerCapture(event.pointerId)) return;
  for (const each of event.getCoalescedEvents()) add(each);
  draw();
});
form.addEventListener("input", draw);
form.querySelector("button").addEventListener("click", () => {
  const picture = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 200"><path d="${area.getAttribute("d")}"/></svg>`;
  const url = URL.createObjectURL(new Blob([picture], { type: "image/svg+xml" }));
  Object.assign(document.createElement("a"), { href: url, download: "stroke.svg" }).click();
  URL.revokeObjectURL(url);
});
draw();
