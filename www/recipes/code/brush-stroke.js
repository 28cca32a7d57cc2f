import { InkStroke } from "casteljau";
import { positionIn } from "./draggable.js";

const svg = document.querySelector("#brush-stroke-picture");
const [area, line] = svg.children;
const form = svg.nextElementSibling;
const output = form.nextElementSibling;

/** What is there before you draw: a wave. */
let samples = Array.from({ length: 61 }, (_, i) => [50 + 5 * i, 100 + 55 * Math.sin(i / 9), {}]);

function draw() {
  const { size, taper } = form.elements;
  const ends = taper.checked ? { start: 40, end: 60 } : {};
  const ink = new InkStroke({ size: Number(size.value), taper: ends, thinning: 0.7 });
  for (const [x, y, sample] of samples) ink.append(x, y, sample);
  const outline = ink.outline();
  area.setAttribute("d", outline.toSVG({ precision: 2 }));
  line.setAttribute("d", ink.spline().toSVG());
  const segments = outline.subpaths.reduce((sum, subpath) => sum + subpath.segmentCount, 0);
  output.textContent = `${samples.length} points, an outline of ${segments} segments`;
}

function add(event) {
  const { x, y } = positionIn(svg, event);
  samples.push([x, y, { time: event.timeStamp }]);
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
