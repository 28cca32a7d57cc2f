// <curve-target points="x,y x,y …"><bezier-applet …></bezier-applet></curve-target>: a dashed curve over an applet, to be matched.
import { Curve } from "casteljau";
import { svg } from "./lib/svg.js";

/** The applet's picture, in its own units. */
const VIEW_BOX = "0 0 670 480";

class CurveTarget extends HTMLElement {
  connectedCallback() {
    if (this.querySelector(":scope > svg")) return;
    const points = (this.getAttribute("points") ?? "").split(/\s+/).map((pair) => pair.split(",").map(Number));
    const path = svg("path", { d: new Curve(/** @type {[number, number][]} */ (points)).toSVG() });
    this.append(svg("svg", { viewBox: VIEW_BOX, "aria-hidden": "true" }, path));
  }
}

customElements.define("curve-target", CurveTarget);
