// What pages see of the elements: types alone, which name nothing of the libraries inside.

/**
 * @import { Curve, Spline, Surface } from "../index.js"
 */

/**
 * Where the eye is: degrees about the upright axis and above the horizon, enlargement (1: all of it), and the picture's
 * shift in radii of the surface.
 *
 * @typedef {{ turn: number, tilt: number, zoom: number, panX: number, panY: number }} SurfaceView
 */

/**
 * What the text's recursion has left: its pieces, how often a patch was halved, the gaps between pieces and the widest.
 *
 * @typedef {{ pieces: number, depth: number, cracks: number, widest: number }} SurfaceRecursion
 */

/**
 * What the picture is made of. `error`: the greatest distance of the surface from the mesh is not above it; null where no
 * bound is known. `ms`: how long the core took, null where the graphics card makes the mesh.
 *
 * @typedef {{ triangles: number, vertices: number, ms: number | null, error: number | null, unit: "" | "px", recursion: SurfaceRecursion | null }} SurfaceMesh
 */

/**
 * What is shown, for pages that judge it: the settings after words and numbers that mean nothing were replaced (of segments,
 * tolerance, pixels and flatness the one that counts), and what they make. `points`: the control points of the picked patch,
 * or of the first, u along the fast index; `place`: that patch at (u, v).
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
 * word or a number out of range counts as the default. Events "input" (while something moves) and "change" (when it is
 * done) tell what the user does, and bubble; what the page writes fires none. "update" follows every change, whoever made it,
 * and does not bubble.
 *
 * @typedef {object} SurfaceProperties
 * @property {string} model "teapot", "teacup", "teaspoon" or "patch"
 * @property {string | null} parts of the teapot: words of "lid rim body handle spout bottom"; null for all
 * @property {string} height of the teapot: "squashed" or "original"
 * @property {string} up the axis that points up: "z" or "y"
 * @property {number} segments cells along each direction of a patch, 1 to 64
 * @property {number | null} tolerance instead of the segments: the surface is nowhere farther from the mesh
 * @property {number | null} pixels the same, in pixels of the picture
 * @property {number | null} flatness instead: patches are cut in four until their points are so near to a plane, as tutorials
 *   do it; the cracks are shown
 * @property {number} lines strips of a patch that curves and tubes divide it into each way, 1 to 12
 * @property {string} shading "smooth", "flat", "normals", "gaussian" (also "curvature"), "mean" or "patches"
 * @property {string} show words of "surface mesh isocurves tubes ribbons net casteljau place derivatives names" (place: the curves
 *   through u, v; derivatives: Su, Sv and the normal there; names: of the points, directions and derivatives shown)
 * @property {string} evaluation "cpu": by the package; "forward": by it, with forward differences; "gpu": by the vertex shader
 * @property {number} u where de Casteljau's grid is shown
 * @property {number} v where de Casteljau's grid is shown
 * @property {number} step how much of it: 1 the first row, 2 all rows, 3 the curve across them, 4 its point
 * @property {boolean} swept whether only what the curve of constant u has swept on its way from 0 is drawn
 * @property {string | null} probe "x y z": a point whose nearest one of the surface is shown
 * @property {number | null} patch whose control points have handles; null for none
 * @property {boolean} controls whether the panel is shown
 * @property {boolean} turn whether the picture turns by itself; not at once for those who want less motion
 * @property {string} label what screen readers call the picture
 * @property {Surface | null} surface what is shown, moved points included; null: the model
 * @property {SurfaceView} view the camera's position
 * @property {SurfaceFigure} figure what is shown, as plain values; read-only
 * @property {() => Promise<Blob | null>} toBlob the picture as a PNG; null before there is one
 */

/** @typedef {"free" | "g1" | "c1" | "c2" | "g2" | "auto"} JointMode */

