import { Path } from "casteljau";
import { draggablePoints } from "./draggable.js";

const heart = Path.fromSVG(
  "M160 180C80 120 70 70 105 45C130 28 152 42 160 66C168 42 190 28 215 45C250 70 240 120 160 180Z",
);
const star = Path.polygon(
  Array.from({ length: 10 }, (_, i) => {
    const [radius, angle] = [i % 2 ? 32 : 75, (i * Math.PI) / 5 - Math.PI / 2];
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  }),
);

const svg = document.querySelector("#icon-intersections-picture");
const [heartPath, starPath] = svg.querySelectorAll("path");
heartPath.setAttribute("d", heart.toSVG());

function draw() {
  const moved = star.transform([1, 0, 0, 1, ...points()[0]]);
  const found = heart.intersections(moved);
  starPath.setAttribute("d", moved.toSVG());
  svg.querySelector("g").innerHTML = found
    .map(({ point }) => `<circle class="mark" cx="${point.x}" cy="${point.y}" r="5"/>`)
    .join("");
  svg.nextElementSibling.textContent = `${found.length} intersections`;
}

const points = draggablePoints(svg, draw);
draw();
