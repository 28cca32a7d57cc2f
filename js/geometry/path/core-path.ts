import { checkedData, fromChecked } from "../checked.js";
import { curvesModule } from "../../wasm/curves-module.js";
import * as check from "../check.js";
import * as shapes from "./path-shapes.js";
import { pathData, requireJSON } from "../brand.js";
import { affine } from "../affine.js";
import { showInNode } from "../inspected.js";
import { samePoints, writePoint, boxAt, requireList } from "../points.js";
import { checkedSplineData, packedShape, require2D } from "./packed-shape.js";
import { findArcs } from "../../io/svg-arcs.js";
import { svgOf, traceOn, checkTolerance } from "../../io/svg-write.js";
import { extents, packedSplines, packedPaths } from "../../wasm/packed-path.js";
import { isEvenOdd } from "./fill-rule.js";
import { checkedLocation, isAfter, partsBetween, segmentAt } from "./path-segments.js";
import { pointAndDirections } from "../arc-length.js";
import { PathSegmentIndex } from "./path-segment-index.js";
import { PathTree } from "./path-tree.js";
import { nearestOnPath, readTimes } from "./path-queries.js";
import { segmentAtLength } from "../spline/arc-length-table.js";
import { coreSplineOf, splineDataFromJSON } from "../spline/core-spline.js";
import { readSvg } from "../../io/svg-read.js";
import { PathBuilder } from "./path-builder.js";
import type { TransformLike, Complete, PointLike, PointsLike } from "../check.js";
import type { CoreCurve } from "../curve/core-curve.js";
import type { SplineData } from "../brand.js";
import type { CoreSpline, SplineJSON } from "../spline/core-spline.js";
import type { PathSvgOptions } from "../../io/svg-write.js";
import type { RegionOptions } from "./fill-rule.js";
import type { PathTime, PathPoint, PathPointAtLength } from "./path-queries.js";
import type { Point, Bounds } from "../points.js";
import type { ArcOptions, RectOptions } from "./path-shapes.js";

/** Longer path data is cut off in Node's console, as Node does with long arrays. */
const MAX_SHOWN_LENGTH = 1000;

/** Whether Node knows how to show the instances. */
let isShown = false;

/** The limit of one result in the core: 1 GiB of coordinates. */
const MAX_SAMPLE_SEGMENTS = (1 << 26) - 1;

/** What a path can be made of and intersected with, from any entry point of this package. */
export type Shape = CorePath | CoreSpline | CoreCurve;

/** A class of paths, on which static methods are called. */
export type PathClass<P> = new (splines: ArrayLike<CoreSpline | CoreCurve>) => P;

/**
 * A list of 2D splines, open or closed: outlines with holes, icons, anything that SVG path data can describe. It may be
 * empty.
 *
 *     const ring = Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z");
 *     ring.contains([0.5, 2]); // true
 *     ring.length(); // 24
 *
 * This is `Path` of casteljau/core. That of `casteljau` extends it; where a function takes a path, it takes the paths of every
 * entry point. Static methods make paths of the class on which they are called; `from` and `fromJSON`, which may be passed to
 * `map`, belong to one class.
 */
export class CorePath<S extends CoreSpline<2> = CoreSpline<2>> {
  /** See `packed-path.js` */
  #packed: Float64Array;
  #subpaths: readonly S[] | null = null;
  /** The segments of the subpaths that were asked for */
  #segments: (readonly CoreCurve<2>[])[] = [];

  /**
   * The path with the given splines and curves as its subpaths, in their order.
   *
   * @param splines 2D
   * @throws {TypeError} for values that are not splines or curves, and for 3D ones
   */
  constructor(splines: ArrayLike<CoreSpline | CoreCurve>) {
    if (!isShown) show();
    this.#packed = checkedData<Float64Array>(splines) ?? packedList(splines);
  }

  /** The number of subpaths. */
  get subpathCount() {
    return this.#packed[0];
  }

  /** The subpaths, a frozen array. */
  get subpaths() {
    this.#subpaths ??= Object.freeze(Array.from(extents(this.#packed), (extent) => this.#subpath(extent)));
    return this.#subpaths;
  }

