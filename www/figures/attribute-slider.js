// <attribute-slider for="id" attribute="segments" label="Segments" min="1" max="40" value="4">: a slider that sets an attribute of
// a figure. With power="2" the attribute is 2 to the power of the slider's position, so that every step is the same ratio.
import { element } from "../parts/dom.js";
import { LinkedFigure } from "./lib/linked-figure.js";

class AttributeSlider extends LinkedFigure {
  #input = document.createElement("input");
  #output = document.createElement("output");

  build() {
    this.#input.type = "range";
    for (const name of ["min", "max", "step"]) this.#input.setAttribute(name, this.getAttribute(name) ?? "1");
    for (const type of /** @type {const} */ (["input", "change"]))
      this.#input.addEventListener(type, () => this.setTarget({ [this.#attribute]: this.#value() }, type));
    this.append(
      element(
        "label",
        { className: "line" },
        element("span", {}, this.getAttribute("label") ?? ""),
        this.#input,
        this.#output,
      ),
    );
  }

  follow() {
    const value = Number(this.target[this.#attribute]);
    this.#input.value = String(this.#power ? Math.log(value) / Math.log(this.#power) : value);
    const text = String(Number(value.toPrecision(3)));
    this.#input.setAttribute("aria-valuetext", text);
    this.#output.textContent = text;
  }

  get #attribute() {
    return this.getAttribute("attribute") ?? "";
  }

  get #power() {
    return Number(this.getAttribute("power"));
  }

  #value() {
    const position = this.#input.valueAsNumber;
    return this.#power ? Number((this.#power ** position).toPrecision(6)) : position;
  }
}

customElements.define("attribute-slider", AttributeSlider);
