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
 * `<bezier-surface>`: a surface of Bézier patches in WebGL2. Every attribute is a property of the same name; an unknown
 * word or a number out of range counts as the default. Events "input" (while something moves) and "change" (when it is
 * done) tell what the user does, and bubble; what the page writes fires none.
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
 * @property {string} show words of "surface mesh isocurves tubes net casteljau"
 * @property {string} evaluation "cpu": by the package; "forward": by it, with forward differences; "gpu": by the vertex shader
 * @property {number} u where de Casteljau's grid is shown
 * @property {number} v
 * @property {number} step how much of it: 1 the rows, 2 their points, 3 the curve, 4 its point
 * @property {number | null} patch whose control points have handles; null for none
 * @property {boolean} controls whether the panel is shown
 * @property {boolean} turn whether the picture turns by itself; not at once for those who want less motion
 * @property {string} label what screen readers call the picture
 * @property {Surface | null} surface what is shown, moved points included; null: the model
 * @property {SurfaceView} view
 * @property {() => Promise<Blob | null>} toBlob the picture as a PNG; null before there is one
 */

/** @typedef {HTMLElement & SurfaceProperties} BezierSurfaceElement */
/** @typedef {{ new (): BezierSurfaceElement, prototype: BezierSurfaceElement }} BezierSurfaceConstructor */

export {};