/**
 * What a `<bezier-applet>` shows, for companions and pages.
 *
 * @typedef {object} AppletFigure
 * @property {[number, number][]} points the shown control points
 * @property {number} shown how many
 * @property {string} basis
 * @property {number} degree of the pieces
 * @property {number[] | null} matrix 16 numbers M, row-major: each piece is [t³ t² t 1]·M·P of its four points; null where there is no such
 * @property {number} t
 * @property {number} segment the piece that t is about
 * @property {string[]} names of the points
 * @property {("on" | "off" | "wait")[]} kinds of the points: on the curve, off it, waiting for more points
 * @property {{ curve: Curve, indices: number[] }[]} pieces in Bézier form, with the points that each is made of
 * @property {Spline | null} spline the pieces as one chain; null where they do not meet
 * @property {ReturnType<Spline["continuity"]>[]} continuity at each inner joint
 * @property {{ segments: number, error: number } | null} tree of the subdivision, where it is shown: its polyline's segments, and
 *   how far it is from the curve
 */

/**
 * `<bezier-applet>`: control points that are dragged, the curve that they mean, and what there is to see about it. Attributes
 * are read as any text: what cannot be used counts as the last good one, and is told below the picture. Events "input" (while
 * something moves) and "change" (when it is done) tell what the user does, and bubble; "update" follows every change, whoever
 * made it, and does not bubble.
 *
 * @typedef {object} AppletProperties
 * @property {[number, number][]} points all control points, 670 × 480, y down; an attribute "x,y x,y …"
 * @property {string} mode how many of them are shown; "" for all
 * @property {string} basis "bezier", "hermite", "b-spline", "catmull-rom", "natural", "centripetal" or "matrix"
 * @property {string} matrix 16 numbers for the basis "matrix", row-major: [t³ t² t 1]·M·P
 * @property {string} degree 1 to 64, or "n": one curve
 * @property {JointMode[]} joints what is held at each inner joint; as an attribute words, the last one for all further joints
 * @property {number} t from 0 to 1; half beyond both ends where the extrapolation is shown
 * @property {string} segment the number of the piece that t is about, from 0
 * @property {string} show words of "polygon hull scaffold halves weights tangents normals comb bounds extrema inflections tree segments
 *   nearest offset ticks envelope extrapolation names"
 * @property {string} labels the notation: "P0", "P1", "b0", "p0" or "none"
 * @property {string} tolerance of the tree, in pixels
 * @property {string} segments of the uniform polyline
 * @property {string} offset the distance of the parallel
 * @property {string} ticks parts of equal length
 * @property {string} view what is seen: "x y width height"
 * @property {string | boolean | null} controls whether the panel is shown; words of "joints t points curve show save coordinates
 *   zoom" show these groups only
 * @property {boolean} readonly whether the points stay where they are
 * @property {string} hotkeys "off": no keys but the arrows
 * @property {string} theme "light", "dark" or "auto"
 * @property {string} label what screen readers call the picture
 * @property {Record<string, unknown>} state everything, as plain data
 * @property {AppletFigure} figure what is shown; read-only
 * @property {() => void} undo takes back the last change
 * @property {() => void} redo repeats the change that was taken back
 * @property {() => void} reset everything as it was at first
 * @property {(seed?: number) => void} randomize puts all points at random positions; equal seeds give equal points
 * @property {(t?: number) => [Curve, Curve]} split shows the halves at t, and returns those of the selected segment
 * @property {(t?: number) => void} insert cuts the selected segment; the curve stays as it is
 * @property {(index?: number) => void} remove a point; the curve heals. Without an index the element itself, as every element
 * @property {(...what: (Node | string | [number, number])[]) => void} append a point; nodes go into the element, as into every one
 * @property {() => void} toggleMode few points, or all
 * @property {() => Record<string, unknown>} toJSON the property `state`, for JSON
 * @property {() => Promise<string>} toSVG the picture with all its layers
 * @property {() => Promise<Blob | null>} toBlob the same as a PNG
 * @property {(language: "js" | "rust" | "canvas") => Promise<string>} toCode a program that makes the same curve
 * @property {(what: { index?: number, point?: [number, number], t?: number, points?: [number, number][], basis?: string, matrix?: number[] }, done?: boolean) => void} steer as if the user did it; values are written as in the state
 */

/** @typedef {Omit<HTMLElement, "append" | "remove"> & AppletProperties} BezierAppletElement */
/** @typedef {{ new (): BezierAppletElement, prototype: BezierAppletElement }} BezierAppletConstructor */

/** @typedef {HTMLElement & SurfaceProperties} BezierSurfaceElement */
/** @typedef {{ new (): BezierSurfaceElement, prototype: BezierSurfaceElement }} BezierSurfaceConstructor */

export {};
