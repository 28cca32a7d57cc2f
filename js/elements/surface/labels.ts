// Names in the picture: of the control points, of the directions u and v, of the derivatives and the normal.
import { placeOf } from "./camera.js";
import { arrowsAt } from "./arrows.js";
import { patchesOf } from "./patches.js";
import type { Patch } from "../../surfaces.js";
import type { CameraMatrices } from "./camera.js";
import type { Scene } from "./geometry.js";

export type Label = {
  text: string;
  index: string;
  role: "point" | "axis" | "u" | "v" | "normal";
  at: ArrayLike<number>;
  from?: ArrayLike<number>;
};

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
  #labels: Label[] = [];
  #texts: SVGTextElement[] = [];
  #axes;
  #scene: Scene | null = null;

  constructor(overlay: HTMLElement) {
    const page = overlay.ownerDocument;
    this.#svg = page.createElementNS(SVG, "svg");
    this.#svg.setAttribute("class", "names");
    this.#svg.setAttribute("aria-hidden", "true"); // the handles have these names, too
    this.#axes = page.createElementNS(SVG, "path");
    this.#svg.append(this.#axes);
    overlay.prepend(this.#svg);
  }

  update(scene: Scene) {
    if (scene === this.#scene) return;
    this.#scene = scene;
    this.#labels = scene.settings.layers.has("names") ? labelsOf(scene) : [];
    this.#texts = this.#labels.map(({ text, index, role }) => this.#text(text, index, role));
    this.#svg.replaceChildren(this.#axes, ...this.#texts);
    if (this.#labels.length === 0) this.#axes.setAttribute("d", "");
  }

  #text(text: string, index: string, role: string) {
    const page = this.#svg.ownerDocument;
    const [made, below] = [page.createElementNS(SVG, "text"), page.createElementNS(SVG, "tspan")];
    made.setAttribute("class", role);
    below.setAttribute("dy", "0.3em");
    below.setAttribute("class", "index");
    below.textContent = index;
    made.append(text, below);
    return made;
  }

  /** Puts the names where their points are seen. */
  place(matrices: CameraMatrices) {
    const axes = this.#labels.map(({ role, at, from }, k) => {
      const end = placeOf(matrices, at, 0);
      const text = this.#texts[k];
      text.setAttribute("visibility", end ? "visible" : "hidden");
      if (!end) return "";
      const isLeft = role === "point" && end[0] > matrices.width - NAME_WIDTH_PX; // otherwise the edge would cut it off
      const [dx, dy] = role === "axis" ? [-4, 5] : [isLeft ? -OFFSET_X_PX : OFFSET_X_PX, OFFSET_Y_PX];
      text.setAttribute("text-anchor", isLeft ? "end" : "start");
      text.setAttribute("x", (end[0] + dx).toFixed(1));
      text.setAttribute("y", (end[1] + dy).toFixed(1));
      const start = from && placeOf(matrices, from, 0);
      return start ? arrowPath(start, end) : "";
    });
    this.#axes.setAttribute("d", axes.join(""));
  }
}

function labelsOf({ surface, picked, sphere, settings: { layers, u, v } }: Scene): Label[] {
  const patch = patchesOf(surface)[picked ?? 0];
  if (!patch || (picked === null && !layers.has("derivatives"))) return [];
  const points = patch.controlPoints();
  const named = layers.has("net") && points.length / 3 <= MAX_NAMED_POINTS;
  return [
    ...(named ? pointLabels(points, patch.degreeU + 1) : []),
    ...(named || (layers.has("place") && !layers.has("derivatives")) ? axisLabels(patch) : []),
    ...(layers.has("derivatives") ? vectorLabels(patch, u, v, sphere.radius) : []),
  ];
}

/** P_ij: i counts along u, within a row; j is the number of the row. */
function pointLabels(points: Float64Array, columns: number): Label[] {
  return Array.from({ length: points.length / 3 }, (_, k) => ({
    text: "P",
    index: `${k % columns}${Math.floor(k / columns)}`,
    role: "point",
    at: points.slice(3 * k, 3 * k + 3),
  }));
}

/** Arrows beside the first row and the first column of the net. */
function axisLabels(patch: Patch): Label[] {
  const [n, m, points] = [patch.degreeU, patch.degreeV, patch.controlPoints()];
  const at = (i: number, j: number) => {
    const k = 3 * (j * (n + 1) + i);
    return points.subarray(k, k + 3);
  };
  const axis = (text: string, end: Float64Array, beside: Float64Array, steps: number) => {
    const along = (t: number) =>
      at(0, 0).map((x, k) => x + t * (end[k] - x) + (AXIS_DISTANCE / steps) * (x - beside[k]));
    return [
      { text: "", index: "", role: "axis", at: along(AXIS_END), from: along(0.02) },
      { text, index: "", role: "axis", at: along(AXIS_LETTER) },
    ] as Label[];
  };
  return [...axis("u", at(n, 0), at(0, m), m), ...axis("v", at(0, m), at(n, 0), n)];
}

/** The names stand at the tips of the arrows. */
function vectorLabels(patch: Patch, u: number, v: number, radius: number): Label[] {
  const arrows = arrowsAt(patch, u, v, radius);
  const tip = (arrow: Float32Array) => arrow.subarray(3, 6);
  const named: [Float32Array, string, string, Label["role"]][] = [
    [arrows.u, "S", "u", "u"],
    [arrows.v, "S", "v", "v"],
    [arrows.normal, "N", "", "normal"],
  ];
  return named
    .filter(([arrow]) => arrow.length > 0)
    .map(([arrow, text, index, role]) => ({ text, index, role, at: tip(arrow) }));
}

function arrowPath([x0, y0]: [number, number], [x1, y1]: [number, number]) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < ARROW_HEAD_PX) return "";
  const [dx, dy] = [((x1 - x0) / length) * ARROW_HEAD_PX, ((y1 - y0) / length) * ARROW_HEAD_PX];
  const stroke = (side: number) =>
    `M${(x1 - dx - 0.45 * side * dy).toFixed(1)} ${(y1 - dy + 0.45 * side * dx).toFixed(1)}L${x1.toFixed(1)} ${y1.toFixed(1)}`;
  return `M${x0.toFixed(1)} ${y0.toFixed(1)}L${x1.toFixed(1)} ${y1.toFixed(1)}${stroke(1)}${stroke(-1)}`;
}
