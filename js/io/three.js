// Meshes as geometries of three.js. The caller passes its namespace, so this package does not depend on three.js.
import * as check from "../geometry/check.js";

/**
 * @import { Mesh } from "../geometry/mesh.js"
 */

/**
 * The methods of a geometry that are used.
 *
 * @template Attribute
 * @typedef {{ setAttribute(name: string, attribute: Attribute): unknown, setIndex(attribute: Attribute): unknown }} GeometryLike
 */

/**
 * The classes of three.js that are used.
 *
 * @template Attribute
 * @template {GeometryLike<Attribute>} Geometry
 * @typedef {{ BufferGeometry: new () => Geometry, BufferAttribute: new (array: any, itemSize: number) => Attribute }} Three
 */

/**
 * @internal
 * @template Attribute
 * @template {GeometryLike<Attribute>} Geometry
 * @param {Mesh} mesh
 * @param {Three<Attribute, Geometry>} THREE
 * @returns {Geometry}
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
