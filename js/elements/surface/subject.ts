// What the element shows: the named or given surface and the points that were dragged.
import { frameOf } from "./camera.js";
import { Memo } from "./memo.js";
import { framingPoints, surfaceNamed } from "./models.js";
import type { Surface } from "../../surfaces.js";
import type { Scene } from "./geometry.js";
import type { Settings } from "./settings.js";

export class Subject {
  #memo = new Memo();
  #given: Surface | null = null;
  /** What was dragged: vertex and place. */
  #moves: Map<number, number[]> = new Map();
  /** The surface with all moves. */
  #edited: { base: Surface; surface: Surface } | null = null;

  /** A surface of the page's own, or null where the model's name says which. */
  get given() {
    return this.#given;
  }

  set given(surface) {
    this.#given = surface;
    this.#moves.clear();
    this.#edited = null;
  }

  get edited() {
    return this.#moves.size > 0;
  }

  move(vertex: number, to: number[]) {
    this.#moves.set(vertex, to);
    if (this.#edited) this.#edited.surface = this.#edited.surface.movePoint(vertex, to);
  }

  restore() {
    this.#moves.clear();
    this.#edited = null;
  }

  /** With all moves: parts that are taken away and put back keep theirs. */
  surface(settings: Settings): Surface {
    const { model, parts, height, up } = settings;
    const base = this.#memo.get(
      "base",
      [this.#given, model, [...parts].join(), height, up],
      () => this.#given ?? surfaceNamed(settings),
    );
    if (this.#moves.size === 0) return base;
    if (this.#edited?.base !== base) {
      const surface = [...this.#moves].reduce((moved, [vertex, to]) => moved.movePoint(vertex, to), base);
      this.#edited = { base, surface };
    }
    return this.#edited.surface;
  }

  /**
   * The same object as long as nothing in it changes.
   *
   * @param patch the picked one; the only one is always picked
   */
  scene(settings: Settings, patch: number | null): Scene {
    const { model, height, up } = settings;
    const surface = this.surface(settings);
    const frame = this.#memo.get("frame", [this.#given, model, height, up], () =>
      frameOf(this.#given?.vertices ?? framingPoints(settings), up),
    );
    const known = patch !== null && patch >= 0 && patch < surface.patchCount;
    const picked = surface.patchCount === 1 ? 0 : known ? Math.floor(patch) : null;
    return this.#memo.get("scene", [settings, surface, frame, picked], () => ({ settings, surface, frame, picked }));
  }
}
