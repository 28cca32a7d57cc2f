// <surface-side for="id">: the same patch with its triangles wound the other way.
import { exchanged } from "./surfaces.js";

class SurfaceSide extends HTMLElement {
  connectedCallback() {
    if (this.childNodes.length > 0) return;
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
        const target = /** @type {any} */ (document.getElementById(this.getAttribute("for") ?? ""));
        target.surface = exchanged(target.surface);
        target.dispatchEvent(new Event("change", { bubbles: true, composed: true }));
      });
      return made;
    });
    this.append(...buttons);
  }
}

customElements.define("surface-side", SurfaceSide);
