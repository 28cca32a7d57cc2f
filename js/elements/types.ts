// The public types of the elements. They do not mention the libraries that the elements use.

import type { Curve, Spline } from "../index.js";
import type { RationalCurve } from "../nurbs.js";
import type { Surface } from "../surfaces.js";

/**
 * The camera: rotation about the vertical axis and elevation above the horizon in degrees, enlargement (1 shows the whole
 * surface), and the shift of the picture in radii of the surface.
 */
export type SurfaceView = { turn: number; tilt: number; zoom: number; panX: number; panY: number };

/**
 * The result of subdivision until flat: the number of pieces, the depth of the recursion, the number of cracks between
 * pieces, and the width of the widest.
 */
export type SurfaceRecursion = { pieces: number; depth: number; cracks: number; widest: number };

/**
 * The mesh of the picture. `error`: an upper bound of the distance of the surface from the mesh; null if none is known.
 * `ms`: the time of the computation; null if the graphics card evaluates the patches.
 */
export type SurfaceMesh = {
  triangles: number;
  vertices: number;
  ms: number | null;
  error: number | null;
  unit: "" | "px";
  recursion: SurfaceRecursion | null;
};

/**
 * What is shown: the settings, with defaults for invalid values (of segments, tolerance, pixels and flatness the one that is
 * used), and the result. `points`: the control points of the selected patch, or of the first, u along the fast index; `place`:
 * the point and normal of that patch at (u, v).
 */
export interface SurfaceFigure {
  model: string;
  height: string;
  up: string;
  parts: string[];
  segments: number | null;
  tolerance?: number;
  pixels?: number;
  flatness?: number;
  lines: number;
  shading: string;
  layers: string[];
  evaluation: "cpu" | "forward" | "gpu";
  u: number;
  v: number;
  step: number;
  swept: boolean;
  surface: Surface;
  patch: number | null;
  points: [number, number, number][];
  degreeU: number;
  degreeV: number;
  place: { point: [number, number, number]; normal: [number, number, number] } | null;
  probe: number[] | null;
  /** Of the surface to the probe */
  nearest: { patch: number; u: number; v: number; distance: number; point: [number, number, number] } | null;
  mesh: SurfaceMesh;
}

/**
 * `<bezier-surface>`: a surface of Bézier patches in WebGL2. Every attribute is a property of the same name, in camelCase. After an
 * unknown word or a number out of range the last valid value stays in effect, and the console says so once. The events "input" (during a change by the user) and
 * "change" (at its end) bubble; changes by the page do not fire them. "update" follows every change, by the user or by the
 * page, and does not bubble.
 */
