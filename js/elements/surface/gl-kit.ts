// What all drawing in WebGL2 shares: programs, vertex arrays and the texture of control points, made when first needed.
import * as twgl from "twgl.js";
import { Batch } from "./buffers.js";
import { PatchTexture } from "./patch-texture.js";
import { SOURCES } from "./shaders.js";
import type { ProgramInfo } from "twgl.js";
import type { CameraMatrices } from "./camera.js";
import type { Geometry, Scene } from "./geometry.js";
import type { Theme } from "./theme.js";

/** |∂u × ∂v| below this share of |∂u|² + |∂v|² is a normal that rounding has eaten. */
const ZERO_RATIO = 2e-6;

/** One picture: what, seen how, in which colours, on how many pixels, and how many of them make a CSS pixel. */
export type Picture = {
  scene: Scene;
  geometry: Geometry;
  matrices: CameraMatrices;
  theme: Theme;
  width: number;
  height: number;
  ratio: number;
};

export class GlKit {
  gl: WebGL2RenderingContext;
  texture: PatchTexture;

  #programs: Map<string, ProgramInfo> = new Map();
  #batches: Map<string, Batch> = new Map();

  constructor(gl: WebGL2RenderingContext) {
    this.gl = gl;
    this.texture = new PatchTexture(gl);
  }

  program(name: keyof typeof SOURCES) {
    const known = this.#programs.get(name) ?? twgl.createProgramInfo(this.gl, SOURCES[name]);
    this.#programs.set(name, known);
    return known;
  }

  batch(name: string) {
    const known = this.#batches.get(name) ?? new Batch(this.gl);
    this.#batches.set(name, known);
    return known;
  }

  /** Where the evaluating shaders find the control points. */
  netUniforms() {
    return { net: this.texture.texture, stride: this.texture.stride, zeroRatio: ZERO_RATIO };
  }

  /** Gives everything back to the graphics card. */
  drop() {
    for (const batch of this.#batches.values()) batch.drop();
    for (const { program } of this.#programs.values()) this.gl.deleteProgram(program);
    this.texture.drop();
    this.#batches.clear();
    this.#programs.clear();
  }
}
