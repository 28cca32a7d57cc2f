import { readNearest } from "../curve-queries.js";
import { core } from "../../wasm/init.js";
import { writeArguments } from "../../wasm/transfer.js";

/**
 * @import { Nearest } from "../curve-queries.js"
 * @import { SegmentIndex } from "./segment-index.js"
 */

/**
 * The boxes of the control points of each segment, and the nearest point of a spline by their help. The method is that of
 * the core (`src/spline/nearest.rs`), so the results are equal; only the boxes are kept.
 *
 * @internal
 */
export class SegmentBoxes {
  #index;
  /** For each segment, the smallest and then the largest coordinates. */
  #corners;
  /** The distance of each box from the point of the last query. */
  #distances;

  /** @param {SegmentIndex} index */
  constructor(index) {
    const d = index.dimension;
    this.#index = index;
    this.#distances = new Float64Array(index.count);
    this.#corners = new Float64Array(2 * d * index.count);
    for (let k = 0; k < index.count; k++) {
      const points = index.pointsOf(k);
      for (let axis = 0; axis < d; axis++) this.#setRange(2 * d * k + axis, points, axis);
    }
  }

  /**
   * The nearest point; of several, the one with the smallest t.
   *
   * @template {2 | 3} D
   * @param {Float64Array} p the point, in the unit of the points
   * @param {D} dimension that of the spline
   * @returns {Nearest<D>}
   */
  nearest(p, dimension) {
    const promising = this.#measure(p);
    let best = this.#nearestOn(promising, p, dimension);
    for (let k = 0; k < this.#distances.length; k++) {
      if (k === promising || !(this.#distances[k] <= best.distance)) continue;
      const found = this.#nearestOn(k, p, dimension);
      const first = found.distance === best.distance && found.t < best.t;
      if (found.distance < best.distance || first) best = found;
    }
    return best;
  }

  /**
   * @param {number} at
   * @param {Float64Array} points
   * @param {number} axis
   */
  #setRange(at, points, axis) {
    const d = this.#index.dimension;
    let [min, max] = [points[axis], points[axis]];
    for (let i = axis + d; i < points.length; i += d) {
      min = Math.min(min, points[i]);
      max = Math.max(max, points[i]);
    }
    this.#corners[at] = min;
    this.#corners[at + d] = max;
  }

  /**
   * Computes the distance of each box.
   *
   * @param {Float64Array} p
   * @returns {number} the segment with the smallest distance
   */
  #measure(p) {
    const [d, distances] = [this.#index.dimension, this.#distances];
    let promising = 0;
    for (let k = 0; k < distances.length; k++) {
      const x = this.#outside(2 * d * k, p[0]);
      const y = this.#outside(2 * d * k + 1, p[1]);
      const z = d === 3 ? this.#outside(2 * d * k + 2, p[2]) : 0;
      const square = x * x + y * y + z * z;
      // Math.hypot is slow, but its sum of squares neither overflows nor underflows.
      distances[k] = square > 1e-280 && square < 1e280 ? Math.sqrt(square) : Math.hypot(x, y, z);
      if (distances[k] < distances[promising]) promising = k;
    }
    return promising;
  }

  /**
   * How far a coordinate is outside of a range.
   *
   * @param {number} at the index of the smallest coordinate
   * @param {number} x
   * @returns {number}
   */
  #outside(at, x) {
    return Math.max(this.#corners[at] - x, x - this.#corners[at + this.#index.dimension], 0);
  }

  /**
   * @template {2 | 3} D
   * @param {number} k
   * @param {Float64Array} p
   * @param {D} dimension
   * @returns {Nearest<D>}
   */
  #nearestOn(k, p, dimension) {
    const points = this.#index.pointsOf(k);
    writeArguments(points, dimension).set(p, points.length);
    core().curve_nearest(dimension, points.length / dimension);
    const found = readNearest(dimension);
    return { ...found, t: k + found.t };
  }
}
