// Lines and points over the surface.
import * as twgl from "twgl.js";
import { unitEdges } from "./patch-texture.js";
import type { GlKit } from "./gl-kit.js";
import type { Picture } from "./gl-kit.js";
import type { ProgramInfo } from "twgl.js";

/** What is hidden behind the surface shows through by so much. */
const HIDDEN_ALPHA = 0.22;
/** The mesh lets the shading through. */
const MESH_ALPHA = 0.55;
/** Widths in CSS pixels. */
const [THIN, MIDDLE, THICK] = [1, 1.5, 3];
const [SMALL_POINT, LARGE_POINT] = [9, 15];

/** Bands reach beyond their ends by so much of their width, and close the chain. */
const ROUND = 0.5;

/** How lines look; `hidden`: whether they show faintly where something is in front of them. */
export type Pen = { colour: number[]; width: number; alpha?: number; hidden?: boolean };

export class GlLines {
  #kit;

  constructor(kit: GlKit) {
    this.#kit = kit;
  }

  draw(picture: Picture, onGpu: boolean) {
    const gl = this.#kit.gl;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    const { scene, geometry, theme } = picture;
    const { layers } = scene.settings;
    if (layers.has("mesh") && onGpu) this.#gridEdges(picture);
    else if (layers.has("mesh"))
      this.#bands(picture, "edges", geometry.edges(scene), { colour: theme.line, width: THIN, alpha: MESH_ALPHA });
    if (layers.has("isocurves"))
      this.#bands(picture, "isocurves", geometry.isocurves(scene), { colour: theme.ink, width: MIDDLE });
    this.#cracks(picture);
    if (scene.picked !== null && scene.surface.patchCount > 1)
      this.#bands(picture, "outline", geometry.outline(scene), { colour: theme.ink, width: MIDDLE, hidden: true });
    if (layers.has("net"))
      this.#bands(picture, "net", geometry.net(scene), { colour: theme.handle, width: MIDDLE, hidden: true });
    if (layers.has("casteljau") && scene.surface.patchCount) this.#casteljau(picture);
    this.#probe(picture);
    if (layers.has("place") && scene.surface.patchCount) this.#place(picture);
    if (layers.has("derivatives") && scene.surface.patchCount) this.#derivatives(picture);
  }

  /** The gaps are filled, and since most are thinner than a pixel, drawn as lines, too. */
  #cracks(picture: Picture) {
    const { scene, geometry, matrices, theme } = picture;
    const cracks = geometry.cracks(scene);
    if (!cracks || !scene.settings.layers.has("surface")) return;
    const program = this.#kit.program("plain");
    const batch = this.#kit.batch("gaps");
    batch.fill(
      cracks.triangles,
      () => ({ arrays: { position: { numComponents: 3, data: cracks.triangles } } }),
      program,
    );
    this.#kit.gl.useProgram(program.program);
    twgl.setUniforms(program, { view: matrices.view, projection: matrices.projection, ink: [...theme.gap, 1] });
    batch.draw(this.#kit.gl.TRIANGLES);
    this.#bands(picture, "cracks", cracks.lines, { colour: theme.gap, width: MIDDLE });
  }

