import { Curve } from "casteljau";
import { draggablePoints } from "./draggable.js";

const TEXT = "Each letter stands upright on the curve.";
const svg = document.querySelector("#text-along-path-picture");
const letters = [...TEXT].map((letter) => {
  const text = document.createElementNS(svg.namespaceURI, "text");
  text.textContent = letter.replace(" ", "\u00a0");
  svg.querySelector("g").append(text);
  return { text, width: text.getComputedTextLength() };
});

function draw() {
  const curve = new Curve(points());
  const length = curve.length();
  svg.querySelector("path").setAttribute("d", curve.toSVG());
  let start = 0;
  for (const { text, width } of letters) {
    const { point, tangent } = curve.pointAtLength(start + width / 2);
    const angle = (Math.atan2(tangent.y, tangent.x) * 180) / Math.PI;
    text.setAttribute("transform", `translate(${point.x} ${point.y}) rotate(${angle}) translate(${-width / 2} -5)`);
    start += width;
    text.style.visibility = start > length ? "hidden" : "visible";
  }
}

const points = draggablePoints(svg, draw);
draw();
