// From the surface and the settings to what is drawn: meshes and straight pieces, made again only when they change.
import { Memo } from "./memo.js";
import { errorBound } from "./bound.js";
import { patchesOf } from "./patches.js";
import * as lines from "./lines.js";

/**
 * @import { Mesh, Surface } from "../../index.js"
 * @import { Settings } from "./settings.js"
 * @import { Frame } from "./camera.js"
 */

/**
 * What is to be seen.
 *
 * @typedef {{ surface: Surface, settings: Settings, frame: Frame, picked: number | null }} Scene
 */

/** @typedef {{ triangles: number, vertices: number, ms: number, error: number | null }} Facts */

export class Geometry {
  #memo = new Memo();
  #ms = 0;

  /**
   * The mesh of the core.
   *
   * @param {Scene} scene
   * @returns {Mesh}
   */
  mesh({ surface, settings }) {
    const make = (/** @type {Mesh | undefined} */ into) => {
      const begin = performance.now();
      const mesh = surface.grid({ segments: settings.segments, into });
      this.#ms = performance.now() - begin;
      return mesh;
    };
    return this.#memo.get("mesh", [surface, settings.segments], make);
  }

  /** The number of the mesh: its arrays are reused, so that it is always the same object. */
  get meshVersion() {
    return this.#memo.version("mesh");
  }

  /**
   * The sides of its triangles.
   *
   * @param {Scene} scene
   */
  edges(scene) {
    const mesh = this.mesh(scene);
    return this.#memo.get("edges", [this.meshVersion], () => lines.edges(mesh));
  }

  /** @param {Scene} scene */
  isocurves({ surface }) {
    return this.#memo.get("isocurves", [surface], () => lines.isocurves(surface));
  }

  /** @param {Scene} scene */
  net({ surface, picked }) {
    return this.#memo.get("net", [surface, picked], () => lines.nets(surface, picked));
  }

  /** @param {Scene} scene */
  outline({ surface, picked }) {
    return this.#memo.get("outline", [surface, picked], () => (picked === null ? new Float32Array() : lines.outline(patchesOf(surface)[picked])));
  }

  /** @param {Scene} scene */
  casteljau({ surface, picked, settings: { u, v, step } }) {
    return this.#memo.get("casteljau", [surface, picked, u, v, step], () => lines.casteljau(patchesOf(surface)[picked ?? 0], u, v, step));
  }

  /**
   * What the picture is made of, in numbers.
   *
   * @param {Scene} scene
   * @returns {Facts}
   */
  facts(scene) {
    const { surface, settings: { segments, evaluation } } = scene;
    const error = this.#memo.get("error", [surface, segments], () => errorBound(surface, segments));
    if (evaluation === "gpu") {
      const count = surface.patchCount;
      return { triangles: 2 * count * segments ** 2, vertices: count * (segments + 1) ** 2, ms: 0, error };
    }
    const mesh = this.mesh(scene);
    return { triangles: mesh.indices.length / 3, vertices: mesh.positions.length / 3, ms: this.#ms, error };
  }
}
