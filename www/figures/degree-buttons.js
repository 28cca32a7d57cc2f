// <degree-buttons for="id">: raises and lowers the degree of an applet's curve: the same curve, as long as that is possible.
import { Curve } from "casteljau";
import { button, element } from "../parts/dom.js";
import { LinkedFigure } from "./lib/linked-figure.js";

/** With a degree above this one handles lie on each other. */
const MAX_DEGREE = 16;
const MIN_DEGREE = 2;
/** What reduction may change, in the units of the picture, without being called a change. */
const UNCHANGED_PX = 0.01;
const UNCHANGED = "The curve has not changed.";

class DegreeButtons extends LinkedFigure {
  #raise = button("Raise the degree", () => this.#show(this.#curve.elevate(), UNCHANGED));
  #lower = button("Lower the degree", () => this.#reduce());
  #summary = element("span", {});

  build() {
    this.classList.add("controls");
    this.#summary.setAttribute("role", "status");
    this.append(this.#raise, this.#lower, this.#summary);
  }

  follow() {
    const { degree } = this.#curve;
    this.#raise.disabled = degree >= MAX_DEGREE;
    this.#lower.disabled = degree <= MIN_DEGREE;
  }

  get #curve() {
    return new Curve(this.target.points);
  }

  #reduce() {
    const { curve, error } = this.#curve.reduce();
    this.#show(curve, error < UNCHANGED_PX ? UNCHANGED : `The curve has moved by up to ${error.toFixed(1)} px.`);
  }

  /** @param {Curve} curve @param {string} text */
  #show(curve, text) {
    const flat = curve.controlPoints();
    this.target.points = Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);
    this.#summary.textContent = `Degree ${curve.degree}. ${text}`;
    this.follow();
  }
}

customElements.define("degree-buttons", DegreeButtons);
