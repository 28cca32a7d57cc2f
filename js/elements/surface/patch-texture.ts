// The control points of all patches as a texture, for the vertex shader that evaluates them.
import { patchesOf } from "./patches.js";
import type { Surface } from "../../surfaces.js";

/** Entries of four numbers in a row of the texture: less than any WebGL2 allows. */
const WIDTH = 1024;

export class PatchTexture {
  #gl;
  #texture: WebGLTexture | null = null;
  #surface: Surface | null = null;
  /** Entries of one patch: its degrees and as many points as the largest net has. */
  stride = 1;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
  }

  get texture() {
    return this.#texture;
  }

  /** Uploads the control points, unless they are there. */
  fill(surface: Surface) {
    if (surface === this.#surface) return;
    const gl = this.#gl;
    const patches = patchesOf(surface);
    this.stride = 1 + Math.max(1, ...patches.map(({ degreeU, degreeV }) => (degreeU + 1) * (degreeV + 1)));
    const height = Math.max(1, Math.ceil((this.stride * patches.length) / WIDTH));
    const entries = new Float32Array(4 * WIDTH * height);
    patches.forEach((patch, k) => write(entries, 4 * k * this.stride, patch));
    this.#texture ??= gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.#texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, WIDTH, height, 0, gl.RGBA, gl.FLOAT, entries);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    this.#surface = surface;
  }

  drop() {
    this.#gl.deleteTexture(this.#texture);
    this.#texture = null;
    this.#surface = null;
  }
}

function write(
  entries: Float32Array,
  at: number,
  patch: { degreeU: number; degreeV: number; controlPoints(): Float64Array },
) {
  entries.set([patch.degreeU, patch.degreeV], at);
  const points = patch.controlPoints();
  for (let i = 0; i < points.length; i += 3) entries.set(points.subarray(i, i + 3), at + 4 + (4 * i) / 3);
}

/** A grid of n × n cells over the unit square, with counter-clockwise triangles. */
export function unitGrid(n: number): { uv: Float32Array; indices: Uint16Array } {
  const uv = new Float32Array(2 * (n + 1) ** 2);
  const indices = new Uint16Array(6 * n * n);
  for (let j = 0; j <= n; j++) for (let i = 0; i <= n; i++) uv.set([i / n, j / n], 2 * (j * (n + 1) + i));
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const a = j * (n + 1) + i;
      const [b, c, d] = [a + 1, a + n + 2, a + n + 1];
      indices.set([a, b, c, a, c, d], 6 * (j * n + i));
    }
  }
  return { uv, indices };
}

/** The sides of that grid's triangles as bands of four vertices each. */
export function unitEdges(n: number): { ends: Float32Array; indices: Uint32Array } {
  const pieces: number[] = [];
  for (let j = 0; j <= n; j++) {
    for (let i = 0; i <= n; i++) {
      const [u, v, right, up] = [i / n, j / n, (i + 1) / n, (j + 1) / n];
      if (i < n) pieces.push(u, v, right, v);
      if (j < n) pieces.push(u, v, u, up);
      if (i < n && j < n) pieces.push(u, v, right, up);
    }
  }
  const count = pieces.length / 4;
  const ends = new Float32Array(16 * count);
  const indices = new Uint32Array(6 * count);
  for (let k = 0; k < count; k++) {
    for (let corner = 0; corner < 4; corner++) ends.set(pieces.slice(4 * k, 4 * k + 4), 16 * k + 4 * corner);
    indices.set(
      [0, 1, 2, 2, 1, 3].map((corner) => 4 * k + corner),
      6 * k,
    );
  }
  return { ends, indices };
}
