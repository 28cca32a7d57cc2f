// <unit-square for="id">: the square of all (u, v) beside the surface that it becomes.
import { arrowDirection } from "#js/ui/keys.js";
import { capture } from "#js/ui/capture.js";
import { element } from "../parts/dom.js";
import { svg } from "./lib/svg.js";
import { LinkedFigure } from "./lib/linked-figure.js";

const SIDE = 200;
const MARGIN = 24;
const LINES = 4;
const STEP = 0.01;

class UnitSquare extends LinkedFigure {
  #mark = svg(
    "g",
    { class: "hand" },
    svg("circle", { r: 22, fill: "transparent" }),
    svg("path", { d: "M0 -8 8 0 0 8 -8 0Z", class: "mark" }),
  );
  #ofU = svg("path", { class: "of-u" });
  #ofV = svg("path", { class: "of-v" });
  #words = element("p", { className: "note" });

  build() {
    const square = svg("rect", { x: 0, y: 0, width: SIDE, height: SIDE, class: "square" });
    const lines = Array.from({ length: LINES - 1 }, (_, k) => ((k + 1) * SIDE) / LINES);
    const grid = svg("path", { class: "grid", d: lines.map((x) => `M${x} 0V${SIDE}M0 ${x}H${SIDE}`).join("") });
    const words = /** @type {[string, number, number, string][]} */ ([
      ["0", -10, SIDE + 16, "end"],
      ["1", SIDE, SIDE + 16, "middle"],
      ["1", -8, 5, "end"],
      ["u", SIDE / 2, SIDE + 18, "middle"],
      ["v", -10, SIDE / 2 + 4, "end"],
    ]);
    const texts = words.map(([text, x, y, anchor]) =>
      svg("text", { x, y, "text-anchor": anchor, class: /[uv]/.test(text) ? "axis" : "" }, text),
    );
    const size = SIDE + 2 * MARGIN;
    const group = svg(
      "g",
      { transform: `translate(${MARGIN + 6} ${MARGIN / 2})` },
      square,
      grid,
      this.#ofU,
      this.#ofV,
      this.#mark,
      ...texts,
    );
    const picture = svg(
      "svg",
      {
        viewBox: `0 0 ${size} ${size}`,
        role: "img",
        tabindex: 0,
        "aria-label": "The unit square. Arrow keys move the place (u, v); the sliders do the same.",
      },
      group,
    );
    picture.addEventListener("pointerdown", (event) => this.#down(/** @type {PointerEvent} */ (event), square));
    picture.addEventListener("keydown", (event) => this.#key(/** @type {KeyboardEvent} */ (event)));
    this.#words.setAttribute("role", "status");
    this.append(picture, this.#words);
  }

  /** @param {number} u @param {number} v @param {"input" | "change"} type */
  #set(u, v, type) {
    const [a, b] = [u, v].map((x) => Math.round(100 * Math.min(Math.max(x, 0), 1)) / 100);
    Object.assign(this.target, { u: a, v: b });
    this.target.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  }

  /** @param {PointerEvent} event @param {SVGElement} square */
  #down(event, square) {
    if (event.button !== 0) return;
    const move = (/** @type {PointerEvent} */ { clientX, clientY }) => {
      const { left, bottom, width, height } = square.getBoundingClientRect();
      this.#set((clientX - left) / width, (bottom - clientY) / height, "input");
    };
    capture(event, { move, end: () => this.#set(this.target.u, this.target.v, "change") });
    move(event);
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const arrow = arrowDirection(event);
    if (!arrow || event.altKey) return;
    event.preventDefault();
    const step = event.shiftKey ? 10 * STEP : STEP;
    this.#set(this.target.u + step * arrow[0], this.target.v - step * arrow[1], "change");
  }

  follow() {
    const { u, v, place } = this.target?.figure ?? {};
    if (!place) return;
    const [x, y] = [u * SIDE, (1 - v) * SIDE];
    this.#mark.setAttribute("transform", `translate(${x} ${y})`);
    this.#ofU.setAttribute("d", `M${x} 0V${SIDE}`);
    this.#ofV.setAttribute("d", `M0 ${y}H${SIDE}`);
    this.#words.textContent = `S(${u}, ${v}) = (${place.point.map((/** @type {number} */ c) => c.toFixed(2).replace("-", "−")).join(", ")})`;
  }
}

customElements.define("unit-square", UnitSquare);
