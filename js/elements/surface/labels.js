// Names in the picture: of the control points, of the directions u and v, of the derivatives and the normal.
import { placeOf } from "./camera.js";
import { arrowsAt } from "./arrows.js";
import { patchesOf } from "./patches.js";

/**
 * @import { Patch } from "../../surfaces.js"
 * @import { Sight } from "./camera.js"
 * @import { Scene } from "./geometry.js"
 */

/** @typedef {{ text: string, index: string, role: "point" | "axis" | "u" | "v" | "normal", at: ArrayLike<number>, from?: ArrayLike<number> }} Label */

/** A net with more points is shown without names: they would cover each other. */
const MAX_NAMED_POINTS = 25;
/** Where a name stands beside its point, in pixels. */
const [OFFSET_X_PX, OFFSET_Y_PX] = [9, -9];
/** The room that a name needs to the right of its point. */
const NAME_WIDTH_PX = 34;
/** The arrows of u and v stand beside the net, at this part of the distance between its first two rows. */
const AXIS_DISTANCE = 0.45;
/** How much of a row an axis is long, and how far beyond its tip the letter stands. */
const [AXIS_END, AXIS_LETTER] = [0.42, 0.5];
const ARROW_HEAD_PX = 8;
const SVG = "http://www.w3.org/2000/svg";

export class Labels {
  #svg;
  /** @type {Label[]} */
  #labels = [];
  /** @type {SVGTextElement[]} */
  #texts = [];
  #axes;
  /** @type {Scene | null} */
  #scene = null;

  /** @param {HTMLElement} overlay */
  constructor(overlay) {
    const page = overlay.ownerDocument;
    this.#svg = page.createElementNS(SVG, "svg");
    this.#svg.setAttribute("class", "names");
    this.#svg.setAttribute("aria-hidden", "true"); // the handles have these names, too
    this.#axes = page.createElementNS(SVG, "path");
    this.#svg.append(this.#axes);
    overlay.prepend(this.#svg);
  }

  /** @param {Scene} scene */
  update(scene) {
    if (scene === this.#scene) return;
    this.#scene = scene;
    this.#labels = scene.settings.layers.has("names") ? labelsOf(scene) : [];
    this.#texts = this.#labels.map(({ text, index, role }) => this.#text(text, index, role));
    this.#svg.replaceChildren(this.#axes, ...this.#texts);
    if (this.#labels.length === 0) this.#axes.setAttribute("d", "");
  }

  /** @param {string} text @param {string} index @param {string} role */
  #text(text, index, role) {
    const page = this.#svg.ownerDocument;
    const [made, below] = [page.createElementNS(SVG, "text"), page.createElementNS(SVG, "tspan")];
    made.setAttribute("class", role);
    below.setAttribute("dy", "0.3em");
    below.setAttribute("class", "index");
    below.textContent = index;
    made.append(text, below);
    return made;
  }

  /**
   * Puts the names where their points are seen.
   *
   * @param {Sight} sight
   * @param {number} width
   * @param {number} height
   */
  place(sight, width, height) {
    const axes = this.#labels.map(({ role, at, from }, k) => {
      const end = placeOf(sight, at, 0, width, height);
      const text = this.#texts[k];
      text.setAttribute("visibility", end ? "visible" : "hidden");
      if (!end) return "";
      const isLeft = role === "point" && end[0] > width - NAME_WIDTH_PX; // otherwise the edge would cut it off
      const [dx, dy] = role === "axis" ? [-4, 5] : [isLeft ? -OFFSET_X_PX : OFFSET_X_PX, OFFSET_Y_PX];
      text.setAttribute("text-anchor", isLeft ? "end" : "start");
      text.setAttribute("x", (end[0] + dx).toFixed(1));
      text.setAttribute("y", (end[1] + dy).toFixed(1));
      const start = from && placeOf(sight, from, 0, width, height);
      return start ? arrowPath(start, end) : "";
    });
    this.#axes.setAttribute("d", axes.join(""));
  }
}

