// The picture in WebGL2.
import * as twgl from "twgl.js";
import { Batch } from "./buffers.js";
import { PatchTexture, unitEdges, unitGrid } from "./patch-texture.js";
import { patchesOf } from "./patches.js";
import { MODES, MOST_GPU_DEGREE, SOURCES } from "./shaders.js";

/**
 * @import { Sight } from "./camera.js"
 * @import { Geometry, Scene } from "./geometry.js"
 * @import { Theme } from "./theme.js"
 */

/**
 * One picture: what, seen how, in which colours, on how many pixels.
 *
 * @typedef {{ scene: Scene, geometry: Geometry, sight: Sight, theme: Theme, width: number, height: number, ratio: number }} Picture
 */

/** What is hidden behind the surface shows through by so much. */
const HIDDEN_ALPHA = 0.22;
/** Widths in CSS pixels. */
const [THIN, MIDDLE, THICK] = [1, 1.5, 3];
const [SMALL_POINT, LARGE_POINT] = [9, 15];
/** |∂u × ∂v| below this share of |∂u|² + |∂v|² is a normal that rounding has eaten. */
const ZERO_RATIO = 2e-6;

export class GlView {
  #gl;
  /** @type {Map<string, import("twgl.js").ProgramInfo>} */
  #programs = new Map();
  /** @type {Map<string, Batch>} */
  #batches = new Map();
  #texture;
  #attributes = new Numbers();

  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.#gl = gl;
    this.#texture = new PatchTexture(gl);
  }

  /**
   * The view on a canvas; null without WebGL2.
   *
   * @param {HTMLCanvasElement} canvas
   */
  static on(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: true, premultipliedAlpha: true });
    return gl && new GlView(gl);
  }

  /** @param {Picture} picture */
  draw(picture) {
    const gl = this.#gl;
    const { layers, evaluation } = picture.scene.settings;
    gl.viewport(0, 0, picture.width, picture.height);
    gl.clearColor(0, 0, 0, 0);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const onGpu = evaluation === "gpu" && fitsShader(picture.scene);
    if (onGpu) this.#texture.fill(picture.scene.surface);
    if (layers.has("surface")) onGpu ? this.#patches(picture) : this.#mesh(picture);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    this.#lines(picture, onGpu);
  }

  /** @param {Picture} picture */
  #mesh(picture) {
    const { scene, geometry } = picture;
    const mesh = geometry.mesh(scene);
    const program = this.#program("mesh");
    const make = () => ({
      arrays: {
        position: { numComponents: 3, data: mesh.positions },
        normal: { numComponents: 3, data: mesh.normals },
        patchId: { numComponents: 1, data: Float32Array.from(mesh.patchIds ?? []) },
      },
      indices: mesh.indices,
    });
    const batch = this.#batch("mesh");
    batch.fill(geometry.meshVersion, make, program);
    this.#surfaceUniforms(program, picture);
    batch.draw(this.#gl.TRIANGLES);
  }

  /** @param {Picture} picture */
  #patches(picture) {
    const { surface, settings: { segments } } = picture.scene;
    const program = this.#program("patches");
    const make = () => {
      const { uv, indices } = unitGrid(segments);
      return { arrays: { uv: { numComponents: 2, data: uv } }, indices };
    };
    const batch = this.#batch("grid");
    batch.fill(segments, make, program);
    this.#surfaceUniforms(program, picture);
    twgl.setUniforms(program, this.#netUniforms());
    batch.draw(this.#gl.TRIANGLES, surface.patchCount);
  }

  /**
   * @param {import("twgl.js").ProgramInfo} program
   * @param {Picture} picture
   */
  #surfaceUniforms(program, { scene, sight, theme }) {
    const gl = this.#gl;
    gl.useProgram(program.program);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    const { front, back, low, middle, high } = theme;
    const mode = MODES[scene.settings.shading];
    twgl.setUniforms(program, { view: sight.view, projection: sight.projection, radius: scene.frame.radius, mode, front, back, low, middle, high });
  }

  #netUniforms() {
    return { net: this.#texture.texture, stride: this.#texture.stride, zeroRatio: ZERO_RATIO };
  }

  /**
   * @param {Picture} picture
   * @param {boolean} onGpu
   */
  #lines(picture, onGpu) {
    const { scene, geometry, theme } = picture;
    const { layers } = scene.settings;
    if (layers.has("mesh")) {
      if (onGpu) this.#edges(picture);
      else this.#bands(picture, "edges", geometry.edges(scene), theme.line, THIN);
    }
    if (layers.has("isocurves")) this.#bands(picture, "isocurves", geometry.isocurves(scene), theme.ink, MIDDLE);
    if (scene.picked !== null && scene.surface.patchCount > 1) this.#bands(picture, "outline", geometry.outline(scene), theme.ink, MIDDLE, true);
    if (layers.has("net")) this.#bands(picture, "net", geometry.net(scene), theme.handle, MIDDLE, true);
    if (layers.has("casteljau") && scene.surface.patchCount) this.#casteljau(picture);
  }

  /** @param {Picture} picture */
  #casteljau(picture) {
    const { theme } = picture;
    const parts = picture.geometry.casteljau(picture.scene);
    this.#bands(picture, "rowLines", parts.rowLines, theme.level1, MIDDLE, true);
    this.#bands(picture, "rowCurves", parts.rowCurves, theme.level1, THICK, true);
    this.#bands(picture, "columnLines", parts.columnLines, theme.level2, MIDDLE, true);
    this.#bands(picture, "columnCurve", parts.columnCurve, theme.level2, THICK, true);
    this.#points(picture, "rowPoints", parts.rowPoints, theme.level1, SMALL_POINT, false);
    this.#points(picture, "point", parts.point, theme.handle, LARGE_POINT, true);
  }

  /** @param {Picture} picture */
  #edges(picture) {
    const { surface, settings: { segments } } = picture.scene;
    const program = this.#program("edges");
    const make = () => {
      const { ends, indices } = unitEdges(segments);
      return { arrays: { ends: { numComponents: 4, data: ends } }, indices };
    };
    const batch = this.#batch("gridEdges");
    batch.fill(segments, make, program);
    this.#lineUniforms(program, picture, picture.theme.line, THIN);
    twgl.setUniforms(program, this.#netUniforms());
    batch.draw(this.#gl.TRIANGLES, surface.patchCount);
  }

  /**
   * Straight pieces; where they are hidden, faint or not at all.
   *
   * @param {Picture} picture
   * @param {string} name
   * @param {Float32Array} pieces
   * @param {number[]} colour
   * @param {number} width
   * @param {boolean} [through]
   */
  #bands(picture, name, pieces, colour, width, through = false) {
    const gl = this.#gl;
    const program = this.#program("lines");
    const halves = () => ({ arrays: splitEnds(pieces) });
    const batch = this.#batch(name);
    batch.fill(this.#attributes.of(pieces), halves, program);
    this.#lineUniforms(program, picture, colour, width);
    batch.drawBands();
    if (!through) return;
    gl.depthFunc(gl.GREATER);
    twgl.setUniforms(program, { ink: [...colour, HIDDEN_ALPHA] });
    batch.drawBands();
    gl.depthFunc(gl.LESS);
  }

  /**
   * @param {import("twgl.js").ProgramInfo} program
   * @param {Picture} picture
   * @param {number[]} colour
   * @param {number} width
   */
  #lineUniforms(program, { sight, width: w, height, ratio }, colour, width) {
    this.#gl.useProgram(program.program);
    const viewport = [w / 2, height / 2];
    twgl.setUniforms(program, { view: sight.view, projection: sight.projection, viewport, width: (width * ratio) / 2, ink: [...colour, 1] });
  }

  /**
   * @param {Picture} picture
   * @param {string} name
   * @param {Float32Array} points
   * @param {number[]} colour
   * @param {number} size
   * @param {boolean} diamond
   */
  #points({ sight, ratio, theme }, name, points, colour, size, diamond) {
    const gl = this.#gl;
    const program = this.#program("points");
    const batch = this.#batch(name);
    batch.fill(this.#attributes.of(points), () => ({ arrays: { position: { numComponents: 3, data: points } } }), program);
    gl.useProgram(program.program);
    gl.disable(gl.DEPTH_TEST);
    twgl.setUniforms(program, { view: sight.view, projection: sight.projection, width: size * ratio, ink: [...colour, 1], paper: theme.paper, diamond });
    batch.draw(gl.POINTS);
    gl.enable(gl.DEPTH_TEST);
  }

  /**
   * Compiled at its first use.
   *
   * @param {keyof typeof SOURCES} name
   */
  #program(name) {
    const known = this.#programs.get(name) ?? twgl.createProgramInfo(this.#gl, SOURCES[name]);
    this.#programs.set(name, known);
    return known;
  }

  /** @param {string} name */
  #batch(name) {
    const known = this.#batches.get(name) ?? new Batch(this.#gl);
    this.#batches.set(name, known);
    return known;
  }

  /** Gives everything back to the graphics card. */
  drop() {
    for (const batch of this.#batches.values()) batch.drop();
    for (const { program } of this.#programs.values()) this.#gl.deleteProgram(program);
    this.#texture.drop();
    this.#batches.clear();
    this.#programs.clear();
  }
}

/** @param {Scene} scene */
function fitsShader({ surface }) {
  return patchesOf(surface).every(({ degreeU, degreeV }) => Math.max(degreeU, degreeV) <= MOST_GPU_DEGREE);
}

/**
 * @param {Float32Array} pieces
 */
function splitEnds(pieces) {
  const [from, to] = [new Float32Array(pieces.length / 2), new Float32Array(pieces.length / 2)];
  for (let i = 0; i < from.length; i += 3) {
    from.set(pieces.subarray(2 * i, 2 * i + 3), i);
    to.set(pieces.subarray(2 * i + 3, 2 * i + 6), i);
  }
  return { from: { numComponents: 3, data: from, divisor: 1 }, to: { numComponents: 3, data: to, divisor: 1 } };
}

/** A number for each array, the same one for the same array. */
class Numbers {
  /** @type {WeakMap<object, number>} */
  #known = new WeakMap();
  #count = 0;

  /** @param {object} array */
  of(array) {
    const known = this.#known.get(array) ?? ++this.#count;
    this.#known.set(array, known);
    return known;
  }
}