  #probe(picture: Picture) {
    const probe = picture.geometry.probe(picture.scene);
    if (!probe) return;
    const { ink, handle, level1 } = picture.theme;
    this.#bands(picture, "probeWay", probe.way, { colour: ink, width: MIDDLE, hidden: true });
    this.#points(picture, "probe", probe.at, level1, LARGE_POINT, false);
    this.#points(picture, "nearest", probe.nearest, handle, LARGE_POINT, true);
  }

  #place(picture: Picture) {
    const { level1, level2, handle } = picture.theme;
    const { ofU, ofV, at } = picture.geometry.place(picture.scene);
    this.#bands(picture, "ofU", ofU, { colour: level2, width: THICK, hidden: true });
    this.#bands(picture, "ofV", ofV, { colour: level1, width: THICK, hidden: true });
    this.#points(picture, "at", at, handle, LARGE_POINT, true);
  }

  #derivatives(picture: Picture) {
    const { level1, level2, handle } = picture.theme;
    const { u, v, normal, at } = picture.geometry.derivatives(picture.scene);
    this.#bands(picture, "alongU", u, { colour: level1, width: THICK, hidden: true });
    this.#bands(picture, "alongV", v, { colour: level2, width: THICK, hidden: true });
    this.#bands(picture, "normal", normal, { colour: handle, width: THICK, hidden: true });
    this.#points(picture, "place", at, handle, LARGE_POINT, true);
  }

  #casteljau(picture: Picture) {
    const { level1, level2, handle } = picture.theme;
    const parts = picture.geometry.casteljau(picture.scene);
    this.#bands(picture, "rowLines", parts.rowLines, { colour: level1, width: MIDDLE, hidden: true });
    this.#bands(picture, "rowCurves", parts.rowCurves, { colour: level1, width: THICK, hidden: true });
    this.#bands(picture, "columnLines", parts.columnLines, { colour: level2, width: MIDDLE, hidden: true });
    this.#bands(picture, "columnCurve", parts.columnCurve, { colour: level2, width: THICK, hidden: true });
    this.#points(picture, "rowPoints", parts.rowPoints, level1, SMALL_POINT, false);
    this.#points(picture, "point", parts.point, handle, LARGE_POINT, true);
  }

  /** The mesh where the vertex shader evaluates the patches: its edges, too. */
  #gridEdges(picture: Picture) {
    const {
      surface,
      settings: { segments },
    } = picture.scene;
    const program = this.#kit.program("edges");
    const make = () => {
      const { ends, indices } = unitEdges(segments);
      return { arrays: { ends: { numComponents: 4, data: ends } }, indices };
    };
    const batch = this.#kit.batch("gridEdges");
    batch.fill(segments, make, program);
    this.#uniforms(program, picture, { colour: picture.theme.line, width: THIN, alpha: MESH_ALPHA });
    twgl.setUniforms(program, this.#kit.netUniforms());
    batch.draw(this.#kit.gl.TRIANGLES, surface.patchCount);
  }

  /** Straight pieces. */
  #bands(picture: Picture, name: string, pieces: Float32Array, pen: Pen) {
    const gl = this.#kit.gl;
    const program = this.#kit.program("lines");
    const batch = this.#kit.batch(name);
    batch.fill(pieces, () => ({ arrays: splitEnds(pieces) }), program);
    this.#uniforms(program, picture, pen);
    batch.drawBands();
    if (!pen.hidden) return;
    gl.depthFunc(gl.GREATER);
    twgl.setUniforms(program, { ink: [...pen.colour, HIDDEN_ALPHA], cap: 0 });
    batch.drawBands();
    gl.depthFunc(gl.LESS);
  }

  #uniforms(program: ProgramInfo, { matrices, width, height, ratio }: Picture, pen: Pen) {
    this.#kit.gl.useProgram(program.program);
    const halfWidth = (pen.width * ratio) / 2;
    const ink = [...pen.colour, pen.alpha ?? 1];
    const cap = pen.alpha === undefined ? ROUND : 0; // pieces that let something through must not overlap
    twgl.setUniforms(program, {
      view: matrices.view,
      projection: matrices.projection,
      viewport: [width / 2, height / 2],
      width: halfWidth,
      ink,
      cap,
    });
  }

  #points(
    { matrices, ratio, theme }: Picture,
    name: string,
    points: Float32Array,
    colour: number[],
    size: number,
    diamond: boolean,
  ) {
    const gl = this.#kit.gl;
    const program = this.#kit.program("points");
    const batch = this.#kit.batch(name);
    batch.fill(points, () => ({ arrays: { position: { numComponents: 3, data: points } } }), program);
    gl.useProgram(program.program);
    gl.disable(gl.DEPTH_TEST);
    twgl.setUniforms(program, {
      view: matrices.view,
      projection: matrices.projection,
      width: size * ratio,
      ink: [...colour, 1],
      paper: theme.paper,
      diamond,
    });
    batch.draw(gl.POINTS);
    gl.enable(gl.DEPTH_TEST);
  }
}

/** Both ends of each piece, as the shader takes them: one of each for every piece. */
function splitEnds(pieces: Float32Array) {
  const [from, to] = [new Float32Array(pieces.length / 2), new Float32Array(pieces.length / 2)];
  for (let i = 0; i < from.length; i += 3) {
    from.set(pieces.subarray(2 * i, 2 * i + 3), i);
    to.set(pieces.subarray(2 * i + 3, 2 * i + 6), i);
  }
  return { from: { numComponents: 3, data: from, divisor: 1 }, to: { numComponents: 3, data: to, divisor: 1 } };
}
