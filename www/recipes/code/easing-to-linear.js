import { easing } from "casteljau";
import { draggablePoints } from "./draggable.js";

const svg = document.querySelector("#easing-to-linear-picture");
const form = svg.nextElementSibling;
const [tolerance, button] = form.elements;
const [, , exact, approximation] = svg.querySelectorAll("path");
const ball = svg.querySelector(".mark");

/** The unit square is 200 by 160 units of the picture; progress points up. */
const toPicture = (x, y) => `${(100 + 200 * x).toFixed(1)},${(190 - 160 * y).toFixed(1)}`;
const graph = (f) => `M${Array.from({ length: 101 }, (_, i) => toPicture(i / 100, f(i / 100))).join("L")}`;

/** The two handles, x limited to 0 … 1 as CSS demands. */
function timingFunction() {
  const [x1, y1, x2, y2] = points().flatMap(([x, y]) => [Math.min(Math.max((x - 100) / 200, 0), 1), (190 - y) / 160]);
  return easing(x1, y1, x2, y2);
}

function draw() {
  const ease = timingFunction();
  const css = ease.toLinear(Number(tolerance.value));
  exact.setAttribute("d", graph(ease));
  approximation.setAttribute("d", graph(easing(css)));
  form.nextElementSibling.textContent = css;
}

button.addEventListener("click", () => {
  const keyframes = [{ transform: "none" }, { transform: "translateX(300px)" }];
  ball.animate(keyframes, { duration: 1500, easing: form.nextElementSibling.textContent });
});
const points = draggablePoints(svg, draw);
tolerance.addEventListener("input", draw);
draw();
