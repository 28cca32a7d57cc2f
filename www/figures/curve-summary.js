// <curve-summary for="id" kind="hermite">: a sentence about an applet: the "hermite" data of its cubic, or its subdivision "tree".
import { LinkedFigure } from "./lib/linked-figure.js";
import { hermiteSummary, treeSummary } from "./lib/summaries.js";

class CurveSummary extends LinkedFigure {
  build() {
    this.setAttribute("role", "status");
  }

  follow() {
    this.textContent =
      this.getAttribute("kind") === "tree" ? treeSummary(this.target.figure.tree) : hermiteSummary(this.target.points);
  }
}

customElements.define("curve-summary", CurveSummary);
