// <surface-side for="id">: the same patch with u and v exchanged: its triangles run the other way round.
import { exchanged } from "./lib/surfaces.js";
import { LinkedFigure } from "./lib/linked-figure.js";

class SurfaceSide extends LinkedFigure {
  build() {
    this.setAttribute("role", "group");
    this.setAttribute("aria-label", "Order of u and v");
    const buttons = [
      ["Original", false],
      ["u and v exchanged", true],
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
