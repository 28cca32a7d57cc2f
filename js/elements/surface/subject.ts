// What the element shows: the named or given surface and the points that were dragged.
import { frameOf } from "./camera.js";
import { Memo } from "./memo.js";
import { framingPoints, surfaceNamed } from "./models.js";
import type { Rational } from "./loading.js";
import type { Surface } from "../../surfaces.js";
import type { Scene } from "./geometry.js";
import type { Settings } from "./settings.js";

/** What the user has changed of the surface; never modified. */
export interface Edits {
  /** A surface of the page's own or of a file, or null where the model's name says which */
  given: Surface | null;
  /** The model that the moves belong to, with its height and direction */
  model: string;
  /** What was dragged: vertex and place */
  moves: ReadonlyMap<number, number[]>;
}

const modelOf = ({ model, height, up }: Settings) => [model, height, up].join(" ");

export class Subject {
  /** What makes surfaces with weights, once it is loaded. */
  rational: Rational | null = null;
  #memo = new Memo();
  #edits: Edits = { given: null, model: "", moves: new Map() };
  /** The surface with all moves. */
  #edited: { base: Surface; moves: Edits["moves"]; surface: Surface } | null = null;

  get edits() {
    return this.#edits;
  }

  set edits(edits) {
    this.#edits = edits;
  }

  /** A surface of the page's own, or null where the model's name says which. */
  get given() {
    return this.#edits.given;
  }

  set given(surface) {
    this.#edits = { given: surface, model: "", moves: new Map() };
  }

  get edited() {
    return this.#edits.moves.size > 0;
  }

  move(vertex: number, to: number[], settings: Settings) {
    const { given, moves } = this.#edits;
    this.#edits = { given, model: modelOf(settings), moves: new Map(moves).set(vertex, to) };
    if (this.#edited?.moves !== moves) return;
    const { base, surface } = this.#edited;
    this.#edited = { base, moves: this.#edits.moves, surface: surface.movePoint(vertex, to) };
  }

  /** Takes back all moves. */
  restore() {
    if (this.edited) this.#edits = { ...this.#edits, moves: new Map() };
  }

  /** Forgets the moves of another model. */
  forgetMovesOfOthers(settings: Settings) {
    if (this.#edits.model !== modelOf(settings)) this.restore();
  }

  /** With all moves: parts that are taken away and put back keep theirs. */
  surface(settings: Settings): Surface {
    const { model, parts, height, up } = settings;
    const { given, moves } = this.#edits;
    const base = this.#memo.get(
      "base",
      [given, model, [...parts].join(), height, up, this.rational],
      () => given ?? surfaceNamed(settings, this.rational),
    );
    if (moves.size === 0) return base;
    if (this.#edited?.base !== base || this.#edited.moves !== moves) {
      const surface = [...moves].reduce((moved, [vertex, to]) => moved.movePoint(vertex, to), base);
      this.#edited = { base, moves, surface };
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
    const frame = this.#memo.get("frame", [this.given, model, height, up, this.rational], () =>
      frameOf(this.given?.vertices ?? framingPoints(settings, this.rational), up),
    );
    const known = patch !== null && patch >= 0 && patch < surface.patchCount;
    const picked = surface.patchCount === 1 ? 0 : known ? Math.floor(patch) : null;
    return this.#memo.get("scene", [settings, surface, frame, picked], () => ({ settings, surface, frame, picked }));
  }
}
