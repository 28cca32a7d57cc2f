// From the surface and the settings to what is drawn: meshes and straight pieces, made again only when they change.
import { arrowsAt } from "./arrows.js";
import { Memo } from "../../editor/memo.js";
import { errorBound } from "./bound.js";
import * as lines from "./lines.js";
import { hasWeights, nearestTo, patchesOf, sweptBy } from "./patches.js";
import { cracksOf, depthOf, piecesMesh } from "./pieces.js";
import { MAX_GPU_DEGREE } from "./shaders.js";
import { Mesh } from "../../surfaces.js";
import type { Surface } from "../../surfaces.js";
import type { Settings } from "./settings.js";
import type { BoundingSphere, CameraMatrices } from "./camera.js";
import type { Piece } from "./pieces.js";

/** What is to be seen. */
export type Scene = { surface: Surface; settings: Settings; sphere: BoundingSphere; picked: number | null };

export type Recursion = { pieces: number; depth: number; cracks: number; widest: number };

/**
 * What the picture is made of. `error`: the greatest distance of the surface from the mesh is not above it; `ms`: how long
 * the core took for the mesh, null where the graphics card makes it; `recursion`: what the text's recursion has left.
 */
export type Facts = {
  triangles: number;
  vertices: number;
  ms: number | null;
  error: number | null;
  unit: "" | "px";
  recursion: Recursion | null;
};

/** The layers of curves as bodies. */
export const WIRES = ["tubes", "ribbons"] as const;
/** In radii of the surface. */
const TUBE_RADIUS = 0.0085;
const TUBE_SIDES = 10;
const RIBBON_WIDTH = 0.03;

export class Geometry {
  #memo = new Memo();
  #ms = 0;
  #wiresMs = { tubes: 0, ribbons: 0 };
  /** What the text's recursion left, where it made the mesh. */
  #pieces: Piece[] = [];
  #seen: unknown[] = [];
  #projection: { viewProjection: number[]; viewport: number[] } | null = null;
  /** Whether the camera has moved since the view that tolerances in pixels refer to. */
  outdated = false;