export interface SurfaceProperties {
  /** The model that is shown where there is no surface; for the last four, the code for weights is loaded */
  model: "teapot" | "teacup" | "teaspoon" | "patch" | "sphere" | "torus" | "cylinder" | "cone";
  /** The visible parts of the teapot: some of the words "lid rim body handle spout bottom"; null shows all */
  parts: string | null;
  /** The height of the teapot */
  height: "squashed" | "original";
  /** The axis that points up */
  up: "z" | "y";
  /** The number of segments along each direction of a patch, 1 to 64 */
  segments: number;
  /** Instead of segments: the largest distance of the surface from the mesh */
  tolerance: number | null;
  /** The same, in pixels of the picture */
  pixels: number | null;
  /**
   * Instead: patches are split into four until their control points are this close to a plane; the cracks between them
   * are shown
   */
  flatness: number | null;
  /** The number of strips into which the curves divide a patch in each direction, 1 to 12 */
  lines: number;
  /** How the surface is coloured; "curvature" is "gaussian" */
  shading: "smooth" | "flat" | "normals" | "gaussian" | "curvature" | "mean" | "patches";
  /**
   * Some of the words "surface mesh isocurves tubes ribbons net casteljau place derivatives names" (place:
   * the curves through (u, v); derivatives: Su, Sv and the normal there; names: of the points, directions and derivatives)
   */
  show: string;
  /** "cpu": WebAssembly; "forward": WebAssembly, with forward differences; "gpu": the vertex shader */
  evaluation: "cpu" | "forward" | "gpu";
  /** The first parameter of the point that is shown, 0 to 1 */
  u: number;
  /** The second parameter of the point that is shown, 0 to 1 */
  v: number;
  /** The steps of the evaluation that are shown: 1 the first row, 2 all rows, 3 the curve across them, 4 the point */
  step: number;
  /** Whether only the part of the surface from 0 to u is drawn */
  swept: boolean;
  /** "x y z": a point; the nearest point of the surface is shown */
  probe: string | null;
  /** The patch whose control points can be dragged; null for none */
  patch: number | null;
  /**
   * Whether the control panel is shown; some of the words "shape shading place model mesh show probe edit files" show only
   * these groups, "place:u show:surface,net" only these parts of them
   */
  controls: string | boolean | null;
  /** Whether the surface rotates; it does not start by itself for users who prefer reduced motion */
  autoRotate: boolean;
  /** The name of the picture for screen readers */
  label: string;
  /** The colours; "auto" follows the color scheme of the user */
  theme: "light" | "dark" | "auto";
  /** The surface that is shown, with moved points; null shows the model. A `RationalSurface` is shown as soon as the code for weights is loaded; functions of its curves need an import of `casteljau/nurbs` */
  surface: Surface | null;
  /** The camera's position */
  view: SurfaceView;
  /** What is shown, as plain values; read-only */
  figure: SurfaceFigure;
  /** Takes back the last change of points, settings or file by the user */
  undo: () => void;
  /** Repeats the change that was taken back */
  redo: () => void;
  /** The picture as a PNG; null before it is drawn */
  toBlob: () => Promise<Blob | null>;
}

export type JointMode = "free" | "g1" | "c1" | "c2" | "g2" | "auto";

/** What a `<bezier-applet>` shows. */
export interface AppletFigure {
  /** The shown control points */
  points: [number, number][];
  /** Their number */
  shown: number;
  basis: string;
  /** The degree of the segments */
  degree: number;
  /** 16 numbers M, row-major: each segment is [t³ t² t 1]·M·P of its four points; null without a matrix */
  matrix: number[] | null;
  t: number;
  /** The segment to which t refers */
  segment: number;
  /** The names of the points */
  names: string[];
  /** For each point whether it is on the curve, off it, or waits for more points */
  kinds: ("on" | "off" | "wait")[];
  /** The segments in Bézier form, each with the points that define it; none with weights */
  pieces: { curve: Curve; indices: number[] }[];
  /** Instead of these, the segments of points with weights, once the code for weights is loaded */
  rational: { curve: RationalCurve<2>; indices: number[] }[];
  /** The weights of the points; null without weights */
  weights: number[] | null;
  /** The segments as one spline; null if they do not meet */
  spline: Spline | null;
  /** The continuity at each inner joint */
  continuity: ReturnType<Spline["continuity"]>[];
  /**
   * The adaptive subdivision, if it is shown: the number of segments of its polyline, and their distance from the
   * curve
   */
  tree: { segments: number; error: number } | null;
}

/**
 * `<bezier-applet>`: control points to drag, their curve, and its construction and measures. An attribute that is invalid
 * leaves the last valid value in effect; a message below the picture and, once, a warning in the console say so. The events "input" (during a change by the
 * user) and "change" (at its end) bubble; "update" follows every change, by the user or by the page, and does not bubble.
 */
