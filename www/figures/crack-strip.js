// <crack-strip>: the side that two patches share, divided by each of them.
import { Curve } from "casteljau";
import { element } from "../parts/dom.js";
import { chain, slider, svg } from "./lib/svg.js";
import { LinkedFigure } from "./lib/linked-figure.js";

const [WIDTH, HEIGHT] = [420, 300];
/** The common side, from below. */
const SIDE = new Curve([
  [200, 300],
  [330, 210],
  [60, 100],
  [230, 0],
]);
const MOST = 12;

/** The side's chords. @param {number} segments @returns {[number, number][]} */
function cut(segments) {
  const flat = SIDE.sample(segments);
  return Array.from({ length: segments + 1 }, (_, k) => [flat[2 * k], flat[2 * k + 1]]);
}

/** How far two chains of chords of one curve are apart, at the same parameter. Between two cuts of either the way is straight: looking at the cuts and amid them is enough. @param {number} a @param {number} b */
export function gapBetween(a, b) {
  const at = (/** @type {[number, number][]} */ points, /** @type {number} */ t) => {
    const n = points.length - 1;
    const k = Math.min(Math.floor(t * n), n - 1);
    const s = t * n - k;
    return [0, 1].map((i) => points[k][i] + s * (points[k + 1][i] - points[k][i]));
  };
  const [left, right] = [cut(a), cut(b)];
  const ts = Array.from({ length: 2 * a * b + 1 }, (_, k) => k / (2 * a * b));
  return Math.max(...ts.map((t) => Math.hypot(...at(left, t).map((x, i) => x - at(right, t)[i]))));
}

class CrackStrip extends LinkedFigure {
  #left = 4;
  #right = 3;
  #polygons = {
    left: svg("polygon", { class: "left" }),
    right: svg("polygon", { class: "right" }),
    gap: svg("rect", { width: WIDTH, height: HEIGHT, class: "gap" }),
  };
  #dots = { left: svg("g", { class: "dots left" }), right: svg("g", { class: "dots right" }) };
  #words = element("p", { className: "note" });

  build() {
    const { gap, left, right } = this.#polygons;
    const curve = svg("polyline", { points: chain(cut(64)), class: "curve" });
    this.append(
      svg(
        "svg",
        {
          viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
          role: "img",
          "aria-label": "Two meshes side by side and the gap between them",
        },
        gap,
        left,
        right,
        curve,
        this.#dots.left,
        this.#dots.right,
      ),
    );
    const control = (/** @type {"left" | "right"} */ name, /** @type {number} */ value) =>
      slider(
        name === "left" ? "Left patch" : "Right patch",
        { min: 1, max: MOST, step: 1, value, name },
        (count, type) => {
          if (name === "left") this.left = count;
          else this.right = count;
          this.dispatchEvent(new Event(type, { bubbles: true }));
        },
      );
    this.#knobs = { left: control("left", this.#left), right: control("right", this.#right) };
    this.#words.setAttribute("role", "status");
    this.append(this.#knobs.left.line, this.#knobs.right.line, this.#words);
    this.#draw();
  }

  /** @type {Record<"left" | "right", ReturnType<typeof slider>> | null} */ #knobs = null;

  /** Segments of the left patch along the side. */
  get left() {
    return this.#left;
  }

  set left(count) {
    this.#left = count;
    this.#draw();
  }

  /** Segments of the right patch along the side. */
  get right() {
    return this.#right;
  }

  set right(count) {
    this.#right = count;
    this.#draw();
  }

  get figure() {
    return { left: this.#left, right: this.#right, gap: gapBetween(this.#left, this.#right) };
  }

  #draw() {
    if (!this.#knobs) return;
    const { left, right, gap } = this.figure;
    const edges = {
      left: /** @type {[number, number][]} */ ([
        [0, 0],
        [0, HEIGHT],
      ]),
      right: /** @type {[number, number][]} */ ([
        [WIDTH, 0],
        [WIDTH, HEIGHT],
      ]),
    };
    for (const name of /** @type {const} */ (["left", "right"])) {
      const points = cut(name === "left" ? left : right);
      this.#polygons[name].setAttribute("points", chain([...edges[name], ...points]));
      this.#dots[name].replaceChildren(
        ...points.map(([x, y]) =>
          name === "left" ? svg("circle", { cx: x, cy: y, r: 6 }) : svg("circle", { cx: x, cy: y, r: 2.5 }),
        ),
      );
      this.#knobs[name].input.value = this.#knobs[name].output.textContent = String(name === "left" ? left : right);
    }
    this.#words.textContent =
      gap < 1e-9
        ? "Both meshes have the same vertices along the side. There is no crack."
        : `The crack is up to ${gap.toFixed(1)} units wide. ${left % right === 0 || right % left === 0 ? "Every vertex of the coarser mesh is also a vertex of the finer one." : "Most vertices of one mesh are not vertices of the other."}`;
  }
}

customElements.define("crack-strip", CrackStrip);