  /**
   * Sets how the surface is seen, which counts where the tolerance is in pixels.
   *
   * @param moving the camera moves: the mesh of the last view stays until it rests, which keeps frames short
   */
  seen({ viewProjection, width, height }: CameraMatrices, moving = false) {
    const numbers = [...viewProjection, width, height];
    this.outdated = !numbers.every((x, i) => x === this.#seen[i]);
    if (!this.outdated || (moving && this.#projection)) return;
    this.outdated = false;
    this.#seen = numbers;
    this.#projection = { viewProjection, viewport: [width, height] };
  }

  /** Whether the vertex shader evaluates the patches: it can do grids only, and not of every degree. */
  onGpu({ surface, settings: { evaluation, detail } }: Scene) {
    if (evaluation !== "gpu" || !("segments" in detail) || hasWeights(surface)) return false;
    return patchesOf(surface).every(({ degreeU, degreeV }) => Math.max(degreeU, degreeV) <= MAX_GPU_DEGREE);
  }

  /** What is drawn of the surface: all of it, or what the curve of constant u has swept. */
  shown({ surface, settings: { swept, u } }: Scene) {
    if (!swept || u === 1 || hasWeights(surface)) return surface;
    return this.#memo.get("swept", [surface, u], () => sweptBy(surface, u));
  }

  /** The mesh of the core. */
  mesh(scene: Scene): Mesh {
    const { detail, shading, evaluation } = scene.settings;
    const surface = this.shown(scene);
    const own = shading === "patches" || shading === "gaussian" || shading === "mean"; // needs patch numbers and uvs
    const method = evaluation === "forward" ? "forward-difference" : "bernstein";
    const projection = "pixels" in detail ? this.#projection : null;
    const make = (before: Mesh | undefined) => {
      const [mesh, ms] = timed(() => this.#make(surface, detail, own, method, reusable(before, surface)));
      this.#ms = ms;
      return mesh;
    };
    return this.#memo.get(
      "mesh",
      [surface, ...Object.values(detail), Object.keys(detail)[0], own, method, projection],
      make,
    );
  }

  /**
   * @param method of grids
   */
  #make(
    surface: Surface,
    detail: Settings["detail"],
    own: boolean,
    method: "bernstein" | "forward-difference",
    into: Mesh | undefined,
  ) {
    const weld = own ? "none" : "normal";
    if ("segments" in detail) return surface.grid({ ...detail, method, into });
    if ("tolerance" in detail) return surface.tessellate({ ...detail, weld, into });
    if ("flatness" in detail) {
      this.#pieces = surface.subdivide(detail.flatness);
      return piecesMesh(surface, this.#pieces);
    }
    const { viewProjection = [], viewport = [] } = this.#projection ?? {};
    return surface.tessellate({ ...detail, viewProjection, viewport, weld, into });
  }

  /** A mesh to take away: as fine as the one that is seen, and closed where the surface is. */
  closedMesh({ surface, settings: { detail } }: Scene): Mesh {
    return "segments" in detail
      ? surface.tessellate(detail)
      : this.#make(surface, detail, false, "bernstein", undefined);
  }

  /** The number of the mesh: its arrays are reused, so that it is always the same object. */
  version(withCurvatures = false) {
    return this.#memo.version(withCurvatures ? "curvatures" : "mesh");
  }

  /** Gaussian and mean curvature of each vertex, where the shading asks for them. */
  curvatures(scene: Scene) {
    const { shading } = scene.settings;
    if (shading !== "gaussian" && shading !== "mean") return null;
    const mesh = this.mesh(scene);
    return this.#memo.get("curvatures", [this.version()], () => curvaturesOf(this.shown(scene), mesh));
  }

  /** The sides of its triangles. */
  edges(scene: Scene) {
    const mesh = this.mesh(scene);
    return this.#memo.get("edges", [this.version()], () => lines.edges(mesh));
  }

  isocurves(scene: Scene) {
    const [surface, count] = [this.shown(scene), scene.settings.lines];
    return this.#memo.get("isocurves", [surface, count], () => lines.isocurves(surface, count));
  }

  /** The gaps of the recursion's mesh; null for the other meshes, which have none. */
  cracks(scene: Scene) {
    if (!("flatness" in scene.settings.detail)) return null;
    this.mesh(scene);
    return this.#memo.get("cracks", [this.version()], () => cracksOf(this.shown(scene), this.#pieces));
  }

  /** The curves as bodies: tubes, or ribbons that lie in the surface. */
  wires(kind: "tubes" | "ribbons", scene: Scene): Mesh {
    const {
      sphere,
      settings: { lines: count },
    } = scene;
    const surface = this.shown(scene);
    const size =
      kind === "tubes"
        ? { radius: sphere.radius * TUBE_RADIUS, sides: TUBE_SIDES }
        : { width: sphere.radius * RIBBON_WIDTH };
    const make = (before: Mesh | undefined) => {
      const into = reusable(before, surface);
      const [mesh, ms] = timed(() => surface.wireframe({ lines: count, ...size, into }));
      this.#wiresMs[kind] = ms;
      return mesh;
    };
    return this.#memo.get(kind, [surface, sphere, count], make);
  }

  wiresVersion(kind: "tubes" | "ribbons") {
    return this.#memo.version(kind);
  }

  net({ surface, picked }: Scene) {
    return this.#memo.get("net", [surface, picked], () => lines.nets(surface, picked));
  }

  outline({ surface, picked }: Scene) {
    return this.#memo.get("outline", [surface, picked], () =>
      picked === null ? new Float32Array() : lines.outline(patchesOf(surface)[picked]),
    );
  }

  casteljau({ surface, picked, settings: { u, v, step } }: Scene) {
    return this.#memo.get(
      "casteljau",
      [surface, picked, u, v, step],
      () => lines.casteljau(patchesOf(surface)[picked ?? 0], u, v, hasWeights(surface) ? 0 : step), // none with weights
    );
  }

  /** The point that the page asks about, the nearest one of the surface, and the way between them. */
  probe({ surface, settings: { probe } }: Scene) {
    return this.#memo.get("probe", [surface, probe], () => {
      const found = probe && nearestTo(surface, probe);
      if (!found) return null;
      return {
        way: Float32Array.from([...probe, ...found.point]),
        at: Float32Array.from(probe),
        nearest: Float32Array.from(found.point),
      };
    });
  }

  /** The curves of constant u and v, and where they meet. */
  place({ surface, picked, settings: { u, v } }: Scene) {
    return this.#memo.get("place", [surface, picked, u, v], () => lines.place(patchesOf(surface)[picked ?? 0], u, v));
  }

  /** The derivatives and the normal at (u, v). */
  derivatives({ surface, picked, sphere, settings: { u, v } }: Scene) {
    return this.#memo.get("derivatives", [surface, picked, u, v], () =>
      arrowsAt(patchesOf(surface)[picked ?? 0], u, v, sphere.radius),
    );
  }

  /** What the picture is made of, in numbers. */
  facts(scene: Scene): Facts {
    const { layers } = scene.settings;
    const shown = layers.has("surface") || layers.has("mesh");
    const facts: Facts = shown
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

  #meshFacts(scene: Scene): Facts {
    const {
      surface,
      settings: { detail },
    } = scene;
    if (this.onGpu(scene) && "segments" in detail) {
      const { segments } = detail;
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

  #error(scene: Scene): { error: number | null; unit: "" | "px" } {
    const { detail } = scene.settings;
    const surface = this.shown(scene);
    if ("flatness" in detail || ("segments" in detail && hasWeights(surface))) return { error: null, unit: "" }; // no bound
    if ("tolerance" in detail) return { error: detail.tolerance, unit: "" };
    if ("pixels" in detail) return { error: detail.pixels, unit: "px" };
    return {
      error: this.#memo.get("error", [surface, detail.segments], () => errorBound(surface, detail.segments)),
      unit: "",
    };
  }

  #recursion(scene: Scene): Recursion | null {
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

/** An earlier mesh whose arrays can be written again: those of casteljau/nurbs are of another class. */
function reusable(mesh: Mesh | undefined, surface: Surface) {
  return mesh instanceof Mesh && !hasWeights(surface) ? mesh : undefined;
}

/** What comes out, and how long it took. */
function timed<T>(make: () => T): [T, number] {
  const begin = performance.now();
  return [make(), performance.now() - begin];
}

/**
 * Two numbers for each vertex.
 *
 * @param mesh with uvs and patch numbers
 */
function curvaturesOf(surface: Surface, { uvs, patchIds }: Mesh) {
  const patches = patchesOf(surface);
  const numbers = new Float32Array(uvs?.length ?? 0);
  for (let i = 0; uvs && patchIds && i < patchIds.length; i++) {
    const { gaussian, mean } = patches[patchIds[i]].curvature(uvs[2 * i], uvs[2 * i + 1]);
    numbers.set([gaussian, mean], 2 * i);
  }
  return numbers;
}
