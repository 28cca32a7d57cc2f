// <surface-split for="id">: the parameter u at which the figure's patch is split.
import { halves } from "./lib/surfaces.js";
import { LinkedFigure } from "./lib/linked-figure.js";
import { slider } from "./lib/svg.js";

class SurfaceSplit extends LinkedFigure {
  build() {
    const range = { min: 0.1, max: 0.9, step: 0.05, value: 0.5, name: "split" };
    const { line, output } = slider("Split at u", range, (u, type) => {
      output.textContent = u.toFixed(2);
      this.setTarget({ surface: halves(u), patch: this.target.patch }, type);
    });
    output.textContent = "0.50";
    this.append(line);
  }
}

customElements.define("surface-split", SurfaceSplit);
