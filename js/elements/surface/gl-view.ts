// The picture in WebGL2.
import * as twgl from "twgl.js";
import { WIRES } from "./geometry.js";
import { GlKit } from "./gl-kit.js";
import { GlLines } from "./gl-lines.js";
import { unitGrid } from "./patch-texture.js";
import { SHADING_CODES } from "./shaders.js";
import type { Picture } from "./gl-kit.js";
import type { ProgramInfo } from "twgl.js";

export class GlView {
  #kit;
  #lines;

  constructor(gl: WebGL2RenderingContext) {
    this.#kit = new GlKit(gl);
    this.#lines = new GlLines(this.#kit);
  }

  /** The view on a canvas; null without WebGL2. */
  static on(canvas: HTMLCanvasElement) {
    const gl = canvas.getContext("webgl2", { antialias: true, premultipliedAlpha: true });
    return gl && new GlView(gl);
  }

  get lost() {
    return this.#kit.gl.isContextLost();
  }

  draw(picture: Picture) {
    const gl = this.#kit.gl;
    const { scene, geometry } = picture;
    gl.viewport(0, 0, picture.width, picture.height);
    gl.clearColor(0, 0, 0, 0);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const onGpu = geometry.onGpu(scene);
    if (onGpu) this.#kit.texture.fill(geometry.shown(scene));
    if (scene.settings.layers.has("surface")) onGpu ? this.#patches(picture) : this.#mesh(picture);
    for (const kind of WIRES) if (scene.settings.layers.has(kind)) this.#wires(kind, picture);
    this.#lines.draw(picture, onGpu);
  }

  /** The core's mesh. */
  #mesh(picture: Picture) {
    const { scene, geometry } = picture;
    const mesh = geometry.mesh(scene);
    const program = this.#kit.program("mesh");
    const curvatures = geometry.curvatures(scene);
    const make = () => ({
      arrays: {
        position: { numComponents: 3, data: mesh.positions as Float32Array },
        normal: { numComponents: 3, data: mesh.normals as Float32Array },
        patchId: {
          numComponents: 1,
          data: Float32Array.from(mesh.patchIds ?? { length: mesh.positions.length / 3 }, (id) => id ?? 0),
        },
        curvature: { numComponents: 2, data: curvatures ?? new Float32Array((2 * mesh.positions.length) / 3) },
      },
      indices: mesh.indices,
    });
    const batch = this.#kit.batch("mesh");
    batch.fill(geometry.version(curvatures !== null), make, program);
    this.#uniforms(program, picture);
    batch.draw(this.#kit.gl.TRIANGLES);
  }

  #wires(kind: "tubes" | "ribbons", picture: Picture) {
    const { scene, geometry, theme } = picture;
    const mesh = geometry.wires(kind, scene);
    const program = this.#kit.program("mesh");
    const make = () => ({
      arrays: {
        position: { numComponents: 3, data: mesh.positions as Float32Array },
        normal: { numComponents: 3, data: mesh.normals as Float32Array },
      },
      indices: mesh.indices,
    });
    const batch = this.#kit.batch(kind);
    batch.fill(geometry.wiresVersion(kind), make, program);
    this.#uniforms(program, picture);
    twgl.setUniforms(program, { shading: SHADING_CODES.smooth, front: theme.wire, back: theme.wire });
    batch.draw(this.#kit.gl.TRIANGLES);
  }

  /** The same by the vertex shader: one grid, once for each patch. */
  #patches(picture: Picture) {
    const {
      surface,
      settings: { segments },
    } = picture.scene;
    const program = this.#kit.program("patches");
    const make = () => {
      const { uv, indices } = unitGrid(segments);
      return { arrays: { uv: { numComponents: 2, data: uv } }, indices };
    };
    const batch = this.#kit.batch("grid");
    batch.fill(segments, make, program);
    this.#uniforms(program, picture);
    twgl.setUniforms(program, this.#kit.netUniforms());
    batch.draw(this.#kit.gl.TRIANGLES, surface.patchCount);
  }

  #uniforms(program: ProgramInfo, { scene, matrices, theme }: Picture) {
    const gl = this.#kit.gl;
    gl.useProgram(program.program);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    const { front, back, low, middle, high } = theme;
    const shading = SHADING_CODES[scene.settings.shading];
    const { view, projection } = matrices;
    twgl.setUniforms(program, {
      view,
      projection,
      radius: scene.sphere.radius,
      shading,
      front,
      back,
      low,
      middle,
      high,
    });
  }

  /** Gives everything back to the graphics card. */
  drop() {
    this.#kit.drop();
  }
}
