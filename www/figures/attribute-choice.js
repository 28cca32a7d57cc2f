// <attribute-choice for="id" attribute="basis" label="Basis" options="bezier: Bézier, hermite: Hermite">: radio buttons that set an
// attribute of a figure.
import { element, uniqueId } from "../parts/dom.js";
import { LinkedFigure } from "./lib/linked-figure.js";

class AttributeChoice extends LinkedFigure {
  /** @type {HTMLInputElement[]} */ #radios = [];

  build() {
    const attribute = this.getAttribute("attribute") ?? "";
    const name = uniqueId("choice");
    const labels = (this.getAttribute("options") ?? "").split(",").map((option) => {
      const [value, label] = option.split(":").map((part) => part.trim());
      const radio = Object.assign(document.createElement("input"), { type: "radio", name, value });
      radio.addEventListener("change", () => this.setTarget({ [attribute]: value }, "change"));
      this.#radios.push(radio);
      return element("label", {}, radio, label);
    });
    const legend = element("legend", {}, this.getAttribute("label") ?? "");
    this.append(element("fieldset", { className: "choice" }, legend, ...labels));
  }

  follow() {
    for (const radio of this.#radios) radio.checked = this.target[this.getAttribute("attribute") ?? ""] === radio.value;
  }
}

customElements.define("attribute-choice", AttributeChoice);
