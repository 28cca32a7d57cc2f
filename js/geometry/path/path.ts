import { curvesModule } from "../../wasm/curves-module.js";
import * as check from "../check.js";
import { contoursToThree } from "../../io/three.js";
import { CorePath, packedFrom, packedFromJSON, pathFrom } from "./core-path.js";
import * as regions from "./path-boolean.js";
import * as strokes from "./path-stroke.js";
import { intersectPathWith, selfIntersectPath } from "../intersections.js";
import { packedShape } from "./packed-shape.js";
import { extremaOfPath, timesAtCoordinateOfPath } from "./path-coordinates.js";
import { PathIndex } from "./path-index.js";
import { cssOf, pathDataOf, readPathData } from "../../io/path-data.js";
import { pathData } from "../brand.js";
import { splineOf } from "../spline/spline.js";
import { packedPaths } from "../../wasm/packed-path.js";
import type { PointLike } from "../check.js";
import type { ThreeShapes } from "../../io/three.js";
import type { PathClass, Shape } from "./core-path.js";
import type { NurbsCurve } from "../rational/nurbs-curve.js";
import type { RationalCurve } from "../rational/rational-curve.js";
import type { RegionOptions } from "./fill-rule.js";
import type { BooleanOperation } from "./path-boolean.js";
import { arcsOf } from "./path-arcs.js";
import { checkTolerance, svgOfArcs } from "../../io/svg-write.js";
import type { ArcSvgOptions, PathSvgOptions } from "../../io/svg-write.js";
import type { CircularArc } from "./path-arcs.js";
import type {
  CornerOptions,
  CornerRadius,
  RegionOffsetOptions,
  SideWidths,
  StrokeOptions,
  StrokeShape,
  WidthProfile,
} from "./path-stroke.js";
import type { PathTime } from "./path-queries.js";
import type { PathExtrema } from "./path-coordinates.js";
import type { ArcOptions } from "./path-shapes.js";
import type { CssOptions, PathSegment } from "../../io/path-data.js";
import type { SplineData } from "../brand.js";
import type { Intersection, PathIntersection } from "../intersections.js";
import type { Spline, SimplifyOptions } from "../spline/spline.js";
import type { SplineJSON } from "../spline/core-spline.js";

/**
 * The error that `Path.fromSVG` throws: a RangeError with the offset of the error in the text, in characters, and the
 * path up to the error (which viewers are to render, according to the SVG specification).
 */
export type SvgError = RangeError & { offset: number; path: Path };

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

/** A face of `Path.faces`: an outer contour with its holes, and for each path whether it contains the face. */
export type Face = { path: Path; inside: boolean[] };

/**
 * A list of 2D splines, open or closed: outlines with holes, icons, anything that SVG path data can describe. It may be
 * empty.
 *
 *     const ring = Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z");
 *     ring.contains([0.5, 2]); // true
 *     ring.contains([2, 2]); // false
 */
export class Path extends CorePath<Spline<2>> {
  /**
   * The path that `toJSON` described.
   *
   * @param json what `toJSON` returned
   */
  static fromJSON(json: { subpaths: SplineJSON[] }): Path {
    return pathOf(packedFromJSON(json));
  }

  /**
   * The path of a curve, a spline, a path, or an array of these; the subpaths of paths are copied.
   *
   * @param shapes curves, splines and paths in the plane
   * @throws {TypeError} for other values, and for 3D ones
   */
  static from(shapes: Shape | ArrayLike<Shape>): Path {
    return pathOf(packedFrom(shapes));
  }

  /** Combines the regions that any number of paths fill, see `union`. Without paths the result is empty. */
  static combine(paths: Path[], operation: BooleanOperation, options?: RegionOptions): Path {
    return pathOf(regions.combine(paths, operation, options));
  }

  /**
   * The bounded faces into which the outlines of paths divide the plane, and which paths contain each: what a shape
   * builder shows under the pointer. Faces that no path contains (the hole of a ring) are in the list as well. Open
   * subpaths are closed by lines; see `union` for the contours.
   *
   *     const parts = Path.faces([Path.circle([0, 0], 1), Path.circle([1, 0], 1)]);
   *     parts.map(({ inside }) => inside); // [true, false], [true, true] and [false, true] in some order
   */
  static faces(paths: Path[], options?: RegionOptions): Face[] {
    return regions.faces(paths, options).map(({ packed, inside }) => ({ path: pathOf(packed), inside }));
  }

