// <teapot-data for="id">: the listing of the teapot as published, with 306 vertices: the sixteen vertex numbers of a patch,
// the vertices, and which of them other patches use, too.
import listing from "../../tests/data/teapot.json" with { type: "json" };
import { element } from "../parts/dom.js";
import { slider } from "./lib/svg.js";
import { LinkedFigure } from "./lib/linked-figure.js";

class TeapotData extends LinkedFigure {
  #nets = listing.patches;
  #uses = countUses(this.#nets);
  #body = element("tbody");
  #words = element("p", { className: "note" });

  build() {
    const control = slider(
      "Patch",
      { min: 0, max: this.#nets.length - 1, step: 1, value: 4, name: "patch" },
      (k, type) => {
        this.#fill(k);
        this.setTarget({ patch: k }, type);
      },
    );
    const caption = element(
      "p",
      { className: "note" },
      `The sixteen point numbers of a patch, from 1 to ${listing.vertices.length} as published, and the coordinates of each point. Numbers in bold are used by other patches, too.`,
    );
    const scroll = element(
      "div",
      { className: "scroll", tabIndex: "0", role: "group", ariaLabel: "Control points of a patch" },
      element("table", {}, this.#body),
    );
    this.#words.setAttribute("role", "status");
    this.append(control.line, caption, scroll, this.#words);
    this.#fill(4);
  }

  /** @param {number} k */
  #fill(k) {
    const net = this.#nets[k];
    const cell = (/** @type {number} */ vertex) => {
      const at = listing.vertices[vertex].map((x) => String(Number(x.toFixed(5))).replace("-", "−")).join(", ");
      return element(
        "td",
        {},
        element(this.#uses[vertex] > 1 ? "b" : "span", {}, String(vertex + 1)),
        element("small", {}, at),
      );
    };
    this.#body.replaceChildren(...[0, 1, 2, 3].map((j) => element("tr", {}, ...net.slice(4 * j, 4 * j + 4).map(cell))));
    const shared = new Set(net.filter((vertex) => this.#uses[vertex] > 1)).size;
    this.#words.textContent = `Patch ${k}: ${new Set(net).size} different control points, ${shared} of them shared with other patches.`;
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
