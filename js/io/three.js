// Meshes, paths and curves as objects of three.js. The caller passes its namespace, so this package does not depend on
// three.js.
import * as check from "../geometry/check.js";

/**
 * @import { Point } from "../geometry/points.js"
 * @import { Spline } from "../geometry/spline/spline.js"
 * @import { Mesh } from "../geometry/mesh.js"
 */

/**
 * The classes of three.js that are used: the namespace of three.js, or an object with these two.
 *
 * @template {{ new (): any, prototype: any }} [GeometryClass={ new (): any, prototype: any }]
 * @typedef {object} Three
 * @property {GeometryClass} BufferGeometry whose `prototype` is an instance for any type parameters (`InstanceType`
 *   would be one for their constraints)
 * @property {new (array: any, itemSize: number) => any} BufferAttribute
 */

/**
 * @internal
 * @template {{ new (): any, prototype: any }} GeometryClass
 * @param {Mesh} mesh
 * @param {Three<GeometryClass>} THREE
 * @returns {GeometryClass["prototype"]}
 */
export function meshToThree({ positions, normals, uvs, indices }, THREE) {
  requireClasses(THREE, ["BufferGeometry", "BufferAttribute"]);
  const geometry = new THREE.BufferGeometry();
  // WebGL has no f64 attributes.
  const floats = (/** @type {Float32Array | Float64Array} */ list) =>
    list instanceof Float32Array ? list : Float32Array.from(list);
  geometry.setAttribute("position", new THREE.BufferAttribute(floats(positions), 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(floats(normals), 3));
  if (uvs) geometry.setAttribute("uv", new THREE.BufferAttribute(uvs, 2));
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  return geometry;
}

/**
 * The classes of three.js that `Path.toThree` uses: the namespace of three.js, or an object with these two.
 *
 * @template {{ new (): any, prototype: any }} [ShapeClass={ new (): any, prototype: any }]
 * @typedef {object} ThreeShapes
 * @property {ShapeClass} Shape
 * @property {{ new (): any }} Path
 */

/**
 * The classes of three.js that `toThree` of a curve and a spline uses: the namespace of three.js, or an object with
 * these three.
 *
 * @template {{ prototype: any }} [CurveClass={ prototype: any }]
 * @typedef {object} ThreeCurves
 * @property {CurveClass} Curve
 * @property {{ new (x: number, y: number): any }} Vector2
 * @property {{ new (x: number, y: number, z: number): any }} Vector3
 */

/**
 * @param {any} THREE
 * @param {readonly string[]} names
 */
function requireClasses(THREE, names) {
  if (names.every((name) => typeof THREE?.[name] === "function")) return;
  throw new TypeError(`THREE: expected the namespace of three.js, got ${check.describe(THREE)}`);
}

/**
 * The shapes of simple contours, each outer one followed by its holes.
 *
 * @internal
 * @template {{ new (): any, prototype: any }} ShapeClass
 * @param {readonly Spline[]} contours
 * @param {ThreeShapes<ShapeClass>} THREE
 * @returns {ShapeClass["prototype"][]}
 */
export function contoursToThree(contours, THREE) {
  requireClasses(THREE, ["Shape", "Path"]);
  /** @type {ShapeClass["prototype"][]} */
  const shapes = [];
  for (const contour of contours) {
    const isOuter = contour.area() >= 0;
    const target = isOuter ? new THREE.Shape() : new THREE.Path();
    contour.trace(target);
    if (isOuter) shapes.push(target);
    else shapes.at(-1)?.holes.push(target);
  }
  return shapes;
}

/**
 * What `toThree` needs of a curve or a spline.
 *
 * @typedef {object} Curved
 * @property {2 | 3} dimension
 * @property {(t: number) => Point} eval
 * @property {(t: number) => Point} tangent
 * @property {() => number} length
 * @property {(s: number) => number} timeAtLength
 */

/**
 * @internal
 * @template {{ prototype: any }} CurveClass
 * @param {Curved} curve
 * @param {number} end the parameter of the end
 * @param {ThreeCurves<CurveClass>} THREE
 * @returns {CurveClass["prototype"]}
 */
export function curveToThree(curve, end, THREE) {
  requireClasses(THREE, ["Curve", "Vector2", "Vector3"]);
  const vector = (/** @type {{ x: number, y: number, z?: number }} */ { x, y, z = 0 }, /** @type {any} */ target) =>
    target ? target.set(x, y, z) : curve.dimension === 2 ? new THREE.Vector2(x, y) : new THREE.Vector3(x, y, z);
  return Object.assign(new /** @type {any} */ (THREE.Curve)(), {
    getPoint: (/** @type {number} */ t, /** @type {any} */ target) => vector(curve.eval(t * end), target),
    getTangent: (/** @type {number} */ t, /** @type {any} */ target) => vector(curve.tangent(t * end), target),
    getLength: () => curve.length(),
    getUtoTmapping: (/** @type {number} */ u, /** @type {number | null | undefined} */ distance) =>
      curve.timeAtLength(distance ?? u * curve.length()) / end,
  });
}
