// A dashed curve over an applet, to be matched: <div class="target" data-target="x,y x,y …"><bezier-applet …></div>.
import { Curve } from "casteljau";

/** The applet's picture, in its own units. */
const BOX = "0 0 670 480";
const SVG = "http://www.w3.org/2000/svg";

/** @param {ParentNode} root */
export function layTargets(root) {
  for (const frame of /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll("[data-target]"))) {
    const points = (frame.dataset.target ?? "").split(/\s+/).map((pair) => pair.split(",").map(Number));
    const picture = document.createElementNS(SVG, "svg");
    picture.setAttribute("viewBox", BOX);
    picture.setAttribute("aria-hidden", "true");
    const path = document.createElementNS(SVG, "path");
    path.setAttribute("d", new Curve(points).toSVG());
    picture.append(path);
    frame.append(picture);
  }
}
