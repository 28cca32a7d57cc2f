// The public types of the elements. They do not mention the libraries that the elements use.

/**
 * @import { Curve, Spline } from "../paths.js"
 * @import { Surface } from "../surfaces.js"
 */

/**
 * The camera: rotation about the vertical axis and elevation above the horizon in degrees, enlargement (1 shows the whole
 * surface), and the shift of the picture in radii of the surface.
 *
 * @typedef {{ turn: number, tilt: number, zoom: number, panX: number, panY: number }} SurfaceView
 */

/**
 * The result of subdivision until flat: the number of pieces, the depth of the recursion, the number of cracks between
 * pieces, and the width of the widest.
 *
 * @typedef {{ pieces: number, depth: number, cracks: number, widest: number }} SurfaceRecursion
 */

/**
 * The mesh of the picture. `error`: an upper bound of the distance of the surface from the mesh; null if none is known.
 * `ms`: the time of the computation; null if the graphics card evaluates the patches.
 *
 * @typedef {{ triangles: number, vertices: number, ms: number | null, error: number | null, unit: "" | "px", recursion: SurfaceRecursion | null }} SurfaceMesh
 */

/**
 * What is shown: the settings, with defaults for invalid values (of segments, tolerance, pixels and flatness the one that is
 * used), and the result. `points`: the control points of the selected patch, or of the first, u along the fast index; `place`:
 * the point and normal of that patch at (u, v).
 *
 * @typedef {object} SurfaceFigure
 * @property {string} model
 * @property {string} height
 * @property {string} up
 * @property {string[]} parts
 * @property {number | null} segments
 * @property {number} [tolerance]
 * @property {number} [pixels]
 * @property {number} [flatness]
 * @property {number} lines
 * @property {string} shading
 * @property {string[]} layers
 * @property {string} evaluation
 * @property {number} u
 * @property {number} v
 * @property {number} step
 * @property {boolean} swept
 * @property {Surface} surface
 * @property {number | null} patch
 * @property {[number, number, number][]} points
 * @property {number} degreeU
 * @property {number} degreeV
 * @property {{ point: [number, number, number], normal: [number, number, number] } | null} place
 * @property {number[] | null} probe
 * @property {{ patch: number, u: number, v: number, distance: number, point: [number, number, number] } | null} nearest of the
 *   surface to the probe
 * @property {SurfaceMesh} mesh
 */

/**
 * `<bezier-surface>`: a surface of Bézier patches in WebGL2. Every attribute is a property of the same name; an unknown
 * word or a number out of range has the effect of the default. The events "input" (during a change by the user) and
 * "change" (at its end) bubble; changes by the page do not fire them. "update" follows every change, by the user or by the
 * page, and does not bubble.
 *
 * @typedef {object} SurfaceProperties
 * @property {string} model "teapot", "teacup", "teaspoon" or "patch"
 * @property {string | null} parts the visible parts of the teapot: some of the words "lid rim body handle spout bottom"; null shows all
 * @property {string} height the height of the teapot: "squashed" or "original"
 * @property {string} up the axis that points up: "z" or "y"
 * @property {number} segments the number of segments along each direction of a patch, 1 to 64
 * @property {number | null} tolerance instead of segments: the largest distance of the surface from the mesh
 * @property {number | null} pixels the same, in pixels of the picture
 * @property {number | null} flatness instead: patches are split into four until their control points are this close to a
 *   plane; the cracks between them are shown
 * @property {number} lines the number of strips into which the curves divide a patch in each direction, 1 to 12
 * @property {string} shading "smooth", "flat", "normals", "gaussian" (also "curvature"), "mean" or "patches"
 * @property {string} show some of the words "surface mesh isocurves tubes ribbons net casteljau place derivatives names" (place:
 *   the curves through (u, v); derivatives: Su, Sv and the normal there; names: of the points, directions and derivatives)
 * @property {string} evaluation "cpu": WebAssembly; "forward": WebAssembly, with forward differences; "gpu": the vertex shader
 * @property {number} u the first parameter of the point that is shown, 0 to 1
 * @property {number} v the second parameter of the point that is shown, 0 to 1
 * @property {number} step the steps of the evaluation that are shown: 1 the first row, 2 all rows, 3 the curve across them, 4 the point
 * @property {boolean} swept whether only the part of the surface from 0 to u is drawn
 * @property {string | null} probe "x y z": a point; the nearest point of the surface is shown
 * @property {number | null} patch the patch whose control points can be dragged; null for none
 * @property {boolean} controls whether the control panel is shown
 * @property {boolean} turn whether the surface rotates; it does not start by itself for users who prefer reduced motion
 * @property {string} label the name of the picture for screen readers
 * @property {Surface | null} surface the surface that is shown, with moved points; null shows the model
 * @property {SurfaceView} view the camera's position
 * @property {SurfaceFigure} figure what is shown, as plain values; read-only
 * @property {() => Promise<Blob | null>} toBlob the picture as a PNG; null before it is drawn
 */

