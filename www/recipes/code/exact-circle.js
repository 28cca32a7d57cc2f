import { NurbsCurve } from "casteljau/nurbs";
import { draggablePoints } from "./draggable.js";

const TOLERANCE = 0.1; // of the canvas, in its pixels
const svg = document.querySelector("#exact-circle-picture");
const canvas = svg.nextElementSibling;
const output = svg.parentElement.nextElementSibling;
const context = canvas.getContext("2d");
const scale = canvas.width / svg.viewBox.baseVal.width;

function draw() {
  const [center, point] = points();
  const radius = Math.hypot(point[0] - center[0], point[1] - center[1]);
  const circle = NurbsCurve.circle(center, radius);

  // SVG has arcs, so its path is exact.
  const d = circle.toSVG({ precision: 1 });
  svg.querySelector("path").setAttribute("d", d);

  // trace() draws cubics. What it draws is within the tolerance.
  const enlarged = circle.transform(`scale(${scale})`);
  context.strokeStyle = getComputedStyle(canvas).color;
  context.lineWidth = 2 * scale;
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.beginPath();
  enlarged.trace(context, { tolerance: TOLERANCE });
  context.stroke();

  const { segmentCount } = enlarged.toSpline({ tolerance: TOLERANCE });
  output.textContent = `SVG: ${d}. Canvas: ${segmentCount} cubics within ${TOLERANCE} pixels. Length: ${circle.length().toFixed(6)}, 2πr: ${(2 * Math.PI * radius).toFixed(6)}`;
}

const points = draggablePoints(svg, draw);
draw();
