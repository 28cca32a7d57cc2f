import { pointAndDirections } from "../arc-length.js";
import * as check from "../check.js";
import { boxAt } from "../points.js";
import { PathSegmentIndex } from "./path-segment-index.js";
import { nearestOnPath, readTimes } from "./path-queries.js";
import { SegmentTree } from "../segment-tree.js";
import { segmentAtLength } from "../spline/arc-length-table.js";
import { PathEvaluation } from "./path-evaluation.js";
import { checkedLocation, segmentAt } from "./path-segments.js";
import { coordinatesOf } from "./path-value.js";
import { core } from "../../wasm/init.js";
import { extents } from "../../wasm/packed-path.js";
import { writeArguments, readResult, releaseMemory } from "../../wasm/transfer.js";
import type { PointLike } from "../check.js";
import type { PathPoint, PathPointAtLength, PathTime } from "./path-queries.js";
import type { Bounds } from "../points.js";

/** The rule that decides which winding numbers are inside: all except 0, or the odd ones. */
export type FillRule = "nonzero" | "evenodd";

/** The integrals of 1, x, y, x², xy and y² over the inside; each region is weighted with its winding number. */
export interface Moments {
  /** The integral of 1 */
  area: number;
  /** The integral of x; x / area is the x coordinate of the centroid */
  x: number;
  /** The integral of y; y / area is the y coordinate of the centroid */
  y: number;
  /** The integral of x² */
  xx: number;
  /** The integral of xy */
  xy: number;
  /** The integral of y² */
  yy: number;
}

/** How a path is filled. */
export interface RegionOptions {
  /**
   * Which points a path contains: those with a winding number other than 0 ("nonzero", the default), or with an odd
   * one ("evenodd")
   */
  fillRule?: FillRule;
}

const FILL_RULES: readonly FillRule[] = ["nonzero", "evenodd"];

/**
 * @internal
 * @returns whether the rule is "evenodd"
 */
export function isEvenOdd(options: RegionOptions | undefined): boolean {
  const { fillRule = "nonzero" } = check.options(options, ["fillRule"]);
  check.oneOf(fillRule, "fillRule", FILL_RULES);
  return fillRule === "evenodd";
}

/**
 * Boxes, lengths, areas, winding numbers and nearest points of a path. What repeated queries need is computed at the
 * second one and kept with the path.
 */
export class PathMeasures extends PathEvaluation {
  #segments: PathSegmentIndex | undefined;
  #tree: SegmentTree | undefined;
  /** That of the closed subpaths, for winding numbers */
  #filled: SegmentTree | undefined;
  #askedForWinding = false;
  #askedForNearest = false;
  /** The arc lengths from the start of the path to the end of each segment, after a 0 */
  #ends: Float64Array | undefined;
  #bounds: Bounds<2> | null | undefined;
  #controlBounds: Bounds<2> | null | undefined;
  #area: number | undefined;