  /**
   * The union of regions: the points inside this path or inside one of the others. One call with many paths, like
   * `Path.combine`, is much faster than one `union` after the other.
   *
   *     Path.circle([0, 0], 1).union(Path.circle([1, 0], 1));
   *
   * Open subpaths are closed by lines. The contours of the result are simple and do not cross: winding numbers are 0
   * and 1, so that both fill rules agree. Outer contours run counter-clockwise (x right, y up; clockwise on a canvas),
   * holes clockwise; each outer contour is followed by its holes. Segments that nothing else touches are returned bit
   * for bit, reversed where the direction requires it. The boundary lies within 1e-9 of the size from the exact one;
   * outlines that are closer than that count as one.
   *
   * @param further more paths, and at last the options
   * @throws {RangeError} for more segments or intersections than the limit
   */
  union(other: CorePath, ...further: (CorePath | RegionOptions | undefined)[]): this {
    return this._pathOf(regions.combineWith(this._packed, other, "union", further));
  }

  /**
   * The intersection of regions: the points inside all paths. See `union`.
   *
   * @param further more paths, and at last the options
   */
  intersect(other: CorePath, ...further: (CorePath | RegionOptions | undefined)[]): this {
    return this._pathOf(regions.combineWith(this._packed, other, "intersect", further));
  }

  /** The difference of two regions: the points inside this path and outside of the other one. See `union`. */
  subtract(other: CorePath, options?: RegionOptions): this {
    return this._pathOf(regions.subtract(this._packed, other, options));
  }

  /**
   * The symmetric difference of regions: the points inside exactly one of two paths, or inside an odd number of
   * paths. See `union`.
   *
   * @param further more paths, and at last the options
   */
  exclude(other: CorePath, ...further: (CorePath | RegionOptions | undefined)[]): this {
    return this._pathOf(regions.combineWith(this._packed, other, "exclude", further));
  }

  /** The region that the path fills, with simple contours. See `union`. */
  removeOverlaps(options?: RegionOptions): this {
    return this._pathOf(regions.removeOverlaps(this._packed, options));
  }

  /**
   * The parts into which another path divides the region: one path for each, with its holes. The other path is not
   * filled; its open subpaths stay open. A part of it that ends inside the region divides nothing.
   */
  divide(other: CorePath, options?: RegionOptions): this[] {
    return regions.divide(this._packed, other, options).map((packed) => this._pathOf(packed));
  }

  /**
   * The parts of this path inside a region. This path is not filled: its open subpaths stay open, and closed ones that
   * leave the region become open pieces. See `union`.
   *
   * @param options how `region` is filled
   */
  clip(region: CorePath, options?: RegionOptions): this {
    return this._pathOf(regions.clip(this._packed, region, options));
  }

  /**
   * The region that a stroke of the path covers: the points on a normal of the path at a distance of at most half the
   * width, the joins at corners, and the caps at the ends of open subpaths.
   *
   *     Path.polygon([0, 0, 10, 0], { closed: false }).stroke(2).area(); // 20
   *
   * A profile `{ stops: [[0, 0], [0.5, 8], [1, 0]] }` gives a stroke of varying width: the union of the discs around all
   * points of the path whose radius is half the width there. A butt cap is then the line between the points in which the
   * last disc touches both sides. A subpath that is a point has its largest width.
   *
   * Two widths `{ left: 5, right: 20 }` give the points on a left normal at a distance of at most the first one, and those on
   * a right normal at a distance of at most the second one. Left is where `normal` points (x right, y up; with y down, as on
   * a canvas, it is seen on the right). Joins, and the half disk ahead of a reversal, have the width of the outer side, at
   * reversals that of the wider one. A round cap is the half disk whose diameter is the end of the stroke, and a square cap
   * extends it by (left + right) / 2.
   *
   * Where a segment reverses its direction (a cusp), the half disk ahead of that point belongs to the stroke. A subpath
   * that is a point gives a disk with round caps, a square with square caps, and nothing with butt caps. A width of 0
   * gives the empty path. The boundary lies within the tolerance of the exact one. By default the result is a region as
   * `union` describes it; with `simple: false`, which is faster, its contours overlap, and the nonzero rule fills it.
   *
   * @param width the width everywhere, widths at positions along each subpath, or those on the left and on the right
   * @throws {RangeError} for a negative width, positions that do not ascend from 0 to 1, a miter limit below 1, a dash
   *   pattern with a negative entry or with zeros only, and a tolerance not above 0 or below 4 ulps of the largest
   *   coordinate
   */
  stroke(width: number | WidthProfile | SideWidths, options?: StrokeOptions): this {
    return this._pathOf(strokes.stroke(this._packed, width, options));
  }