/** @param {Scene} scene @returns {Label[]} */
function labelsOf({ surface, picked, frame, settings: { layers, u, v } }) {
  const patch = patchesOf(surface)[picked ?? 0];
  if (!patch || (picked === null && !layers.has("derivatives"))) return [];
  const points = patch.controlPoints();
  const named = layers.has("net") && points.length / 3 <= MAX_NAMED_POINTS;
  return [
    ...(named ? pointLabels(points, patch.degreeU + 1) : []),
    ...(named || (layers.has("place") && !layers.has("derivatives")) ? axisLabels(patch) : []),
    ...(layers.has("derivatives") ? vectorLabels(patch, u, v, frame.radius) : []),
  ];
}

/**
 * P_ij: i counts along u, within a row; j is the number of the row.
 *
 * @param {Float64Array} points
 * @param {number} columns
 * @returns {Label[]}
 */
function pointLabels(points, columns) {
  return Array.from({ length: points.length / 3 }, (_, k) => ({
    text: "P",
    index: `${k % columns}${Math.floor(k / columns)}`,
    role: "point",
    at: points.slice(3 * k, 3 * k + 3),
  }));
}

/**
 * Arrows beside the first row and the first column of the net.
 *
 * @param {Patch} patch
 * @returns {Label[]}
 */
function axisLabels(patch) {
  const [n, m, points] = [patch.degreeU, patch.degreeV, patch.controlPoints()];
  const at = (/** @type {number} */ i, /** @type {number} */ j) => {
    const k = 3 * (j * (n + 1) + i);
    return points.subarray(k, k + 3);
  };
  const axis = (
    /** @type {string} */ text,
    /** @type {Float64Array} */ end,
    /** @type {Float64Array} */ beside,
    /** @type {number} */ steps,
  ) => {
    const along = (/** @type {number} */ t) =>
      at(0, 0).map((x, k) => x + t * (end[k] - x) + (AXIS_DISTANCE / steps) * (x - beside[k]));
    return /** @type {Label[]} */ ([
      { text: "", index: "", role: "axis", at: along(AXIS_END), from: along(0.02) },
      { text, index: "", role: "axis", at: along(AXIS_LETTER) },
    ]);
  };
  return [...axis("u", at(n, 0), at(0, m), m), ...axis("v", at(0, m), at(n, 0), n)];
}

/**
 * The names stand at the tips of the arrows.
 *
 * @param {Patch} patch
 * @param {number} u
 * @param {number} v
 * @param {number} radius
 * @returns {Label[]}
 */
function vectorLabels(patch, u, v, radius) {
  const arrows = arrowsAt(patch, u, v, radius);
  const tip = (/** @type {Float32Array} */ arrow) => arrow.subarray(3, 6);
  /** @type {[Float32Array, string, string, Label["role"]][]} */
  const named = [
    [arrows.u, "S", "u", "u"],
    [arrows.v, "S", "v", "v"],
    [arrows.normal, "N", "", "normal"],
  ];
  return named
    .filter(([arrow]) => arrow.length > 0)
    .map(([arrow, text, index, role]) => ({ text, index, role, at: tip(arrow) }));
}

/** @param {[number, number]} start @param {[number, number]} end */
function arrowPath([x0, y0], [x1, y1]) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < ARROW_HEAD_PX) return "";
  const [dx, dy] = [((x1 - x0) / length) * ARROW_HEAD_PX, ((y1 - y0) / length) * ARROW_HEAD_PX];
  const stroke = (/** @type {number} */ side) =>
    `M${(x1 - dx - 0.45 * side * dy).toFixed(1)} ${(y1 - dy + 0.45 * side * dx).toFixed(1)}L${x1.toFixed(1)} ${y1.toFixed(1)}`;
  return `M${x0.toFixed(1)} ${y0.toFixed(1)}L${x1.toFixed(1)} ${y1.toFixed(1)}${stroke(1)}${stroke(-1)}`;
}
