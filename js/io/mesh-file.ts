// Functions that the writers of mesh files share: checks of the arrays, conversion to f32, the size limit.

/** The arrays of a `Mesh` that files contain. */
export type MeshArrays = {
  positions: Float32Array | Float64Array;
  normals: Float32Array | Float64Array;
  uvs: Float32Array | null;
  indices: Uint16Array | Uint32Array;
  quads?: Uint16Array | Uint32Array;
};

/** The largest file: 1 GiB. */
const MAX_BYTES = 2 ** 30;

/**
 * The bytes of a file, filled with zeros. Throws a RangeError if it is too long.
 *
 * @internal
 */
export function newFile(length: number): Uint8Array<ArrayBuffer> {
  if (length > MAX_BYTES) throw new RangeError(`bytes: expected at most ${MAX_BYTES}, this needs ${length}`);
  return new Uint8Array(length);
}

/**
 * Converts numbers to f32; a Float32Array is returned unchanged.
 *
 * @internal
 */
export function toFloat32Array(numbers: Float32Array | Float64Array, name: string): Float32Array {
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
 * @param corners the number of corners of a face
 */
export function checkMesh({ positions, normals, uvs }: MeshArrays, faces: Uint16Array | Uint32Array, corners: number) {
  const vertices = positions.length / 3;
  checkCount("positions", "3 numbers for each vertex", positions, 3 * Math.floor(vertices));
  checkCount("normals", "3 numbers for each vertex", normals, positions.length);
  if (uvs) checkCount("uvs", "2 numbers for each vertex", uvs, 2 * vertices);
  checkCount("indices", `${corners} vertex numbers for each face`, faces, corners * Math.floor(faces.length / corners));
  for (const [name, list] of Object.entries({ positions, normals, uvs: uvs ?? [] })) {
    const bad = list.findIndex((x: number) => !Number.isFinite(x));
    if (bad >= 0) throw new RangeError(`${name}[${bad}]: expected a finite number, got ${list[bad]}`);
  }
  const tooLarge = faces.findIndex((vertex) => vertex >= vertices);
  if (tooLarge >= 0)
    throw new RangeError(`indices: expected an index from 0 to ${Math.max(0, vertices - 1)}, got ${faces[tooLarge]}`);
}

function checkCount(name: string, expected: string, list: ArrayLike<number>, length: number) {
  if (list.length !== length) throw new RangeError(`${name}: expected ${expected}, got ${list.length}`);
}