  /**
   * Whether a point is in the stroke of the path: hit testing, as `isPointInStroke` of a canvas. It computes distances
   * from the path, and is exact up to rounding. With a profile or two widths it computes the region of `stroke`, and within its
   * tolerance of the boundary the answer may be either.
   */
  strokeContains(point: PointLike, width: number | WidthProfile | SideWidths, options?: StrokeShape): boolean {
    return strokes.strokeContains(this._packed, point, width, options);
  }

  /**
   * The dashes of the path along a pattern of lengths: on, off, on, off … They are open subpaths, cut by arc length with
   * an error of at most 1e-9 of the length of their subpath. On a closed subpath, the dash that reaches the end
   * continues at the start.
   *
   *     Path.polygon([0, 0, 10, 0], { closed: false }).dash([4, 2]).toSVG(); // "M0,0 L4,0 M6,0 L10,0"
   *
   * @param pattern a pattern with an odd number of entries is repeated; an empty one gives the path
   * @param offset the length in the pattern at which each subpath starts, 0 by default
   * @throws {RangeError} for a negative entry, for zeros only, and for more than 2²² dashes
   */
  dash(pattern: ArrayLike<number>, offset?: number): this {
    return this._pathOf(strokes.dash(this._packed, pattern, offset));
  }

  /**
   * The region that the path fills, grown by a distance, or shrunk if it is negative, whatever its orientation. Open
   * subpaths are closed; the nonzero rule applies. A region that is thinner than twice the distance shrinks to the
   * empty path. (`offset` of curves and splines is different: it moves along the normal and trims nothing.)
   *
   *     Path.rect([0, 0], 4, 4).offset(-1).area(); // 4
   */
  offset(distance: number, options?: RegionOffsetOptions): this {
    return this._pathOf(strokes.offset(this._packed, distance, options));
  }

  /**
   * The path with its corners replaced by arcs of a radius that are tangent to both segments at the corner.
   *
   *     Path.rect([0, 0], 10, 10).roundCorners(2).area(); // 96.56637061…
   *
   * A corner is a joint where the tangent turns by 0.06° to 179.94°; other joints stay, and so do the ends of open
   * subpaths. Arcs are cubics within 1e-9 of their radius, or within `tolerance`; segments that no arc replaces are returned bit for bit. An arc
   * replaces at most the 64 segments on each side that follow each other without a corner: where these are too short, or
   * bend more tightly, its radius is the largest one that fits. Where arcs at two corners overlap, one that needs at most
   * half of the segments between them (in the parameter) keeps its radius, and the other one ends where it starts; if both
   * need more, both end in the middle.
   *
   *     Path.rect([0, 0], 10, 10).roundCorners([4, 4, 0, 0]); // on a canvas: top left, top right, bottom right, bottom left
   *     path.roundCorners(({ subpath }) => (subpath === 0 ? 2 : 0));
   *
   * The order of the corners is that of the path: by subpath, then by t; the corner at the start of a closed subpath is its
   * first one. With `corners`, a list has one radius for each of these in their order, and a function is called for these;
   * the largest radius for a joint counts.
   *
   * @param radius in the unit of the path, one for all or one for each corner; 0 leaves a corner
   * @throws {RangeError} for a negative radius, a list of another length, and a corner that is not at a joint
   */
  roundCorners(radius: CornerRadius, options?: CornerOptions): this {
    return this._pathOf(strokes.roundCorners(this._packed, radius, options));
  }

  /**
   * The subpaths as lines and arcs of circles, one list for each, for machines that have no other curves (G-code G1 to
   * G3).
   *
   *     Path.circle([0, 0], 1).toArcs(0.001)[0].length; // 2: half circles
   *
   * Each arc starts where the previous one ends. Within a segment they come in pairs with a common tangent (biarcs),
   * each pair as long as the tolerance permits; straight parts are lines, and neighbouring arcs of one circle are joined,
   * up to half a turn. The Hausdorff distance of a subpath from its arcs is at most the tolerance; the rounding of centre
   * and angles adds some 1e-15 of the radius.
   *
   * @param tolerance the largest distance, in the unit of the path
   * @throws {RangeError} for a tolerance not above 0 or below 4 ulps of the largest coordinate, and for more than 2²² arcs
   */
  toArcs(tolerance: number): CircularArc[][] {
    return arcsOf(this._packed, tolerance);
  }