  /** The smallest box that contains the path; null for an empty one. */
  bounds(...surplus: never[]): Bounds<2> | null {
    check.noSurplus(surplus, "bounds", 0);
    this.#bounds ??= this._box(true);
    return copyOfBounds(this.#bounds);
  }

  /** The box of the control points, which contains the path; null for an empty one. */
  controlBounds(): Bounds<2> | null {
    this.#controlBounds ??= this._box(false);
    return copyOfBounds(this.#controlBounds);
  }

  /**
   * The sum of the lengths of all segments.
   *
   * @param tolerance the largest error, by default 1e-12 of the length
   */
  length(tolerance?: number, ...surplus: never[]): number {
    check.noSurplus(surplus, "length", 1);
    if (tolerance === undefined) return this.#segmentEnds().at(-1) as number;
    const maxError = check.optionalTolerance(tolerance);
    writeArguments(this._packed);
    return readResult(0, core().path_length(maxError))[0];
  }

  /**
   * The position at which the arc length from the start of the first subpath is s; null for an empty path.
   *
   * @param s outside of [0, length] it gives the nearer end
   * @param tolerance the largest error, as a length
   */
  timeAtLength(s: number, tolerance?: number): PathTime | null {
    check.finite(s, "s");
    const maxError = check.optionalTolerance(tolerance);
    if (tolerance !== undefined) {
      writeArguments(this._packed);
      return readTimes(core().path_time_at_length(s, maxError))[0] ?? null;
    }
    const ends = this.#segmentEnds();
    const { count } = this.#index();
    if (count === 0) return null;
    if (s <= 0) return { subpath: 0, t: 0 };
    const k = segmentAtLength(ends, s);
    if (k === count) return this.#index().location(count - 1, 1);
    const { subpath, t } = this.#index().location(k, 0);
    return { subpath, t: t + this._segments(subpath)[t].timeAtLength(s - ends[k]) };
  }

  /**
   * The location at which the arc length from the start of the first subpath is s, with its point, unit tangent and unit
   * normal: for text, markers and motion along a path. Null for an empty path.
   *
   * @param s outside of [0, length] it gives the nearer end
   * @param tolerance the largest error, as a length
   */
  pointAtLength(s: number, tolerance?: number): PathPointAtLength | null {
    const time = this.timeAtLength(s, tolerance);
    if (!time) return null;
    const [curve, t] = segmentAt(this, time);
    return { ...pointAndDirections(curve, t), ...time };
  }

  /**
   * `segments` + 1 positions that divide the whole path into parts of equal length; none for an empty path.
   *
   * @param segments how many parts, at least 1
   */
  equidistantTimes(segments: number): PathTime[] {
    check.segmentCount(segments);
    writeArguments(this._packed);
    const times = readTimes(core().path_equidistant_times(segments));
    releaseMemory();
    return times;
  }

  /**
   * The arc length from the start of the path to a location: the lengths of the subpaths before it and of the part of
   * its own; the inverse of `timeAtLength`.
   *
   *     path.lengthAt(path.nearest(point)); // how far along the path the nearest point is
   *
   * @param location a subpath and a parameter on it; beyond its ends, the end counts
   */
  lengthAt(location: PathTime): number {
    const { subpath, t } = checkedLocation(this, location);
    const before = this.subpaths.slice(0, subpath).reduce((sum, spline) => sum + spline.length(), 0);
    const spline = this.subpaths[subpath];
    return before + (t <= 0 ? 0 : spline.subsegment(0, Math.min(t, spline.segmentCount)).length());
  }

  /**
   * The signed area inside, positive for counter-clockwise subpaths (x right, y up); open subpaths are closed by a
   * line.
   */
  area(): number {
    if (this.#area === undefined) {
      writeArguments(this._packed);
      this.#area = core().path_area();
    }
    return this.#area;
  }

  /**
   * The integrals of 1, x, y, x², xy and y² over the inside, weighted as in `area`; the centre of mass is (x, y) /
   * area.
   */
  moments(): Moments {
    writeArguments(this._packed);
    const [area, x, y, xx, xy, yy] = readResult(0, core().path_moments());
    return { area, x, y, xx, xy, yy };
  }

  /**
   * The point of the path that is nearest to another point, the first one of several; null for an empty path.
   *
   * @param point the point, in the unit of the points
   */
  nearest(point: PointLike): PathPoint | null {
    const p = coordinatesOf(point);
    if (this.#tree || this.#askedForNearest) return this._nearest(p, Infinity);
    this.#askedForNearest = true;
    return nearestOnPath(this._packed, p);
  }

  /**
   * The winding number of the path around a point: counter-clockwise is positive (x right, y up). Open subpaths are
   * closed by a line. A point on the boundary counts as slightly displaced to the right and upwards.
   *
   * @param point the point, in the unit of the points
   */
  windingNumber(point: PointLike): number {
    const [x, y] = coordinatesOf(point);
    if (this.#filled || this.#askedForWinding) {
      this.#filled ??= new SegmentTree(new PathSegmentIndex(this._packed, true));
      return this.#filled.crossings(x, y);
    }
    this.#askedForWinding = true;
    writeArguments(this._packed);
    return core().path_winding_number(x, y);
  }

  /**
   * Whether the path, filled by the rule, contains a point.
   *
   * @param point the point, in the unit of the points
   */
  contains(point: PointLike, options?: RegionOptions): boolean {
    const evenOdd = isEvenOdd(options);
    const winding = this.windingNumber(point);
    return evenOdd ? winding % 2 !== 0 : winding !== 0;
  }

  /**
   * For each subpath a polyline whose distance from it is nowhere greater than `tolerance`; joints are vertices.
   *
   * @param tolerance the largest distance, in the unit of the points
   * @returns `closed`: whether the subpath is; then the last vertex is the first one again
   */
  flatten(tolerance: number, ...surplus: never[]): { points: Float64Array; ts: Float64Array; closed: boolean }[] {
    check.noSurplus(surplus, "flatten", 1);
    check.positive(tolerance, "tolerance");
    writeArguments(this._packed);
    const numbers = readResult(0, core().path_flatten(tolerance));
    releaseMemory();
    const subpaths = extents(this._packed);
    const polylines: { points: Float64Array; ts: Float64Array; closed: boolean }[] = [];
    for (let at = 0; at < numbers.length; ) {
      const points = at + 1;
      const ts = points + 2 * numbers[at];
      at = ts + numbers[at];
      const { closed } = subpaths.next().value ?? { closed: false };
      polylines.push({ points: numbers.slice(points, ts), ts: numbers.slice(ts, at), closed });
    }
    return polylines;
  }

  /**
   * The nearest point within a distance.
   *
   * @internal
   */
  _nearest(point: Float64Array, maxDistance: number): PathPoint | null {
    const nearest = this.#segmentTree()?.nearest(point, maxDistance);
    if (!nearest) return null;
    const { t, point: at, distance } = nearest.found;
    return { ...this.#index().location(nearest.k, t), point: at, distance };
  }

  /**
   * The distance of a point from the box of the control points; infinite for an empty path.
   *
   * @internal
   */
  _boxDistance(point: Float64Array): number {
    return this.#segmentTree()?.distance(point) ?? Infinity;
  }

  #segmentTree() {
    if (this.subpathCount > 0) this.#tree ??= new SegmentTree(this.#index());
    return this.#tree;
  }

  #index() {
    this.#segments ??= new PathSegmentIndex(this._packed);
    return this.#segments;
  }

  #segmentEnds() {
    if (!this.#ends) {
      writeArguments(this._packed);
      this.#ends = readResult(0, core().path_segment_ends());
    }
    return this.#ends;
  }

  /**
   * @internal
   */
  _box(exact: boolean) {
    writeArguments(this._packed);
    const numbers = readResult(0, core().path_bounds(exact));
    return numbers.length ? boxAt(numbers, 2) : null;
  }
}

function copyOfBounds(box: Bounds<2> | null): Bounds<2> | null {
  return box && { min: { ...box.min }, max: { ...box.max } };
}
