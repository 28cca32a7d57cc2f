import * as check from "../check.js";
import { extremaOfPath, timesAtCoordinateOfPath } from "./path-coordinates.js";
import { checkedLocation, isAfter, partsBetween, pointAsSubpath, segmentAt } from "./path-segments.js";
import { PathValue } from "./path-value.js";
import { extents, packedSplines } from "../../wasm/packed-path.js";
import type { PathExtrema } from "./path-coordinates.js";
import type { PathTime } from "./path-queries.js";
import type { Point } from "../points.js";

/** The limit of one result in the core: 1 GiB of coordinates. */
const MAX_SAMPLE_SEGMENTS = (1 << 26) - 1;

/**
 * Points, derivatives and parts of a path at given locations {subpath, t}.
 *
 * t runs from 0 to the number of segments of the subpath. At a joint the segment that starts there counts, at the end
 * the last segment; values outside extrapolate the first and the last segment.
 */
export class PathEvaluation extends PathValue {
  /**
   * The point at a location.
   *
   * @param location a subpath and a parameter on it
   */
  eval(location: PathTime): Point<2> {
    const [curve, t] = segmentAt(this, location);
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
    const checked = Array.from(locations, (location, k) => checkedLocation(this, location, `locations[${k}]`));
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
    const [curve, t] = segmentAt(this, location);
    return curve.derivativeAt(t, k);
  }

  /**
   * The unit tangent at a location, see `Curve.tangent`; zero if the segment is a point.
   *
   * @param location a subpath and a parameter on it
   */
  tangent(location: PathTime): Point<2> {
    const [curve, t] = segmentAt(this, location);
    return curve.tangent(t);
  }

  /**
   * The unit normal at a location: the tangent turned by +90°, (x, y) → (−y, x).
   *
   * @param location a subpath and a parameter on it
   */
  normal(location: PathTime): Point<2> {
    const [curve, t] = segmentAt(this, location);
    return curve.normal(t);
  }

  /**
   * The curvature at a location, positive when turning counter-clockwise (x right, y up). Infinite at a cusp.
   *
   * @param location a subpath and a parameter on it
   */
  curvature(location: PathTime): number {
    const [curve, t] = segmentAt(this, location);
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
   * @param location a subpath and a parameter on it
   */
  split(location: PathTime, ...surplus: never[]): [this, this] {
    check.noSurplus(surplus, "split", 1, "subsegment(from, to)");
    const at = checkedLocation(this, location);
    const last = this.subpathCount - 1;
    const end = { subpath: last, t: this._segments(last).length };
    const parts = [partsBetween(this, { subpath: 0, t: 0 }, at), partsBetween(this, at, end)];
    return parts.map((splines) => this._pathOf(packedSplines(splines))) as [this, this];
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
  subsegment(from: PathTime, to: PathTime, ...surplus: never[]): this {
    check.noSurplus(surplus, "subsegment", 2);
    const [a, b] = [checkedLocation(this, from, "from"), checkedLocation(this, to, "to")];
    if (isAfter(a, b)) return this._pathOf(packedSplines(partsBetween(this, b, a).reverse())).reverse();
    const isPoint = a.subpath === b.subpath && a.t === b.t;
    return this._pathOf(packedSplines(isPoint ? [pointAsSubpath(this, a)] : partsBetween(this, a, b)));
  }

  /**
   * The locations where a coordinate has a local extremum (its derivative changes sign), inside segments and at joints,
   * in the order of the path. The ends of open subpaths do not count. Where the coordinate is constant between
   * increasing and decreasing (the sides of a rectangle), the joints of the constant part are extrema. See
   * `Spline.extrema`.
   */
  extrema(...surplus: never[]): PathExtrema {
    check.noSurplus(surplus, "extrema", 0);
    return extremaOfPath(this);
  }

  /**
   * All locations at which a coordinate has the given value, end points and tangencies included, in the order of the
   * path. A joint is reported once, the end of a closed subpath as its start. For a segment on which the coordinate has
   * that value everywhere: its ends.
   *
   * @param where one coordinate and its value
   */
  timesAtCoordinate(where: { x: number } | { y: number }): PathTime[] {
    return timesAtCoordinateOfPath(this, where);
  }
}
