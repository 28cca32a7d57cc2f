// What pages see of the elements: types alone, which name nothing of the libraries inside.

/**
 * @import { Surface } from "../index.js"
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
 * @property {string} show words of "surface mesh isocurves tubes ribbons net casteljau derivatives" (the last: ∂u, ∂v and the
 *   normal at u, v)
 * @property {string} evaluation "cpu": by the package; "forward": by it, with forward differences; "gpu": by the vertex shader
 * @property {number} u where de Casteljau's grid is shown
 * @property {number} v
 * @property {number} step how much of it: 1 the rows, 2 their points, 3 the curve, 4 its point
 * @property {boolean} swept whether only what the curve of constant u has swept on its way from 0 is drawn
 * @property {number | null} patch whose control points have handles; null for none
 * @property {boolean} controls whether the panel is shown
 * @property {boolean} turn whether the picture turns by itself; not at once for those who want less motion
 * @property {string} label what screen readers call the picture
 * @property {Surface | null} surface what is shown, moved points included; null: the model
 * @property {SurfaceView} view
 * @property {SurfaceFigure} figure what is shown, as plain values; read-only
 * @property {() => Promise<Blob | null>} toBlob the picture as a PNG; null before there is one
 */

/** @typedef {HTMLElement & SurfaceProperties} BezierSurfaceElement */
/** @typedef {{ new (): BezierSurfaceElement, prototype: BezierSurfaceElement }} BezierSurfaceConstructor */

export {};
