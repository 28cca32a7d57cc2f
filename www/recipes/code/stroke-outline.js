import { Path, Spline } from "casteljau";
import { draggablePoints } from "./draggable.js";

const DASHES = [45, 40];
const svg = document.querySelector("#stroke-outline-picture");
const form = svg.nextElementSibling;
const [area, line] = svg.querySelectorAll("path");

/** A corner at the second point, a smooth curve from there to the last one. */
function pathThrough([a, b, c, d]) {
  return Path.from(
    Spline.fromCurves(
      [new Spline([a, b], { degree: 1 }), Spline.interpolate([b, c, d])].flatMap((spline) => spline.segments()),
    ),
  );
}

function draw() {
  const { width, join, cap, dashed } = form.elements;
  const path = pathThrough(points());
  const drawn = dashed.checked ? path.dash(DASHES) : path;
  const outline = drawn.stroke(Number(width.value), { join: join.value, cap: cap.value, tolerance: 0.05 });
  area.setAttribute("d", outline.toSVG({ precision: 2 }));
  line.setAttribute("d", drawn.toSVG());
  form.nextElementSibling.textContent = `Contours: ${outline.subpaths.length}, area: ${Math.round(Math.abs(outline.area()))}`;
}

const points = draggablePoints(svg, draw);
form.addEventListener("input", draw);
draw();
