import { Path } from "casteljau";
import { draggablePoints } from "./draggable.js";

// The outlines of two letters; the inner contour of the O runs the other way, so it is a hole.
const letterO = Path.fromSVG(
  "M80 100A85 85 0 0 1 250 100A85 85 0 0 1 80 100Z M115 100A50 62 0 0 0 215 100A50 62 0 0 0 115 100Z",
  { tolerance: 0.01 },
);
const letterT = Path.polygon([
  [-65, -80],
  [65, -80],
  [65, -48],
  [18, -48],
  [18, 80],
  [-18, 80],
  [-18, -48],
  [-65, -48],
]);

const svg = document.querySelector("#boolean-operations-picture");
const form = svg.nextElementSibling;
const operation = form.querySelector("select");
const [area, lineO, lineT] = svg.querySelectorAll("path");
lineO.setAttribute("d", letterO.toSVG());

function draw() {
  const moved = letterT.transform([1, 0, 0, 1, ...points()[0]]);
  const result = letterO[operation.value](moved);
  lineT.setAttribute("d", moved.toSVG());
  area.setAttribute("d", result.toSVG());
  form.nextElementSibling.textContent = `Contours: ${result.subpaths.length}, area: ${Math.round(Math.abs(result.area()))}`;
}

const points = draggablePoints(svg, draw);
operation.addEventListener("change", draw);
draw();
