// <byte-count>: what the teapot takes as control points, and what as a mesh.
import { Surface } from "casteljau";
import { element } from "../../parts/dom.js";
import { slider } from "./svg.js";

const NUMBER = 4;
const SHORT = 2;

/** A thin space between thousands. @param {number} count */
const many = (count) => count.toLocaleString("en").replaceAll(",", "\u2009");

/** @param {Surface} surface @param {number} segments */
export function bytesOf(surface, segments) {
  const { positions, normals, indices } = surface.grid({ segments });
  const patches = surface.vertices.length * NUMBER + surface.patchCount * 16 * SHORT;
  const mesh = positions.byteLength + normals.byteLength + indices.byteLength;
  return { patches, mesh, ratio: mesh / patches };
}

class ByteCount extends (globalThis.HTMLElement ?? Object) {
  #teapot = Surface.teapot();
  #segments = 8;
  #bars = { patches: element("span", { className: "bar" }), mesh: element("span", { className: "bar" }) };
  #texts = { patches: element("span", {}), mesh: element("span", {}) };
  #words = element("p", { className: "note" });
  /** @type {ReturnType<typeof slider> | null} */ #knob = null;

  connectedCallback() {
    if (this.childNodes.length > 0) return;
    this.#knob = slider("Segments", { min: 1, max: 64, step: 1, value: this.#segments, name: "segments" }, (n, type) => {
      this.segments = n;
      this.dispatchEvent(new Event(type, { bubbles: true }));
    });
    const row = (/** @type {"patches" | "mesh"} */ name, /** @type {string} */ title) => element("div", { className: "row" }, element("b", {}, title), this.#bars[name], this.#texts[name]);
    this.#words.setAttribute("role", "status");
    this.append(this.#knob.line, row("patches", "32 patches"), row("mesh", "mesh"), this.#words);
    this.#draw();
  }

  get segments() {
    return this.#segments;
  }

  set segments(count) {
    this.#segments = count;
    this.#draw();
  }

  get figure() {
    return { segments: this.#segments, ...bytesOf(this.#teapot, this.#segments) };
  }

  /** How much more the mesh takes. @param {number} segments */
  ratioAt(segments) {
    return bytesOf(this.#teapot, segments).ratio;
  }

  #draw() {
    const { segments, patches, mesh, ratio } = this.figure;
    if (!this.#knob) return;
    this.#knob.input.value = this.#knob.output.textContent = String(segments);
    for (const [name, bytes] of /** @type {["patches" | "mesh", number][]} */ ([["patches", patches], ["mesh", mesh]])) {
      this.#bars[name].style.setProperty("--share", `${Math.max((100 * bytes) / Math.max(patches, mesh), 0.4)}%`);
      this.#texts[name].textContent = `${many(bytes)} bytes`;
    }
    this.#words.textContent = `The mesh takes ${ratio < 10 ? ratio.toFixed(1) : Math.round(ratio)} times as much.`;
  }
}

globalThis.customElements?.define("byte-count", ByteCount);
