// Numbers on the graphics card: vertex arrays whose buffers are filled again when the numbers change.
import * as twgl from "twgl.js";
import type { ProgramInfo, BufferInfo } from "twgl.js";

export type Arrays = Record<string, { numComponents: number; data: Float32Array; divisor?: number }>;

/** One thing to draw: a vertex array and how many vertices or indices it has. */
export class Batch {
  #gl;
  #info: BufferInfo | undefined;
  #array: WebGLVertexArrayObject | null = null;
  /** What the buffers hold; null: nothing. */
  #version: unknown = null;
  #length: number = 0;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
  }

  /**
   * Fills the buffers, unless they hold this version.
   *
   * @param version a number or an array that is another one for other contents
   * @param program whose attributes have fixed places, so that any program can draw it
   */
  fill(version: unknown, make: () => { arrays: Arrays; indices?: Uint16Array | Uint32Array }, program: ProgramInfo) {
    if (version === this.#version) return;
    const { arrays, indices } = make();
    this.#version = version;
    const first = Object.values(arrays)[0];
    this.#length = indices?.length ?? first.data.length / first.numComponents;
    if (this.#refill(arrays, indices)) return;
    this.drop();
    this.#version = version;
    const specified = {
      ...arrays,
      ...(indices && { indices: { numComponents: 3, data: indices } }),
    } as any;
    this.#info = twgl.createBufferInfoFromArrays(this.#gl, specified);
    this.#array = twgl.createVAOFromBufferInfo(this.#gl, program, this.#info);
  }

  /** New numbers into the buffers that are there. */
  #refill(arrays: Arrays, indices: Uint16Array | Uint32Array | undefined) {
    const [gl, info] = [this.#gl, this.#info];
    if (!info || Object.keys(arrays).some((name) => !info.attribs?.[name])) return false;
    gl.bindVertexArray(null);
    for (const [name, { data }] of Object.entries(arrays)) {
      gl.bindBuffer(gl.ARRAY_BUFFER, info.attribs?.[name].buffer ?? null);
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    }
    if (indices && info.indices) {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, info.indices);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.DYNAMIC_DRAW);
      info.elementType = indices instanceof Uint16Array ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT;
    }
    return true;
  }

  draw(primitive: number, instances?: number) {
    const [gl, info] = [this.#gl, this.#info];
    if (!info || this.#length === 0) return;
    gl.bindVertexArray(this.#array);
    if (info.indices)
      gl.drawElementsInstanced(primitive, this.#length, info.elementType ?? gl.UNSIGNED_SHORT, 0, instances ?? 1);
    else gl.drawArraysInstanced(primitive, 0, this.#length, instances ?? 1);
    gl.bindVertexArray(null);
  }

  /** Draws four vertices for each entry. */
  drawBands() {
    const gl = this.#gl;
    if (!this.#info || this.#length === 0) return;
    gl.bindVertexArray(this.#array);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.#length);
    gl.bindVertexArray(null);
  }

  drop() {
    const gl = this.#gl;
    for (const attrib of Object.values(this.#info?.attribs ?? {})) gl.deleteBuffer(attrib.buffer);
    if (this.#info?.indices) gl.deleteBuffer(this.#info.indices);
    gl.deleteVertexArray(this.#array);
    this.#info = undefined;
    this.#array = null;
    this.#version = null;
  }
}
