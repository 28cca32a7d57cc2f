// What `<bezier-surface>` shows, without its picture: the editor, and the settings, the surface and the scene of its state.
import { Editor } from "../../editor/editor.js";
import { Memo } from "../../editor/memo.js";
import { boundingSphereOf } from "./camera.js";
import { framingPoints, surfaceNamed } from "./models.js";
import { ATTRIBUTE_NAMES, SettingsReader } from "./settings.js";
import { firstState, TRANSIENT, withoutMoves } from "./state.js";
import type { Rational } from "./loading.js";
import type { Surface } from "../../surfaces.js";
import type { Scene } from "./geometry.js";
import type { Settings } from "./settings.js";
import type { State } from "./state.js";

export class Subject {
  editor = new Editor<State>(firstState(), TRANSIENT, TRANSIENT);
  /** What makes surfaces with weights, once it is loaded. */
  rational: Rational | null = null;
  /** The surface that was set last; one with weights is shown when the code for it is there, unless another one is set before. */
  assigned: unknown = null;
  #memo = new Memo();
  #reader;

  /** @param report is called with what is wrong with an attribute */
  constructor(report: (problem: string) => void) {
    this.#reader = new SettingsReader(report);
  }

  get state(): State {
    return this.editor.state;
  }

  /** What the attributes amount to; the same object as long as they are the same. */
  get settings(): Settings {
    const { state } = this;
    const given = ATTRIBUTE_NAMES.map((name) => state[name]);
    return this.#memo.get("settings", given, () => this.#reader.read(state));
  }

  /** The model that is shown where no surface is given, in its height and direction: moves belong to one. */
  get modelKey(): string {
    const { model, height, up } = this.settings;
    return [model, height, up].join(" ");
  }

  /** Forgets the moves of another model. */
  forgetMovesOfOthers() {
    if (this.state.movedModel !== this.modelKey) this.editor.replaceState(withoutMoves(this.state));
  }

  /** With all moves: parts that are taken away and put back keep theirs. */
  get surface(): Surface {
    const { settings } = this;
    const { model, parts, height, up } = settings;
    const { given, moves } = this.state;
    const base = this.#memo.get(
      "base",
      [given, model, [...parts].join(), height, up, this.rational],
      () => given ?? surfaceNamed(settings, this.rational),
    );
    if (moves.size === 0) return base;
    return this.#memo.get("moved", [base, moves], (before?: Moved) => moved(base, moves, before)).surface;
  }

  /**
   * The same object as long as nothing in it changes.
   *
   * @param patch the picked one; the only one is always picked
   */
  scene(patch: number | null): Scene {
    const { settings, surface } = this;
    const { model, height, up } = settings;
    const { given } = this.state;
    const sphere = this.#memo.get("sphere", [given, model, height, up, this.rational], () =>
      boundingSphereOf(given?.vertices ?? framingPoints(settings, this.rational), up),
    );
    const known = patch !== null && patch >= 0 && patch < surface.patchCount;
    const picked = surface.patchCount === 1 ? 0 : known ? Math.floor(patch) : null;
    return this.#memo.get("scene", [settings, surface, sphere, picked], () => ({ settings, surface, sphere, picked }));
  }
}

type Moved = { base: Surface; moves: State["moves"]; surface: Surface };

/** @param before is continued where it has no other moves */
function moved(base: Surface, moves: State["moves"], before?: Moved): Moved {
  const isContinued = before?.base === base && [...before.moves.keys()].every((vertex) => moves.has(vertex));
  const known = isContinued ? before : { moves: new Map(), surface: base };
  const changed = [...moves].filter(([vertex, to]) => known.moves.get(vertex) !== to);
  return { base, moves, surface: changed.reduce((at, [vertex, to]) => at.movePoint(vertex, to), known.surface) };
}