export interface AppletProperties {
  /** All control points in a box of 670 × 480, y down; as an attribute "x,y x,y …" */
  points: [number, number][];
  /**
   * The weights of all control points for the basis "bezier", 0.001 to 1000: the segments are then rational curves, and each weight is
   * dragged on the leg of the control polygon before its point. Empty: curves without weights
   */
  weights: number[];
  /** The number of points that are shown; null for all */
  visiblePoints: number | null;
  /** How the points determine the curve */
  basis: "bezier" | "hermite" | "b-spline" | "catmull-rom" | "natural" | "centripetal" | "matrix";
  /** 16 numbers for the basis "matrix", row-major: [t³ t² t 1]·M·P */
  matrix: number[];
  /** 1 to 64, or "n": one curve with all points */
  degree: number | "n";
  /** The continuity that is kept at each inner joint; as an attribute words, the last one for all further joints */
  joints: JointMode[];
  /** From 0 to 1; from −0.5 to 1.5 if the extrapolation is shown */
  t: number;
  /** The number of the segment to which t refers, from 0 */
  segment: number;
  /**
   * Some of the words "polygon hull construction halves weights tangents normals comb bounds extrema inflections tree segments
   * nearest offset ticks envelope extrapolation names"
   */
  show: string;
  /** The notation of the points */
  labels: "P0" | "P1" | "b0" | "p0" | "none";
  /** The tolerance of the adaptive subdivision, 0.01 to 200 pixels */
  tolerance: number;
  /** The number of segments of the uniform polyline, 1 to 200 */
  segments: number;
  /** The distance of the offset curve, −500 to 500 */
  offset: number;
  /** The number of parts of equal length, 1 to 200 */
  ticks: number;
  /** The visible part; as an attribute "x y width height" */
  view: { x: number; y: number; width: number; height: number };
  /**
   * Whether the control panel is shown; some of the words "joints t points curve show save coordinates zoom" show only
   * these groups, "show:polygon,hull" only these parts of one
   */
  controls: string | boolean | null;
  /** Whether the points cannot be moved */
  readonly: boolean;
  /** "off": only the arrow keys work */
  hotkeys: "on" | "off";
  /** The colours; "auto" follows the color scheme of the user */
  theme: "light" | "dark" | "auto";
  /** The name of the picture for screen readers */
  label: string;
  /** All settings and points, as plain data */
  state: Record<string, unknown>;
  /** What is shown; read-only */
  figure: AppletFigure;
  /** Takes back the last change */
  undo: () => void;
  /** Repeats the change that was taken back */
  redo: () => void;
  /** Restores the state before the first action of the user */
  reset: () => void;
  /** Moves all points to random positions; equal seeds give equal points */
  randomize: (seed?: number) => void;
  /** Shows both parts at t, and returns those of the selected segment */
  split: (t?: number) => [Curve, Curve] | [RationalCurve<2>, RationalCurve<2>];
  /** Splits the selected segment at t; the shape stays the same */
  insertJoint: (t?: number) => void;
  /** Removes a point */
  removePoint: (index: number) => void;
  /** Appends a point */
  appendPoint: (point: [number, number]) => void;
  /** Switches between the points of one curve and all points */
  toggleAllPoints: () => void;
  /** The property `state` */
  toJSON: () => Record<string, unknown>;
  /** The picture as an SVG document */
  toSVG: () => Promise<string>;
  /** The picture as a PNG */
  toBlob: () => Promise<Blob | null>;
  /** A program that draws the same curve */
  toCode: (language: "js" | "rust" | "canvas") => Promise<string>;
  /** Changes values as a user does, with events; the values are those of the state */
  edit: (
    what: {
      index?: number;
      point?: [number, number];
      t?: number;
      points?: [number, number][];
      weights?: number[];
      basis?: string;
      matrix?: number[];
    },
    done?: boolean,
  ) => void;
}

export type BezierAppletElement = HTMLElement & AppletProperties;
export type BezierAppletConstructor = { new (): BezierAppletElement; prototype: BezierAppletElement };

export type BezierSurfaceElement = HTMLElement & SurfaceProperties;
export type BezierSurfaceConstructor = { new (): BezierSurfaceElement; prototype: BezierSurfaceElement };