  /**
   * The path as the `d` attribute of an SVG `<path>`; segments of higher degree become cubics.
   *
   * Without `precision`: "M0,0 L1,0.5 Z", each number with the fewest digits that round-trip, so that `fromSVG` reads
   * an equal path. With it: the shortest form, "M0 0 1 .5Z", with at most that many digits after the decimal point.
   * Cubics that `fromSVG` makes of an arc are written as the arc, so a circle takes two commands; arcs are read up to
   * rounding. Finer cubics of equal angles are written as one arc, too, and read within the tolerance of `fromSVG`. With a
   * number as `arcs`, all segments are written as lines and arcs of circles within that distance.
   */
  override toSVG(options?: PathSvgOptions | ArcSvgOptions): string {
    if (typeof options?.arcs !== "number") return super.toSVG(options as PathSvgOptions | undefined);
    const closed = this.subpaths.map((spline) => spline.closed);
    return svgOfArcs(this.toArcs(options.arcs), closed, options as ArcSvgOptions);
  }

  /**
   * The region that the path fills as shapes of three.js with their holes, for `ShapeGeometry` and `ExtrudeGeometry`:
   * one for each outer contour. Segments above degree 3 become cubics.
   *
   *     const shapes = Path.fromSVG("M0 0H4V4H0Z M1 1V3H3V1Z").toThree(THREE);
   *     new THREE.ExtrudeGeometry(shapes, { depth: 1 });
   *
   * @param THREE the namespace of three.js, or an object with `Shape` and `Path`
   */
  toThree<ShapeClass extends { new (): any; prototype: any }>(
    THREE: ThreeShapes<ShapeClass>,
    options?: RegionOptions,
  ): ShapeClass["prototype"][] {
    return contoursToThree(this.removeOverlaps(options).subpaths, THREE);
  }

  /**
   * The signed area inside, positive for counter-clockwise subpaths (x right, y up), ½∮ x dy − y dx: each point counts
   * with its winding number. With a fill rule, the area of the region that the path fills, which is never negative. Open
   * subpaths are closed by a line.
   *
   *     const twice = Path.fromSVG("M0 0H1V1H0Z M0 0H1V1H0Z");
   *     twice.area(); // 2
   *     twice.area({ fillRule: "nonzero" }); // 1
   */
  override area(options?: RegionOptions): number {
    return hasFillRule(options) ? this.removeOverlaps(options).area() : super.area();
  }

  /**
   * The locations where a coordinate has a local extremum (its derivative changes sign), inside segments and at joints,
   * in the order of the path. The ends of open subpaths do not count. Where the coordinate is constant between
   * increasing and decreasing (the sides of a rectangle), the joints of the constant part are extrema. See
   * `Spline.extrema`.
   */
  extrema(): PathExtrema {
    return extremaOfPath(this.subpaths);
  }

  /**
   * All locations at which a coordinate has the given value, end points and tangencies included, in the order of the
   * path. A joint is reported once, the end of a closed subpath as its start. For a segment on which the coordinate has
   * that value everywhere: its ends.
   *
   * @param where one coordinate and its value
   */
  timesAtCoordinate(where: { x: number } | { y: number }): PathTime[] {
    return timesAtCoordinateOfPath(this.subpaths, where);
  }

  /**
   * The integrals of 1, x, y, x², xy and y² over the inside, weighted as in `area`; the centre of mass is (x, y) /
   * area. With a fill rule, over the region that the path fills.
   */
  moments(options?: RegionOptions): Moments {
    if (hasFillRule(options)) return this.removeOverlaps(options).moments();
    curvesModule.write(this._packed);
    const [area, x, y, xx, xy, yy] = curvesModule.read(0, curvesModule.functions.path_moments());
    return { area, x, y, xx, xy, yy };
  }

  /**
   * The path as the function `shape()` of CSS, for `clip-path` and `shape-outside`, in pixels; an empty path gives
   * "none". For `offset-path`, `path("${path.toSVG()}")` is better: with `shape()`, Chromium 156 draws an
   * `offset-distance` of 100 % at the start of an open path of lines.
   *
   *     Path.fromSVG("M0 0H4V4Z").toCSS(); // "shape(from 0px 0px, line to 4px 0px, line to 4px 4px, close)"
   */
  toCSS(options?: CssOptions): string {
    return cssOf(this._packed, options);
  }

