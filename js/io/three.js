// Meshes as geometries of three.js. The caller passes its namespace, so this package does not depend on three.js.
import * as check from "../geometry/check.js";

/**
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
  const names = /** @type {const} */ (["BufferGeometry", "BufferAttribute"]);
  if (!names.every((name) => typeof THREE?.[name] === "function")) {
    throw new TypeError(`THREE: expected the namespace of three.js, got ${check.describe(THREE)}`);
  }
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
