// From the surface and the settings to what is drawn: meshes and straight pieces, made again only when they change.
import { arrowsAt } from "./arrows.js";
import { Memo } from "./memo.js";
import { errorBound } from "./bound.js";
import * as lines from "./lines.js";
import { patchesOf, sweptBy } from "./patches.js";
import { cracksOf, depthOf, piecesMesh } from "./pieces.js";
import { MOST_GPU_DEGREE } from "./shaders.js";

/**
 * @import { Mesh, Surface } from "../../surfaces.js"
 * @import { Settings } from "./settings.js"
 * @import { Frame, Sight } from "./camera.js"
 */

/**
 * What is to be seen.
 *
 * @typedef {{ surface: Surface, settings: Settings, frame: Frame, picked: number | null }} Scene
 */

/** @typedef {{ pieces: number, depth: number, cracks: number, widest: number }} Recursion */

/**
 * What the picture is made of. `error`: the greatest distance of the surface from the mesh is not above it; `ms`: how long
 * the core took for the mesh, null where the graphics card makes it; `recursion`: what the text's recursion has left.
 *
 * @typedef {{ triangles: number, vertices: number, ms: number | null, error: number | null, unit: "" | "px", recursion: Recursion | null }} Facts
 */

/** The layers of curves as bodies. */
export const WIRES = /** @type {const} */ (["tubes", "ribbons"]);
/** In radii of the surface. */
const TUBE_RADIUS = 0.0085;
const TUBE_SIDES = 10;
const RIBBON_WIDTH = 0.03;

export class Geometry {
  #memo = new Memo();
  #ms = 0;
  #wiresMs = { tubes: 0, ribbons: 0 };
  /** What the text's recursion left, where it made the mesh. @type {import("./pieces.js").Piece[]} */
  #pieces = [];
  /** @type {unknown[]} */
  #seen = [];
  /** @type {{ viewProjection: number[], viewport: number[] } | null} */
  #sight = null;
  /** Whether the camera has moved since the view that tolerances in pixels refer to. */
  outdated = false;

