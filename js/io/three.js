// Meshes as geometry of three.js, whose names the caller hands over: this package does not depend on it.
import * as check from "../geometry/check.js";

/**
 * @import { Mesh } from "../geometry/mesh.js"
 */

/**
 * What is used of a geometry.
 *
 * @template Attribute
 * @typedef {{ setAttribute(name: string, attribute: Attribute): unknown, setIndex(attribute: Attribute): unknown }} GeometryLike
 */

/**
 * What is used of three.js.
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
    throw new TypeError(`THREE: expected the namespace of three.js, got ${check.shown(THREE)}`);
  }
  const geometry = new THREE.BufferGeometry();
  // WebGL knows no numbers of 64 bits.
  const floats = (/** @type {Float32Array | Float64Array} */ list) =>
    list instanceof Float32Array ? list : Float32Array.from(list);
  geometry.setAttribute("position", new THREE.BufferAttribute(floats(positions), 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(floats(normals), 3));
  if (uvs) geometry.setAttribute("uv", new THREE.BufferAttribute(uvs, 2));
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  return geometry;
}