  /**
   * The path as segments of path data, as `getPathData` of SVG elements gives them, with absolute commands M, L, Q, C
   * and Z; segments of higher degree become cubics.
   *
   *     Path.fromSVG("M0 0H4").toPathData(); // [{ type: "M", values: [0, 0] }, { type: "L", values: [4, 0] }]
   *
   * @param options `tolerance`: for degrees above 3, the largest distance of the cubics
   */
  toPathData(options?: { tolerance?: number }): PathSegment[] {
    return pathDataOf(this._packed, options);
  }

  /**
   * The path of segments of path data, as `getPathData` of SVG elements gives them: commands of SVG path data in any
   * form, with their numbers.
   *
   *     Path.fromPathData(document.querySelector("path").getPathData());
   *
   * @param segments `type`: the letter of a command; `values`: the numbers of one such command
   * @throws {RangeError} for an unknown command, and for a wrong number of values
   */
  static fromPathData<P extends CorePath>(
    this: PathClass<P>,
    segments: ArrayLike<PathSegment>,
    options?: ArcOptions,
  ): P {
    const tolerance = check.optionalTolerance(check.options(options, ["tolerance"]).tolerance);
    const packed = readPathData(segments, tolerance);
    checkTolerance(packed, tolerance);
    return pathFrom(this, packed);
  }

  /**
   * An index of paths for hit testing: the nearest path, those that contain a point, and those within a box. It answers in
   * about log n steps for n paths.
   *
   *     const index = Path.index(paths);
   *     const hit = index.nearest([event.offsetX, event.offsetY], { maxDistance: 5 });
   *     const [top] = index.containing([event.offsetX, event.offsetY]);
   */
  static index(paths: ArrayLike<CorePath>): PathIndex {
    if (!Array.isArray(paths)) throw new TypeError(`paths: expected an array of paths, got ${check.describe(paths)}`);
    return new PathIndex(Array.from(paths, (path, k) => measurable(path, `paths[${k}]`)));
  }

  /**
   * A path of fewer lines and cubics: each subpath is simplified as by `Spline.simplify`, so the Hausdorff distance of a
   * subpath from its original is at most the tolerance.
   *
   *     Path.fromSVG(traced).simplify(0.5, { precision: 1 }).toSVG({ precision: 1 });
   *
   * @param tolerance the largest distance, in the unit of the path
   */
  simplify(tolerance: number, options?: SimplifyOptions): this {
    check.positive(tolerance, "tolerance");
    const splines = this.subpaths.map((spline) => spline.simplify(tolerance, options));
    return this._pathOf(packedPaths(splines.map((spline) => packedShape(spline, "splines"))));
  }

  /**
   * All intersections with another path, a spline or a curve of any kind. `t` is a location {subpath, t} on this path; `u` is a
   * location on another path, or the t of a spline or a curve. They are sorted by the subpath of this path, the subpath
   * of the other one, t and u.
   *
   * An intersection at a joint or at the start of a closed subpath is reported once, and so is an end point that both
   * have in common. Subpaths are intersected separately: a point that lies on two of them is reported for each. The
   * lines that would close open subpaths do not count.
   *
   * Pairs of segments are found with a tree of boxes, in about n log n time for n segments. In the worst case each pair
   * of segments is compared, with the limits of `Curve.intersections`.
   *
   * @param other a curve, a spline, a path, or a rational or NURBS curve of `casteljau/nurbs`
   */
  intersections<S extends Shape | RationalCurve | NurbsCurve>(
    other: S,
  ): Intersection<PathTime, S extends CorePath ? PathTime : number>[] {
    return intersectPathWith(this._packed, other) as any;
  }

  /**
   * The points that the path passes twice, on one subpath or on two: at the location `t` and at the later location `u`.
   * Each pair is reported once.
   */
  selfIntersections(): PathIntersection[] {
    return selfIntersectPath(this._packed);
  }

  /**
   * A path of the full class.
   *
   * @internal
   */
  override _pathOf(packed: Float64Array): this {
    return pathOf(packed) as this;
  }

  /**
   * A spline of the full class.
   *
   * @internal
   */
  override _splineOf(data: SplineData): Spline<2> {
    return splineOf(data) as Spline<2>;
  }
}

function hasFillRule(options: RegionOptions | undefined) {
  return check.options(options, ["fillRule"]).fillRule !== undefined;
}

/**
 * A path whose packed form is checked already.
 *
 * @internal
 */
export function pathOf(packed: Float64Array): Path {
  return pathFrom(Path, packed); // outside of the class, see ../curve/curve.js
}

/** A path of any entry point as one that can be searched. */
function measurable(path: unknown, name: string): CorePath {
  return path instanceof CorePath ? path : pathFrom(CorePath, pathData(path, name));
}