/** @typedef {"free" | "g1" | "c1" | "c2" | "g2" | "auto"} JointMode */

/**
 * What a `<bezier-applet>` shows.
 *
 * @typedef {object} AppletFigure
 * @property {[number, number][]} points the shown control points
 * @property {number} shown their number
 * @property {string} basis
 * @property {number} degree the degree of the segments
 * @property {number[] | null} matrix 16 numbers M, row-major: each segment is [t³ t² t 1]·M·P of its four points; null without a matrix
 * @property {number} t
 * @property {number} segment the segment to which t refers
 * @property {string[]} names the names of the points
 * @property {("on" | "off" | "wait")[]} kinds for each point whether it is on the curve, off it, or waits for more points
 * @property {{ curve: Curve, indices: number[] }[]} pieces the segments in Bézier form, each with the points that define it
 * @property {Spline | null} spline the segments as one spline; null if they do not meet
 * @property {ReturnType<Spline["continuity"]>[]} continuity the continuity at each inner joint
 * @property {{ segments: number, error: number } | null} tree the adaptive subdivision, if it is shown: the number of segments
 *   of its polyline, and their distance from the curve
 */

/**
 * `<bezier-applet>`: control points to drag, their curve, and its construction and measures. An attribute that is invalid
 * leaves the last valid value in effect, and a message below the picture says so. The events "input" (during a change by the
 * user) and "change" (at its end) bubble; "update" follows every change, by the user or by the page, and does not bubble.
 *
 * @typedef {object} AppletProperties
 * @property {[number, number][]} points all control points in a box of 670 × 480, y down; as an attribute "x,y x,y …"
 * @property {string} mode the number of points that are shown; "" for all
 * @property {string} basis "bezier", "hermite", "b-spline", "catmull-rom", "natural", "centripetal" or "matrix"
 * @property {string} matrix 16 numbers for the basis "matrix", row-major: [t³ t² t 1]·M·P
 * @property {string} degree 1 to 64, or "n": one curve with all points
 * @property {JointMode[]} joints the continuity that is kept at each inner joint; as an attribute words, the last one for all further joints
 * @property {number} t from 0 to 1; from −0.5 to 1.5 if the extrapolation is shown
 * @property {string} segment the number of the segment to which t refers, from 0
 * @property {string} show some of the words "polygon hull construction halves weights tangents normals comb bounds extrema inflections tree segments
 *   nearest offset ticks envelope extrapolation names"
 * @property {string} labels the notation: "P0", "P1", "b0", "p0" or "none"
 * @property {string} tolerance the tolerance of the adaptive subdivision, in pixels
 * @property {string} segments the number of segments of the uniform polyline
 * @property {string} offset the distance of the offset curve
 * @property {string} ticks the number of parts of equal length
 * @property {string} view the visible part: "x y width height"
 * @property {string | boolean | null} controls whether the control panel is shown; some of the words "joints t points curve show save
 *   coordinates zoom" show only these groups
 * @property {boolean} readonly whether the points cannot be moved
 * @property {string} hotkeys "off": only the arrow keys work
 * @property {string} theme "light", "dark" or "auto"
 * @property {string} label the name of the picture for screen readers
 * @property {Record<string, unknown>} state all settings and points, as plain data
 * @property {AppletFigure} figure what is shown; read-only
 * @property {() => void} undo takes back the last change
 * @property {() => void} redo repeats the change that was taken back
 * @property {() => void} reset restores the state before the first action of the user
 * @property {(seed?: number) => void} randomize moves all points to random positions; equal seeds give equal points
 * @property {(t?: number) => [Curve, Curve]} split shows both parts at t, and returns those of the selected segment
 * @property {(t?: number) => void} insert splits the selected segment at t; the shape stays the same
 * @property {(index?: number) => void} remove removes a point; without an index removes the element, as `Element.remove`
 * @property {(...what: (Node | string | [number, number])[]) => void} append appends a point; nodes are appended to the element, as by `Element.append`
 * @property {() => void} toggleMode switches between the points of one curve and all points
 * @property {() => Record<string, unknown>} toJSON the property `state`
 * @property {() => Promise<string>} toSVG the picture as an SVG document
 * @property {() => Promise<Blob | null>} toBlob the picture as a PNG
 * @property {(language: "js" | "rust" | "canvas") => Promise<string>} toCode a program that draws the same curve
 * @property {(what: { index?: number, point?: [number, number], t?: number, points?: [number, number][], basis?: string, matrix?: number[] }, done?: boolean) => void} steer changes values as a user does, with events; the values are those of the state
 */

/** @typedef {Omit<HTMLElement, "append" | "remove"> & AppletProperties} BezierAppletElement */
/** @typedef {{ new (): BezierAppletElement, prototype: BezierAppletElement }} BezierAppletConstructor */

/** @typedef {HTMLElement & SurfaceProperties} BezierSurfaceElement */
/** @typedef {{ new (): BezierSurfaceElement, prototype: BezierSurfaceElement }} BezierSurfaceConstructor */

export {};
