// <surface-side for="id">: the same patch with its triangles wound the other way.
import { exchanged } from "./lib/surfaces.js";
import { LinkedFigure } from "./lib/linked-figure.js";

class SurfaceSide extends LinkedFigure {
  build() {
    this.setAttribute("role", "group");
    this.setAttribute("aria-label", "Winding");
    const buttons = [
      ["with ∂u × ∂v", false],
      ["against it", true],
    ].map(([title, against]) => {
      const made = Object.assign(document.createElement("button"), {
        type: "button",
        textContent: title,
        ariaPressed: String(!against),
      });
      made.addEventListener("click", () => {
        if (made.ariaPressed === "true") return;
        buttons.forEach((each) => (each.ariaPressed = String(each === made)));
        const target = this.target;
        target.surface = exchanged(target.surface);
        target.dispatchEvent(new Event("change", { bubbles: true, composed: true }));
      });
      return made;
    });
    this.append(...buttons);
  }
}

customElements.define("surface-side", SurfaceSide);
