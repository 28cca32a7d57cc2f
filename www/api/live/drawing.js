// What an entry's figure shows: geometry is collected while a sample runs and written as SVG afterwards. It runs while the site is built,
// for the first picture, and in the browser.
import { flattened, Projection } from "./projection.js";

/**
 * @import { Point3, View } from "./projection.js"
 * @typedef {"main" | "second" | "third" | "result" | "faint"} Tone
 * @typedef {{ tone?: Tone, label?: string, closed?: boolean, dimension?: 2 | 3, lines?: number, thin?: boolean, rule?: "nonzero" | "evenodd" }} Style
 * @typedef {(projection: Projection) => string} Mark writes one item
 */

/** How many straight pieces show a graph. */
const GRAPH_SEGMENTS = 160;
/** The length of an arrow's head, in units of the picture. */
const ARROW_HEAD = 9;

export class Drawing {
  /** @type {Mark[]} */
  marks = [];
  /** What has to be in view. @type {Point3[]} */
  extent = [];

  /** A curve, a spline or a path. @param {any} shape @param {Style | Tone} [style] */
  curve(shape, style) {
    const { tone = "main", thin } = styleOf(style);
    const kind = thin ? "line thin" : "line";
    for (const part of partsOf(shape)) {
      this.#include(flattened(part.controlPoints(), part.dimension));
      this.marks.push((p) => `<path class="${kind} ${tone}" d="${p.pathOf(part)}"/>`);
    }
  }

  /** The inside of a closed spline or a path. @param {any} shape @param {Style | Tone} [style] */
  region(shape, style) {
    const { tone = "main", rule = "nonzero" } = styleOf(style);
    const parts = partsOf(shape);
    for (const part of parts) this.#include(flattened(part.controlPoints(), 2));
    this.marks.push(
      (p) =>
        `<path class="region ${tone}" fill-rule="${rule}" d="${parts.map((part) => `${p.pathOf(part)}Z`).join("")}"/>`,
    );
  }

  /** Straight lines through points: a list of points or a flat array. @param {any} points @param {Style | Tone} [style] */
  polyline(points, style) {
    const { tone = "second", closed = false, dimension } = styleOf(style);
    const list = flattened(points, dimension);
    this.#include(list);
    this.marks.push((p) => `<path class="line ${tone}" d="${p.linesThrough(list)}${closed ? "Z" : ""}"/>`);
  }

  /** The control polygon. @param {any} points @param {Style | Tone} [style] */
  control(points, style) {
    this.polyline(points, { tone: "faint", ...styleOf(style) });
  }

  /** @param {any} a @param {any} b @param {Style | Tone} [style] */
  segment(a, b, style) {
    this.polyline([a, b], style);
    const { label } = styleOf(style);
    const [from, to] = flattened([a, b]);
    if (label) this.text(/** @type {Point3} */ (from.map((x, k) => (x + to[k]) / 2)), label);
  }

  /** @param {any} p @param {Style | Tone} [style] */
  point(p, style) {
    this.points([p], style);
    const { label } = styleOf(style);
    if (label) this.text(p, label);
  }

  /** @param {any} points a list of points or a flat array @param {Style | Tone} [style] */
  points(points, style) {
    const { tone = "result", dimension } = styleOf(style);
    const list = flattened(points, dimension);
    this.#include(list);
    const dot = (/** @type {number[]} */ [x, y]) => `<circle class="dot ${tone}" cx="${x}" cy="${y}" r="4.5"/>`;
    this.marks.push((p) => list.map((point) => dot(p.place(point))).join(""));
  }

  /** An arrow from a point. @param {any} at @param {any} vector @param {Style | Tone} [style] */
  vector(at, vector, style) {
    const { tone = "result", label } = styleOf(style);
    const [from, by] = flattened([at, vector]);
    const to = /** @type {Point3} */ (from.map((x, k) => x + by[k]));
    this.#include([from, to]);
    this.marks.push((p) => arrow(p.place(from), p.place(to), tone));
    if (label) this.text(to, label);
  }

  /** @param {any} center @param {number} radius @param {Style | Tone} [style] */
  circle(center, radius, style) {
    const { tone = "faint" } = styleOf(style);
    const [c] = flattened([center]);
    this.marks.push((p) => {
      const [x, y] = p.place(c);
      return `<circle class="line ${tone}" cx="${x}" cy="${y}" r="${p.length(radius)}"/>`;
    });
  }

