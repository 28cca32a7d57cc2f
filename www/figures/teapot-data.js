// <teapot-data for="id">: the sixteen numbers of a patch, the points behind them, and which of them other patches use, too.
import { Surface } from "casteljau";
import { element } from "../parts/dom.js";
import { slider } from "./lib/svg.js";
import { LinkedFigure } from "./lib/linked-figure.js";

class TeapotData extends LinkedFigure {
  #teapot = Surface.teapot();
  #nets = this.#teapot.patches;
  #points = this.#teapot.vertices;
  #uses = countUses(this.#nets);
  #body = element("tbody");
  #words = element("p", { className: "note" });

  build() {
    const control = slider("Patch", { min: 0, max: this.#nets.length - 1, step: 1, value: 4, name: "patch" }, (k) =>
      this.#fill(k, true),
    );
    const caption = element(
      "p",
      { className: "note" },
      "The sixteen numbers of a patch, a row for each row of its net, and the point that each number stands for. Bold: other patches use it, too.",
    );
    const scroll = element(
      "div",
      { className: "scroll", tabIndex: "0", role: "group", ariaLabel: "Control points of a patch" },
      element("table", {}, this.#body),
    );
    this.#words.setAttribute("role", "status");
    this.append(control.line, caption, scroll, this.#words);
    this.#fill(4, false);
  }

  /** @param {number} k @param {boolean} pick whether the figure beside picks the patch, too */
  #fill(k, pick) {
    const net = Array.from(this.#nets[k]);
    const cell = (/** @type {number} */ vertex) => {
      const at = [...this.#points.slice(3 * vertex, 3 * vertex + 3)]
        .map((x) => String(Number(x.toFixed(5))).replace("-", "−"))
        .join(", ");
      return element(
        "td",
        {},
        element(this.#uses[vertex] > 1 ? "b" : "span", {}, String(vertex)),
        element("small", {}, at),
      );
    };
    this.#body.replaceChildren(...[0, 1, 2, 3].map((j) => element("tr", {}, ...net.slice(4 * j, 4 * j + 4).map(cell))));
    const shared = new Set(net.filter((vertex) => this.#uses[vertex] > 1)).size;
    this.#words.textContent = `Patch ${k}: ${new Set(net).size} different points, ${shared} of them shared.`;
    if (pick && this.target) this.target.patch = k;
  }
}

/** How many patches use each vertex. @param {ArrayLike<ArrayLike<number>>} nets */
function countUses(nets) {
  /** @type {Record<number, number>} */
  const uses = {};
  for (const net of Array.from(nets))
    for (const vertex of new Set(Array.from(net))) uses[vertex] = (uses[vertex] ?? 0) + 1;
  return uses;
}

customElements.define("teapot-data", TeapotData);