  /**
   * Tells how the surface is seen, which counts where the tolerance is in pixels.
   *
   * @param {Sight} sight
   * @param {number} width in CSS pixels
   * @param {number} height
   * @param {boolean} [moving] the camera moves: the mesh of the last view stays until it rests, which keeps frames short
   */
  seen({ viewProjection }, width, height, moving = false) {
    const numbers = [...viewProjection, width, height];
    this.outdated = !numbers.every((x, i) => x === this.#seen[i]);
    if (!this.outdated || (moving && this.#sight)) return;
    this.outdated = false;
    this.#seen = numbers;
    this.#sight = { viewProjection, viewport: [width, height] };
  }

  /**
   * Whether the vertex shader evaluates the patches: it can do grids only, and not of every degree.
   *
   * @param {Scene} scene
   */
  onGpu({ surface, settings: { evaluation, fineness } }) {
    if (evaluation !== "gpu" || !("segments" in fineness)) return false;
    return patchesOf(surface).every(({ degreeU, degreeV }) => Math.max(degreeU, degreeV) <= MOST_GPU_DEGREE);
  }

  /**
   * What is drawn of the surface: all of it, or what the curve of constant u has swept.
   *
   * @param {Scene} scene
   */
  shown({ surface, settings: { swept, u } }) {
    if (!swept || u === 1) return surface;
    return this.#memo.get("swept", [surface, u], () => sweptBy(surface, u));
  }

  /**
   * The mesh of the core.
   *
   * @param {Scene} scene
   * @returns {Mesh}
   */
  mesh(scene) {
    const { fineness, shading, evaluation } = scene.settings;
    const surface = this.shown(scene);
    const own = shading === "patches" || shading === "gaussian" || shading === "mean"; // needs patch numbers and uvs
    const method = evaluation === "forward" ? "forward-difference" : "bernstein";
    const sight = "pixels" in fineness ? this.#sight : null;
    const make = (/** @type {Mesh | undefined} */ into) => {
      const [mesh, ms] = timed(() => this.#make(surface, fineness, own, method, into));
      this.#ms = ms;
      return mesh;
    };
    return this.#memo.get(
      "mesh",
      [surface, ...Object.values(fineness), Object.keys(fineness)[0], own, method, sight],
      make,
    );
  }

  /**
   * @param {Surface} surface
   * @param {Settings["fineness"]} fineness
   * @param {boolean} own
   * @param {"bernstein" | "forward-difference"} method of grids
   * @param {Mesh | undefined} into
   */
  #make(surface, fineness, own, method, into) {
    const weld = own ? "none" : "normal";
    if ("segments" in fineness) return surface.grid({ ...fineness, method, into });
    if ("tolerance" in fineness) return surface.tessellate({ ...fineness, weld, into });
    if ("flatness" in fineness) {
      this.#pieces = surface.subdivide(fineness.flatness);
      return piecesMesh(surface, this.#pieces);
    }
    const { viewProjection = [], viewport = [] } = this.#sight ?? {};
    return surface.tessellate({ ...fineness, viewProjection, viewport, weld, into });
  }

  /**
   * A mesh to take away: as fine as the one that is seen, and closed where the surface is.
   *
   * @param {Scene} scene
   * @returns {Mesh}
   */
  closedMesh({ surface, settings: { fineness } }) {
    return "segments" in fineness
      ? surface.tessellate(fineness)
      : this.#make(surface, fineness, false, "bernstein", undefined);
  }

  /**
   * The number of the mesh: its arrays are reused, so that it is always the same object.
   *
   * @param {boolean} withCurvatures
   */
  version(withCurvatures = false) {
    return this.#memo.version(withCurvatures ? "curvatures" : "mesh");
  }

  /**
   * Gaussian and mean curvature of each vertex, where the shading asks for them.
   *
   * @param {Scene} scene
   */
  curvatures(scene) {
    const { shading } = scene.settings;
    if (shading !== "gaussian" && shading !== "mean") return null;
    const mesh = this.mesh(scene);
    return this.#memo.get("curvatures", [this.version()], () => curvaturesOf(this.shown(scene), mesh));
  }

  /**
   * The sides of its triangles.
   *
   * @param {Scene} scene
   */
  edges(scene) {
    const mesh = this.mesh(scene);
    return this.#memo.get("edges", [this.version()], () => lines.edges(mesh));
  }

  /** @param {Scene} scene */
  isocurves(scene) {
    const [surface, count] = [this.shown(scene), scene.settings.lines];
    return this.#memo.get("isocurves", [surface, count], () => lines.isocurves(surface, count));
  }

  /**
   * The gaps of the recursion's mesh; null for the other meshes, which have none.
   *
   * @param {Scene} scene
   */
  cracks(scene) {
    if (!("flatness" in scene.settings.fineness)) return null;
    this.mesh(scene);
    return this.#memo.get("cracks", [this.version()], () => cracksOf(this.shown(scene), this.#pieces));
  }

  /**
   * The curves as bodies: tubes, or ribbons that lie in the surface.
   *
   * @param {"tubes" | "ribbons"} kind
   * @param {Scene} scene
   * @returns {Mesh}
   */
  wires(kind, scene) {
    const {
      frame,
      settings: { lines: count },
    } = scene;
    const surface = this.shown(scene);
    const size =
      kind === "tubes"
        ? { radius: frame.radius * TUBE_RADIUS, sides: TUBE_SIDES }
        : { width: frame.radius * RIBBON_WIDTH };
    const make = (/** @type {Mesh | undefined} */ into) => {
      const [mesh, ms] = timed(() => surface.wireframe({ lines: count, ...size, into }));
      this.#wiresMs[kind] = ms;
      return mesh;
    };
    return this.#memo.get(kind, [surface, frame, count], make);
  }

  /** @param {"tubes" | "ribbons"} kind */
  wiresVersion(kind) {
    return this.#memo.version(kind);
  }

  /** @param {Scene} scene */
  net({ surface, picked }) {
    return this.#memo.get("net", [surface, picked], () => lines.nets(surface, picked));
  }

  /** @param {Scene} scene */
  outline({ surface, picked }) {
    return this.#memo.get("outline", [surface, picked], () =>
      picked === null ? new Float32Array() : lines.outline(patchesOf(surface)[picked]),
    );
  }

  /** @param {Scene} scene */
  casteljau({ surface, picked, settings: { u, v, step } }) {
    return this.#memo.get("casteljau", [surface, picked, u, v, step], () =>
      lines.casteljau(patchesOf(surface)[picked ?? 0], u, v, step),
    );
  }

  /** The point that the page asks about, the nearest one of the surface, and the way between them. @param {Scene} scene */
  probe({ surface, settings: { probe } }) {
    return this.#memo.get("probe", [surface, probe], () => {
      const found = probe && surface.nearest(probe);
      if (!found) return null;
      const { x, y, z = 0 } = found.point;
      return {
        way: Float32Array.from([...probe, x, y, z]),
        at: Float32Array.from(probe),
        nearest: Float32Array.of(x, y, z),
      };
    });
  }

  /** The curves of constant u and v, and where they meet. @param {Scene} scene */
  place({ surface, picked, settings: { u, v } }) {
    return this.#memo.get("place", [surface, picked, u, v], () => lines.place(patchesOf(surface)[picked ?? 0], u, v));
  }

  /** The derivatives and the normal at (u, v). @param {Scene} scene */
  derivatives({ surface, picked, frame, settings: { u, v } }) {
    return this.#memo.get("derivatives", [surface, picked, u, v], () =>
      arrowsAt(patchesOf(surface)[picked ?? 0], u, v, frame.radius),
    );
  }

  /**
   * What the picture is made of, in numbers.
   *
   * @param {Scene} scene
   * @returns {Facts}
   */
  facts(scene) {
    const { layers } = scene.settings;
    const shown = layers.has("surface") || layers.has("mesh");
    /** @type {Facts} */
    const facts = shown
      ? this.#meshFacts(scene)
      : { triangles: 0, vertices: 0, ms: 0, error: null, unit: "", recursion: null };
    for (const kind of WIRES) {
      if (!layers.has(kind)) continue;
      const { indices, positions } = this.wires(kind, scene);
      facts.triangles += indices.length / 3;
      facts.vertices += positions.length / 3;
      if (facts.ms !== null) facts.ms += this.#wiresMs[kind];
    }
    return facts;
  }

  /**
   * @param {Scene} scene
   * @returns {Facts}
   */
  #meshFacts(scene) {
    const {
      surface,
      settings: { fineness },
    } = scene;
    if (this.onGpu(scene) && "segments" in fineness) {
      const { segments } = fineness;
      const count = surface.patchCount;
      return {
        triangles: 2 * count * segments ** 2,
        vertices: count * (segments + 1) ** 2,
        ms: null,
        ...this.#error(scene),
        recursion: null,
      };
    }
    const mesh = this.mesh(scene);
    const recursion = this.#recursion(scene);
    return {
      triangles: mesh.indices.length / 3,
      vertices: mesh.positions.length / 3,
      ms: this.#ms,
      ...this.#error(scene),
      recursion,
    };
  }

  /**
   * @param {Scene} scene
   * @returns {{ error: number | null, unit: "" | "px" }}
   */
  #error(scene) {
    const { fineness } = scene.settings;
    const surface = this.shown(scene);
    if ("flatness" in fineness) return { error: null, unit: "" }; // it bounds no distance
    if ("tolerance" in fineness) return { error: fineness.tolerance, unit: "" };
    if ("pixels" in fineness) return { error: fineness.pixels, unit: "px" };
    return {
      error: this.#memo.get("error", [surface, fineness.segments], () => errorBound(surface, fineness.segments)),
      unit: "",
    };
  }

  /**
   * @param {Scene} scene
   * @returns {Recursion | null}
   */
  #recursion(scene) {
    const cracks = this.cracks(scene);
    return (
      cracks && {
        pieces: this.#pieces.length,
        depth: depthOf(this.#pieces),
        cracks: cracks.triangles.length / 9,
        widest: cracks.widest,
      }
    );
  }
}

/**
 * What comes out, and how long it took.
 *
 * @template T
 * @param {() => T} make
 * @returns {[T, number]}
 */
function timed(make) {
  const begin = performance.now();
  return [make(), performance.now() - begin];
}

/**
 * Two numbers for each vertex.
 *
 * @param {Surface} surface
 * @param {Mesh} mesh with uvs and patch numbers
 */
function curvaturesOf(surface, { uvs, patchIds }) {
  const patches = patchesOf(surface);
  const numbers = new Float32Array(uvs?.length ?? 0);
  for (let i = 0; uvs && patchIds && i < patchIds.length; i++) {
    const { gaussian, mean } = patches[patchIds[i]].curvature(uvs[2 * i], uvs[2 * i + 1]);
    numbers.set([gaussian, mean], 2 * i);
  }
  return numbers;
}
