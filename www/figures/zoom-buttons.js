// <zoom-buttons for="id">: enlarges an applet's picture about its point at t.
import { button } from "../parts/dom.js";
import { LinkedFigure } from "./lib/linked-figure.js";
import { viewAt } from "./lib/zoom.js";

const FACTORS = [1, 10, 1000, 1_000_000];

class ZoomButtons extends LinkedFigure {
  build() {
    this.classList.add("controls");
    this.append(...FACTORS.map((factor) => button(`${factor.toLocaleString("en")} ×`, () => this.#zoom(factor))));
  }

  /** @param {number} factor */
  #zoom(factor) {
    const { figure, t } = this.target;
    this.target.setAttribute("view", viewAt(factor, figure.pieces[0].curve.eval(t)));
  }
}

customElements.define("zoom-buttons", ZoomButtons);
