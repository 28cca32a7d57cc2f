// <patch-text for="id">: a patch file to write in, shown by a figure.
import { Surface } from "casteljau/surfaces";
import { button, element, uniqueId } from "../parts/dom.js";
import { LinkedFigure } from "./lib/linked-figure.js";

class PatchText extends LinkedFigure {
  #words = element("p", { className: "note" });

  build() {
    const text = (this.textContent ?? "").trim();
    const area = Object.assign(document.createElement("textarea"), {
      value: text,
      rows: text.split("\n").length,
      spellcheck: false,
      id: uniqueId("text"),
    });
    this.#words.setAttribute("role", "status");
    this.replaceChildren(
      Object.assign(element("label", {}, "A patch file"), { htmlFor: area.id }),
      area,
      button("Show it", () => this.#show(area.value)),
      this.#words,
    );
  }

  /** @param {string} text */
  #show(text) {
    const target = this.target;
    try {
      target.surface = Surface.parse(text);
      const { patchCount } = target.surface;
      this.#words.textContent = `Shown: ${patchCount === 1 ? "one patch" : `${patchCount} patches`}.`;
      target.dispatchEvent(new Event("change", { bubbles: true, composed: true }));
    } catch (error) {
      this.#words.textContent = error instanceof Error ? error.message : String(error);
    }
  }
}

customElements.define("patch-text", PatchText);
