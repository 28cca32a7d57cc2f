import { Path } from "casteljau";
import { draggablePoints, positionIn } from "./draggable.js";

const STROKE_WIDTH = 16; // as wide as a finger needs
const heart = Path.fromSVG(
  "M100 180C20 120 10 70 45 45C70 28 92 42 100 66C108 42 130 28 155 45C190 70 180 120 100 180Z",
);
const curve = Path.fromSVG("M220 160C240 20 320 20 310 100S380 160 380 40");

const svg = document.querySelector("#hit-testing-picture");
const output = svg.nextElementSibling;
const [area, line, connection] = svg.querySelectorAll("path");
const [dot, handle] = svg.querySelectorAll("circle");
area.setAttribute("d", heart.toSVG());
line.setAttribute("d", curve.toSVG());

function test() {
  const [p] = points();
  const inside = heart.contains(p);
  const onCurve = curve.strokeContains(p, STROKE_WIDTH, { cap: "round" });
  const { point, distance } = curve.nearest(p);
  area.classList.toggle("hit", inside);
  line.classList.toggle("hit", onCurve);
  connection.setAttribute("d", `M${p}L${point.x},${point.y}`);
  dot.setAttribute("cx", point.x);
  dot.setAttribute("cy", point.y);
  const hit = inside ? "inside of the heart" : onCurve ? "on the curve" : "on neither";
  output.textContent = `The point is ${hit}; the curve is ${distance.toFixed(1)} units away.`;
}

const points = draggablePoints(svg, test);
svg.addEventListener("pointermove", (event) => {
  const { x, y } = positionIn(svg, event);
  handle.setAttribute("cx", x);
  handle.setAttribute("cy", y);
  test();
});
test();