  /** A box {min, max}. @param {any} box @param {Style | Tone} [style] */
  box(box, style) {
    const { tone = "second" } = styleOf(style);
    const [a, b] = flattened([box.min, box.max]);
    const corner = (/** @type {number} */ k) =>
      /** @type {Point3} */ (a.map((x, axis) => ((k >> axis) & 1 ? b[axis] : x)));
    const flat = box.min.z === undefined;
    const edges = flat
      ? [[0, 1, 3, 2, 0]]
      : [
          [0, 1, 3, 2, 0],
          [4, 5, 7, 6, 4],
          [0, 4],
          [1, 5],
          [2, 6],
          [3, 7],
        ];
    for (const edge of edges) this.polyline(edge.map(corner), tone);
  }

  /** @param {any} p @param {string} text */
  text(p, text) {
    const [at] = flattened([p]);
    this.marks.push((projection) => {
      const [x, y] = projection.place(at);
      return `<text x="${x + 8}" y="${y - 8}">${escapeHtml(text)}</text>`;
    });
  }

  /** The graph of a function. @param {(x: number) => number} f @param {number} from @param {number} to @param {Style | Tone} [style] */
  graph(f, from, to, style) {
    const at = (/** @type {number} */ k) => from + ((to - from) * k) / GRAPH_SEGMENTS;
    const points = Array.from({ length: GRAPH_SEGMENTS + 1 }, (_, k) => [at(k), f(at(k))]);
    this.polyline(points, { tone: "main", ...styleOf(style) });
  }

  /** The isocurves of a patch or a surface. @param {any} surface @param {Style | Tone} [style] */
  surface(surface, style) {
    const { tone = "main", lines = 5 } = styleOf(style);
    for (const curve of isocurvesOf(surface, lines)) this.curve(curve, { tone, thin: true });
  }

  /** The triangles of a mesh, lit from above. @param {any} mesh @param {Style | Tone} [style] */
  mesh(mesh, style) {
    const { tone = "main" } = styleOf(style);
    const points = flattened(mesh.positions, 3);
    this.#include(points);
    this.marks.push((p) =>
      p
        .triangles(points, mesh.indices)
        .map((face) => faceMark(face, tone))
        .join(""),
    );
  }

  /** @param {Point3[]} points */
  #include(points) {
    for (const point of points) if (point.every(Number.isFinite)) this.extent.push(point);
  }

  /** @param {View} view */
  toSVG(view) {
    const projection = new Projection(view);
    const { width, height } = view;
    const marks = this.marks.map((mark) => mark(projection)).join("");
    return `<svg viewBox="0 0 ${width} ${height}" aria-hidden="true">${marks}</svg>`;
  }
}

/** @param {Style | Tone | undefined} style @returns {Style} */
const styleOf = (style) => (typeof style === "string" ? { tone: style } : (style ?? {}));

/** Curves and splines: the subpaths of a path, the segments of a spline in space. @param {any} shape @returns {any[]} */
function partsOf(shape) {
  if (shape.subpaths) return [...shape.subpaths];
  return shape.dimension === 3 && shape.segments ? shape.segments() : [shape];
}

/** @param {any} surface a Patch or a Surface @param {number} lines strips in each direction @returns {any[]} */
function isocurvesOf(surface, lines) {
  if (surface.isocurves) return surface.isocurves({ lines });
  const at = Array.from({ length: lines + 1 }, (_, k) => k / lines);
  return at.flatMap((t) => [surface.isocurveAtU(t), surface.isocurveAtV(t)]);
}

/** @param {{ corners: number[][], light: number }} face @param {Tone} tone */
function faceMark({ corners, light }, tone) {
  const percent = Math.round(25 + 65 * light);
  return `<path class="face ${tone}" style="--light:${percent}%" d="M${corners.map((c) => c.join(" ")).join("L")}Z"/>`;
}

/** @param {number[]} from @param {number[]} to @param {Tone} tone */
function arrow([x0, y0], [x1, y1], tone) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (!(length > 0)) return `<circle class="dot ${tone}" cx="${x0}" cy="${y0}" r="3"/>`;
  const [ux, uy] = [((x1 - x0) / length) * ARROW_HEAD, ((y1 - y0) / length) * ARROW_HEAD];
  const side = (/** @type {number} */ s) => `${round(x1 - ux - s * uy * 0.5)} ${round(y1 - uy + s * ux * 0.5)}`;
  return `<path class="line ${tone}" d="M${x0} ${y0}L${x1} ${y1}M${side(1)}L${x1} ${y1}L${side(-1)}"/>`;
}

/** @param {number} x */
const round = (x) => Math.round(x * 10) / 10;

/** @param {string} text */
const escapeHtml = (text) => text.replace(/[&<>]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;" })[c] ?? c);
