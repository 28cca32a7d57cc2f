// Functions that the writers of mesh files share: checks of the arrays, conversion to f32, the size limit.

/**
 * @import { Mesh } from "../geometry/mesh.js"
 */

/** The largest file: 1 GiB. */
const MAX_BYTES = 2 ** 30;

/**
 * The bytes of a file, filled with zeros. Throws a RangeError if it is too long.
 *
 * @internal
 * @param {number} length
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function newFile(length) {
  if (length > MAX_BYTES) throw new RangeError(`bytes: expected at most ${MAX_BYTES}, this needs ${length}`);
  return new Uint8Array(length);
}

/**
 * Converts numbers to f32; a Float32Array is returned unchanged.
 *
 * @internal
 * @param {Float32Array | Float64Array} numbers
 * @param {string} name
 * @returns {Float32Array}
 */
export function toFloat32Array(numbers, name) {
  if (numbers instanceof Float32Array) return numbers;
  const floats = Float32Array.from(numbers);
  const bad = floats.findIndex((x) => !Number.isFinite(x));
  if (bad < 0) return floats;
  throw new RangeError(`${name}: expected numbers that 32 bits can hold, got ${numbers[bad]}`);
}

/**
 * Throws a RangeError if the arrays of a mesh, which users can change, do not match.
 *
 * @internal
 * @param {Mesh} mesh
 * @param {Uint16Array | Uint32Array} faces
 * @param {number} corners the number of corners of a face
 */
export function checkMesh({ positions, normals, uvs }, faces, corners) {
  const vertices = positions.length / 3;
  checkCount("positions", "3 numbers for each vertex", positions, 3 * Math.floor(vertices));
  checkCount("normals", "3 numbers for each vertex", normals, positions.length);
  if (uvs) checkCount("uvs", "2 numbers for each vertex", uvs, 2 * vertices);
  checkCount("indices", `${corners} vertex numbers for each face`, faces, corners * Math.floor(faces.length / corners));
  for (const [name, list] of Object.entries({ positions, normals, uvs: uvs ?? [] })) {
    const bad = list.findIndex((/** @type {number} */ x) => !Number.isFinite(x));
    if (bad >= 0) throw new RangeError(`${name}[${bad}]: expected a finite number, got ${list[bad]}`);
  }
  const tooLarge = faces.findIndex((vertex) => vertex >= vertices);
  if (tooLarge >= 0)
    throw new RangeError(`indices: expected an index from 0 to ${Math.max(0, vertices - 1)}, got ${faces[tooLarge]}`);
}

/**
 * @param {string} name
 * @param {string} expected
 * @param {ArrayLike<number>} list
 * @param {number} length
 */
function checkCount(name, expected, list, length) {
  if (list.length !== length) throw new RangeError(`${name}: expected ${expected}, got ${list.length}`);
}