  /**
   * The path as the `d` attribute of an SVG `<path>`; segments of higher degree become cubics.
   *
   * Without `precision`: "M0,0 L1,0.5 Z", each number with the fewest digits that round-trip, so that `fromSVG` reads
   * an equal path. With it: the shortest form, "M0 0 1 .5Z", with at most that many digits after the decimal point.
   * Cubics that `fromSVG` makes of an arc are written as the arc, so a circle takes two commands; arcs are read up to
   * rounding. Finer cubics of equal angles are written as one arc, too, and read within the tolerance of `fromSVG`.
   */
  toSVG(options?: PathSvgOptions): string {
    return svgOf(this.#packed, options, findArcs);
  }

  /** The path as `toSVG` writes it: `String(path)` and `${path}` give this text. */
  toString(): string {
    return this.toSVG();
  }

  /**
   * Whether both have the same structure and each control point lies within a distance of its counterpart.
   *
   * @param other the value to compare with
   * @param tolerance the largest distance of two control points, by default 0
   */
  equals(other: CorePath, tolerance = 0): boolean {
    const [a, b] = [this.#packed, pathData(other, "other")];
    samePoints(new Float64Array(0), new Float64Array(0), 2, tolerance); // checks the tolerance
    if (a.length !== b.length || a[0] !== b[0]) return false;
    for (const { degrees, points, end } of extents(a)) {
      for (let k = degrees - 2; k < points; k++) if (a[k] !== b[k]) return false;
      if (!samePoints(a.subarray(points, end), b.subarray(points, end), 2, tolerance)) return false;
    }
    return true;
  }

  /**
   * The path transformed by an affine map.
   *
   * @param matrix a matrix, or a text such as "translate(50 50) rotate(30)"
   * @throws {RangeError} for an image with a coordinate beyond 2^500
   */
  transform<const M extends TransformLike>(matrix: M & Complete<M>): this {
    const [a, b, , c, d, , , , , e, f] = affine(matrix);
    const packed = this.#packed.slice();
    let index = 0;
    for (const { points, end } of extents(packed)) {
      for (let k = points; k < end; k += 2, index++) {
        const [x, y] = [packed[k], packed[k + 1]];
        packed[k] = a * x + c * y + e;
        packed[k + 1] = b * x + d * y + f;
        const bad = [packed[k], packed[k + 1]].find((number) => !check.isCoordinate(number));
        if (bad !== undefined) check.coordinate(bad, `image[${index}]`);
      }
    }
    return this._pathOf(packed);
  }

  /**
   * The same path with each subpath reversed; the order of the subpaths and the first points of closed ones are kept.
   */
  reverse(): this {
    const packed = this.#packed.slice();
    for (const { closed, degrees, points, end } of extents(packed)) {
      packed.subarray(degrees, points).reverse();
      const first = closed ? points + 2 : points;
      // Reversing the array also exchanges x and y of each point.
      packed.subarray(first, end).reverse();
      for (let k = first; k < end; k += 2) [packed[k], packed[k + 1]] = [packed[k + 1], packed[k]];
    }
    return this._pathOf(packed);
  }

  /**
   * Draws the path on a canvas context or a Path2D.
   *
   * @param target a canvas context or a Path2D
   * @param options `tolerance`: for degrees above 3, which are drawn as cubics
   */
  trace(
    target: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D,
    options?: { tolerance?: number },
  ) {
    traceOn(this.#packed, target, options);
  }

  /**
   * A new Path2D of the path, for `fill`, `stroke`, `clip` and `isPointInPath` of a canvas context. In environments
   * without Path2D (Node, for example) it throws an Error; `trace` draws on any context.
   *
   * @param options `tolerance`: for degrees above 3, which are drawn as cubics
   */
  toPath2D(options?: { tolerance?: number }): Path2D {
    if (typeof Path2D !== "function") throw new Error("toPath2D: expected an environment with Path2D, got none");
    const target = new Path2D();
    this.trace(target, options);
    return target;
  }

  /** The path as an object for JSON, from which `Path.fromJSON` makes an equal path. */
  toJSON(): { subpaths: ReturnType<CoreSpline["toJSON"]>[] } {
    return { subpaths: this.subpaths.map((spline) => spline.toJSON()) };
  }

  /**
   * See `brand.js`.
   *
   * @internal
   */
  get casteljauType(): "path" {
    return "path";
  }

  /**
   * The packed path, not copied.
   *
   * @internal
   */
  casteljauData(): Float64Array {
    return this.#packed;
  }

  /**
   * The packed path, not copied.
   *
   * @internal
   */
  get _packed() {
    return this.#packed;
  }

  /**
   * The segments of a subpath.
   *
   * @internal
   */
  _segments(subpath: number): readonly CoreCurve<2>[] {
    this.#segments[subpath] ??= this.subpaths[subpath].segments();
    return this.#segments[subpath];
  }

  /** The segment at a location, and the parameter on it. */
  #segmentAt(location: PathTime): [CoreCurve<2>, number] {
    const { subpath, t } = checkedLocation(this.subpathCount, location);
    return segmentAt(this._segments(subpath), t);
  }

  /**
   * A path of the same class.
   *
   * @internal
   */
  _pathOf(packed: Float64Array): this {
    return corePathOf(packed) as this;
  }

  /**
   * A subpath.
   *
   * @internal
   */
  _splineOf(data: SplineData): S {
    return coreSplineOf(data) as unknown as S;
  }

  #subpath({ closed, degrees, points, end }: ReturnType<typeof extents> extends Iterable<infer E> ? E : never): S {
    const flat = this.#packed.slice(points, end);
    return this._splineOf({ flat, dimension: 2, degrees: [...this.#packed.subarray(degrees, points)], closed });
  }

  /**
   * The point at a location.
   *
   * @param location a subpath and a parameter on it
   */
  eval(location: PathTime): Point<2> {
    const [curve, t] = this.#segmentAt(location);
    return curve.eval(t);
  }

  /**
   * The points at the given locations.
   *
   *     path.evalAt(path.equidistantTimes(100)); // 101 points, evenly spaced along the path
   *
   * @param locations subpaths and parameters on them
   * @param options `into`: at least 2 · locations.length numbers long
   */
  evalAt(locations: ArrayLike<PathTime>, options?: { into?: Float64Array }): Float64Array {
    if (!Array.isArray(locations)) {
      throw new TypeError(`locations: expected an array of {subpath, t}, got ${check.describe(locations)}`);
    }
    const checked = Array.from(locations, (location, k) =>
      checkedLocation(this.subpathCount, location, `locations[${k}]`),
    );
    const points = check.resultArray(check.options(options, ["into"]).into, 2 * checked.length);
    checked.forEach((location, k) => {
      const { x, y } = this.eval(location);
      points[2 * k] = x;
      points[2 * k + 1] = y;
    });
    return points;
  }

  /**
   * For each subpath, points at equally spaced t, both ends included, see `Spline.sample`.
   *
   * @param segmentsPerCurve how many parts for each segment, at least 1
   */
  sample(segmentsPerCurve: number): Float64Array[] {
    check.segmentCount(segmentsPerCurve, "segmentsPerCurve");
    let total = 0;
    for (const { segments } of extents(this._packed)) total += segmentsPerCurve * segments;
    if (total > MAX_SAMPLE_SEGMENTS) {
      throw new RangeError(`segments: expected at most ${MAX_SAMPLE_SEGMENTS}, this needs ${total}`);
    }
    return this.subpaths.map((spline) => spline.sample(segmentsPerCurve));
  }

  /**
   * The k-th derivative with respect to t at a location; zero if k is greater than the degree of the segment.
   *
   * @param location a subpath and a parameter on it
   * @param k the order of the derivative, by default 1
   */
  derivativeAt(location: PathTime, k = 1): Point<2> {
    const [curve, t] = this.#segmentAt(location);
    return curve.derivativeAt(t, k);
  }

  /**
   * The unit tangent at a location, see `Curve.tangent`; zero if the segment is a point.
   *
   * @param location a subpath and a parameter on it
   */
  tangent(location: PathTime): Point<2> {
    const [curve, t] = this.#segmentAt(location);
    return curve.tangent(t);
  }

  /**
   * The unit normal at a location: the tangent turned by +90°, (x, y) → (−y, x).
   *
   * @param location a subpath and a parameter on it
   */
  normal(location: PathTime): Point<2> {
    const [curve, t] = this.#segmentAt(location);
    return curve.normal(t);
  }

  /**
   * The curvature at a location, positive when turning counter-clockwise (x right, y up). Infinite at a cusp.
   *
   * @param location a subpath and a parameter on it
   */
  curvature(location: PathTime): number {
    const [curve, t] = this.#segmentAt(location);
    return curve.curvature(t);
  }

  /**
   * The part of the path before a location and the part after it. The subpath that contains the location becomes two
   * open ones (a closed subpath is also divided at its start); all others are unchanged. At the start or the end of a
   * subpath nothing is divided, so that one of the parts may be an empty path.
   *
   *     const [before, after] = Path.fromSVG("M0 0H4 M0 1H4").split({ subpath: 1, t: 0.5 });
   *     before.toSVG(); // "M0,0 L4,0 M0,1 L2,1"
   *     after.toSVG(); // "M2,1 L4,1"
   *
   * With a list of locations, in any order: the parts before the first one along the path, between neighbours, and after
   * the last one, one part more than locations. Between equal locations the part is an empty path.
   *
   * @param location a subpath and a parameter on it
   */
  split(location: PathTime): [this, this];
  /** @param locations any number of locations */
  split(locations: readonly PathTime[]): this[];
  split(location: PathTime | readonly PathTime[]): this[] {
    const ends = Array.isArray(location)
      ? Array.from(location, (each, k) => checkedLocation(this.subpathCount, each, `locations[${k}]`))
      : [checkedLocation(this.subpathCount, location)];
    ends.sort((a, b) => a.subpath - b.subpath || a.t - b.t);
    const last = this.subpathCount - 1;
    ends.push({ subpath: last, t: last < 0 ? 0 : this._segments(last).length });
    const start = { subpath: 0, t: 0 };
    return ends.map((end, k) => this._pathOf(packedSplines(partsBetween(this.subpaths, k ? ends[k - 1] : start, end))));
  }

  /**
   * The part of the path from one location to another; if `from` is after `to`, the same part with the opposite
   * direction and the subpaths in the opposite order.
   *
   * Parts of a subpath are open; a closed subpath that is contained as a whole stays closed. A part does not cross the
   * start of a closed subpath. If both locations are equal, the part is a single segment that is a point.
   *
   * @param from the location of the start
   * @param to the location of the end
   */
  subsegment(from: PathTime, to: PathTime): this {
    const [a, b] = [checkedLocation(this.subpathCount, from, "from"), checkedLocation(this.subpathCount, to, "to")];
    if (isAfter(a, b)) return this._pathOf(packedSplines(partsBetween(this.subpaths, b, a).reverse())).reverse();
    const isPoint = a.subpath === b.subpath && a.t === b.t;
    return this._pathOf(
      packedSplines(
        isPoint ? [this.subpaths[a.subpath].subsegment(a.t, a.t).casteljauData()] : partsBetween(this.subpaths, a, b),
      ),
    );
  }

  #segmentIndex: PathSegmentIndex | undefined;
  #tree: PathTree | undefined;
  /** Whether a nearest point or a winding number was asked for: the next time the tree is made */
  #asked = false;
  /** The arc lengths from the start of the path to the end of each segment, after a 0 */
  #ends: Float64Array | undefined;
  #bounds: Bounds<2> | null | undefined;
  #controlBounds: Bounds<2> | null | undefined;
  #area: number | undefined;

  /** The smallest box that contains the path; null for an empty one. */
  bounds(): Bounds<2> | null {
    if (this.#bounds === undefined) this.#bounds = this._box(true);
    return copyOfBounds(this.#bounds);
  }

  /** The box of the control points, which contains the path; null for an empty one. */
  controlBounds(): Bounds<2> | null {
    if (this.#controlBounds === undefined) this.#controlBounds = this._box(false);
    return copyOfBounds(this.#controlBounds);
  }

  /**
   * The sum of the lengths of all segments.
   *
   * @param tolerance the largest error, by default 1e-12 of the length
   */
  length(tolerance?: number): number {
    if (tolerance === undefined) return this.#segmentEnds().at(-1) as number;
    const maxError = check.optionalTolerance(tolerance);
    curvesModule.write(this._packed);
    return curvesModule.read(0, curvesModule.functions.path_length(maxError))[0];
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
      curvesModule.write(this._packed);
      return readTimes(curvesModule.functions.path_time_at_length(s, maxError))[0] ?? null;
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
    const [curve, t] = segmentAt(this._segments(time.subpath), time.t);
    return { ...pointAndDirections(curve, t), ...time };
  }

  /**
   * `segments` + 1 positions that divide the whole path into parts of equal length; none for an empty path.
   *
   * @param segments how many parts, at least 1
   */
  equidistantTimes(segments: number): PathTime[] {
    check.segmentCount(segments);
    curvesModule.write(this._packed);
    const times = readTimes(curvesModule.functions.path_equidistant_times(segments));
    curvesModule.release();
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
    const { subpath, t } = checkedLocation(this.subpathCount, location);
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
      curvesModule.write(this._packed);
      this.#area = curvesModule.functions.path_area();
    }
    return this.#area;
  }

  /**
   * The point of the path that is nearest to another point, the first one of several; null for an empty path.
   *
   * @param point the point, in the unit of the points
   */
  nearest(point: PointLike): PathPoint | null {
    const p = coordinatesOf(point);
    if (this.#asked) return this._nearest(p, Infinity);
    this.#asked = true;
    return nearestOnPath(this._packed, p);
  }

  /**
   * The winding number of the path around a point: counter-clockwise is positive (x right, y up). Open subpaths are
   * closed by a line. A point on the boundary counts as slightly displaced to the right and upwards.
   *
   * @param point the point, in the unit of the points
   */
  windingNumber(point: PointLike): number {
    return this.#windingNumber(coordinatesOf(point));
  }

  #windingNumber([x, y]: Float64Array): number {
    if (this.#asked) return this.#segmentTree().windingNumber(x, y);
    this.#asked = true;
    curvesModule.write(this._packed);
    return curvesModule.functions.path_winding_number(x, y);
  }

  /**
   * Whether the path, filled by the rule, contains a point.
   *
   * @param point the point, in the unit of the points
   */
  contains(point: PointLike, options?: RegionOptions): boolean {
    const p = coordinatesOf(point);
    const evenOdd = isEvenOdd(options);
    const winding = this.#windingNumber(p);
    return evenOdd ? winding % 2 !== 0 : winding !== 0;
  }

  /**
   * For each subpath a polyline whose distance from it is nowhere greater than `tolerance`; joints are vertices.
   *
   * @param tolerance the largest distance, in the unit of the points
   * @returns `closed`: whether the subpath is; then the last vertex is the first one again
   */
  flatten(tolerance: number): { points: Float64Array; ts: Float64Array; closed: boolean }[] {
    check.positive(tolerance, "tolerance");
    curvesModule.write(this._packed);
    const numbers = curvesModule.read(0, curvesModule.functions.path_flatten(tolerance));
    curvesModule.release();
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
    return this.#segmentTree().nearest(point, maxDistance);
  }

  #segmentTree() {
    this.#tree ??= new PathTree(this.#index());
    return this.#tree;
  }

  #index() {
    this.#segmentIndex ??= new PathSegmentIndex(this._packed);
    return this.#segmentIndex;
  }

  #segmentEnds() {
    if (!this.#ends) {
      curvesModule.write(this._packed);
      this.#ends = curvesModule.read(0, curvesModule.functions.path_segment_ends());
    }
    return this.#ends;
  }

  /**
   * The box of the path, or of its control points; null for an empty path.
   *
   * @internal
   */
  _box(exact: boolean) {
    curvesModule.write(this._packed);
    const numbers = curvesModule.read(0, curvesModule.functions.path_bounds(exact));
    return numbers.length ? boxAt(numbers, 2) : null;
  }

  /**
   * Parses the `d` attribute of an SVG `<path>` with all its commands, in time proportional to the length of the text.
   *
   * Arcs are approximated by as few cubics as possible within a tolerance, by default 1e-5 of the larger radius: 8 for
   * a circle. A moveto without a segment is ignored; "M1 1Z" is
   * a closed subpath with one line of length 0. The text "none", as in CSS, gives an empty path. `Z` adds a line to the start unless the current point is already there.
   *
   * @param d SVG path data
   * @throws {SvgError} a RangeError with `offset` and `path`, the path up to the error
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate
   */
  static fromSVG<P extends CorePath>(this: PathClass<P>, d: string, options?: ArcOptions): P {
    if (typeof d !== "string") throw new TypeError(`d: expected a string, got ${check.describe(d)}`);
    const tolerance = check.optionalTolerance(check.options(options, ["tolerance"]).tolerance);
    const { packed, error } = readSvg(d, tolerance);
    const path = pathFrom(this, packed);
    if (error) throw Object.assign(new RangeError(error.message), { offset: error.offset, path });
    checkTolerance(packed, tolerance);
    return path;
  }

  /**
   * A builder with the methods of a canvas context, for code that draws on one.
   *
   *     const builder = Path.builder();
   *     d3.line().context(builder)(data); // or any other function that draws on a canvas
   *     const path = builder.build();
   *
   * @param options for `arc`, `arcTo`, `ellipse` and `roundRect`
   */
  static builder<P extends CorePath>(this: PathClass<P>, options?: ArcOptions): PathBuilder<P> {
    return new PathBuilder(check.optionalTolerance(check.options(options, ["tolerance"]).tolerance), (packed) =>
      pathFrom(this, packed),
    );
  }

  /**
   * A circle, counter-clockwise (x right, y up; clockwise on a canvas), from the point to the right of the centre. It
   * consists of cubics that join at each quarter turn.
   *
   * By default, 8 cubics approximate it within 4.3e-6 of the radius. The largest distance of a cubic over the angle θ is
   * 2/27 sin⁶(θ/4) / cos²(θ/4) of the radius: a tolerance of 2.73e-4 · radius gives the usual four cubics.
   *
   * @param center the center
   * @param radius 0 gives a closed subpath that is a point
   * @throws {RangeError} for a negative radius, coordinates that overflow, and a tolerance not above 0 or below 4 ulps
   *   of the largest coordinate
   */
  static circle<P extends CorePath>(this: PathClass<P>, center: PointLike, radius: number, options?: ArcOptions): P {
    return pathFrom(this, shapes.circle(center, radius, options));
  }

  /**
   * An ellipse with the same direction and accuracy as `circle`, from the end of its first semi-axis.
   *
   * @param center the center
   * @param radiusX the length of the first semi-axis
   * @param radiusY the length of the second semi-axis
   * @param rotation the angle from the x-axis to the first semi-axis, in radians, counter-clockwise (y up)
   */
  static ellipse<P extends CorePath>(
    this: PathClass<P>,
    center: PointLike,
    radiusX: number,
    radiusY: number,
    rotation?: number,
    options?: ArcOptions,
  ): P {
    return pathFrom(this, shapes.ellipse(center, radiusX, radiusY, rotation, options));
  }

  /**
   * An arc of a circle as an open subpath, with the accuracy of `circle`: counter-clockwise (x right, y up; clockwise on
   * a canvas) if `endAngle` is greater than `startAngle`, otherwise clockwise.
   *
   *     Path.arc([0, 0], 1, 0, Math.PI / 2); // from (1, 0) to (0, 1)
   *
   * @param center the center
   * @param radius the radius, in the unit of the points
   * @param startAngle in radians, from the x-axis towards the y-axis
   * @param endAngle in radians; at most a full turn away from `startAngle`
   */
  static arc<P extends CorePath>(
    this: PathClass<P>,
    center: PointLike,
    radius: number,
    startAngle: number,
    endAngle: number,
    options?: ArcOptions,
  ): P {
    return pathFrom(this, shapes.circularArc(center, radius, startAngle, endAngle, options));
  }

  /**
   * A rectangle with sides parallel to the axes, counter-clockwise (x right, y up; clockwise on a canvas), from the
   * corner with the smallest coordinates (after its rounding).
   *
   * @param corner the corner with the smallest coordinates
   * @param width the width, at least 0
   * @param height the height, at least 0
   */
  static rect<P extends CorePath>(
    this: PathClass<P>,
    corner: PointLike,
    width: number,
    height: number,
    options?: RectOptions,
  ): P {
    return pathFrom(this, shapes.rect(corner, width, height, options));
  }

  /**
   * A polygon, or an open polyline, with the given corners in their order.
   *
   * @param points a flat array is read as x, y, x, y, …; at least 1 point, at least 2 if open
   * @param options `closed`: true by default
   */
  static polygon<P extends CorePath>(this: PathClass<P>, points: PointsLike, options?: { closed?: boolean }): P {
    requireList(points);
    return pathFrom(this, shapes.polygon(points, options));
  }

  /**
   * The path that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: { subpaths: SplineJSON[] }): CorePath {
    return corePathOf(packedFromJSON(json));
  }

  /**
   * The path of a curve, a spline, a path, or an array of these; the subpaths of paths are copied.
   *
   * @param shapes curves, splines and paths in the plane
   * @throws {TypeError} for other values, and for 3D ones
   */
  static from(shapes: Shape | ArrayLike<Shape>): CorePath {
    return corePathOf(packedFrom(shapes));
  }
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(CorePath.prototype, "Path", shownData);
}

function corePathOf(packed: Float64Array): CorePath {
  return pathFrom(CorePath, packed); // outside of the class, see ../curve/core-curve.js
}

/**
 * The coordinates of a 2D point.
 *
 * @internal
 */
export function coordinatesOf(point: PointLike): Float64Array {
  const coordinates = new Float64Array(2);
  writePoint(coordinates, 0, point, 2, "point");
  return coordinates;
}

function shownData(path: CorePath): string {
  const text = path.toSVG();
  return text.length > MAX_SHOWN_LENGTH ? `${text.slice(0, MAX_SHOWN_LENGTH)}…` : text || "(empty)";
}

function copyOfBounds(box: Bounds<2> | null): Bounds<2> | null {
  return box && { min: { ...box.min }, max: { ...box.max } };
}

/**
 * A path of a class, from a packed path.
 *
 * @internal
 * @throws {TypeError} for a static method that was called without its class
 */
export function pathFrom<P>(Class: PathClass<P>, packed: Float64Array): P {
  if (typeof Class !== "function")
    throw new TypeError("expected a call of a static method on its class, as Path.circle(…)");
  return fromChecked(Class, packed);
}

function packedList(splines: ArrayLike<CoreSpline | CoreCurve>): Float64Array {
  if (!Array.isArray(splines)) {
    const hint = typeof splines === "string" ? "; did you mean Path.fromSVG?" : "";
    throw new TypeError(`splines: expected an array of splines, got ${check.describe(splines)}${hint}`);
  }
  return packedSplines(Array.from(splines, (spline, k) => checkedSplineData(spline, `splines[${k}]`)));
}

/**
 * The packed path of what `Path.from` accepts.
 *
 * @internal
 */
export function packedFrom(shapes: Shape | ArrayLike<Shape>): Float64Array {
  if (!Array.isArray(shapes)) return packedShape(shapes, "shapes");
  return packedPaths(Array.from(shapes, (shape, k) => packedShape(shape, `shapes[${k}]`)));
}

/**
 * The packed path of what `toJSON` returned.
 *
 * @internal
 */
export function packedFromJSON(json: { subpaths: SplineJSON[] }): Float64Array {
  requireJSON(json, "subpaths", ({ subpaths }) => Array.isArray(subpaths));
  return packedSplines(
    Array.from(json.subpaths, (subpath, k) => require2D(splineDataFromJSON(subpath), `subpaths[${k}]`)),
  );
}
