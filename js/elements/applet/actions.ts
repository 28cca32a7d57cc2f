// What the user can do besides dragging: the actions of the editor, and those that need the page.
import { controlGroups } from "../attribute-text.js";
import { save } from "../../ui/files.js";
import { actionOf } from "../../editor/actions.js";
import * as commands from "../../editor/commands.js";
import { codeOf } from "../../editor/code.js";
import { blobOf } from "./export.js";
import { ALL_LAYERS, switchable } from "../../layers/index.js";
import { svgFigure } from "../../layers/svg.js";
import { FIELDS } from "../../editor/schema.js";
import { textIn, withText } from "../../editor/import.js";
import { Player } from "../../ui/playback.js";
import { jointsOf } from "../../editor/joints.js";
import * as states from "../../editor/state.js";
import { MODE_NAMES, placeWords, weightWords } from "../../editor/descriptions.js";
import { translated } from "../../editor/translations.js";
import type { ActionName } from "../../editor/actions.js";
import type { State } from "../../editor/state.js";
import type { Point2 } from "../../editor/state.js";

export type Actions = AppletActions["actions"];

export class AppletActions {
  host: import("./editing.js").AppletEditing;
  actions: {
    play: () => void;
    removeSelected: () => undefined;
    tapping: () => void;
    help: () => void;
    home: () => void;
    saveSvg: () => void;
    savePng: () => Promise<void>;
    saveJson: () => void;
    open: (file: File) => Promise<void>;
    refresh: () => void;
    language: (language: string) => void;
    copy: () => Promise<void>;
  };

  stage: import("./stage.js").Stage | null = null;
  speaker: import("../../ui/announcer.js").Speaker | null = null;
  /** The messages of the layers. */
  messages: { name: string; words: string }[] = [];
  /** The point that was touched last. */
  selected = -1;
  /** What has been said of the message and the joints; it is not said again. */
  announced: string[] = [];
  /** Whether taps move it. */
  tapping = false;
  player = new Player((by) => this.#advance(by));
  #language: import("../../editor/code.js").Language = "js";

  constructor(host: import("./editing.js").AppletEditing) {
    this.host = host;
    this.actions = this.#actions();
  }

  begin(stage: import("./stage.js").Stage, speaker: import("../../ui/announcer.js").Speaker) {
    this.stage = stage;
    this.speaker = speaker;
  }

  /** Whether there is a panel. */
  get panelled() {
    return this.host.controls !== null && this.host.controls !== false;
  }

  /** @param messages those of the layers */
  show(messages: { name: string; words: string }[]) {
    const changed = JSON.stringify(messages) !== JSON.stringify(this.messages);
    this.messages = messages;
    if (changed && this.panelled) this.host.requestUpdate();
  }

  /** @param index the point that is touched */
  choose(index: number) {
    if (this.selected !== index) this.host.requestUpdate();
    this.selected = index;
  }

  /** The picture with all its layers. */
  toSVG() {
    return svgFigure(this.host.editor.state, this.host.currentFigure(), {
      theme: this.stage?.theme,
      label: this.host.name,
      opaque: true,
      layers: this.layers,
    });
  }

  toCode(language: import("../../editor/code.js").Language) {
    return codeOf(this.host.editor.state, this.host.currentFigure(), language);
  }

  /** The picture as a PNG. */
  toBlob() {
    return this.stage ? blobOf(this.host.editor.state, this.host.currentFigure(), this.stage.theme, this.layers) : null;
  }

  /** Something the user does at once, and what is announced of it; undefined: what the layers and joints say. */
  do(act: () => void, words: () => string = () => "") {
    this.stage?.release();
    this.host.editor.commit();
    const done = this.host.attempt(act);
    if (!done) this.announced = this.announced.slice(1); // the same refusal is announced again
    this.speaker?.say(done ? words() : "");
    return done;
  }

  /** A change by the user that is complete. */
  change(change: (state: State) => State, words = "") {
    return this.do(
      () => this.host.editor.dispatch(change, { origin: "user" }),
      () => words,
    );
  }

  /** An action of the table. */
  run(name: ActionName) {
    const { run, done } = actionOf(name);
    const { editor } = this.host;
    const before = editor.state;
    if (name === "undo" || name === "redo") this.stage?.cancel();
    this.do(
      () => run(editor),
      () => (editor.state === before ? "" : done(editor.state)),
    );
    if (name === "append" && editor.state !== before) this.focusPoint(editor.state.shown - 1);
  }

  appendAt(at: Point2) {
    if (this.change((state) => commands.appended(state, at), translated("Point added")))
      this.focusPoint(this.host.editor.state.shown - 1);
  }

  /**
   * @param bare without healing
   */
  removeAt(index: number, bare = false) {
    const name = this.host.currentFigure().names[index];
    return this.change((state) => commands.removed(state, index, bare), translated("{0} removed", name));
  }

  /** The keyboard goes to a point, also to one that has just come. */
  focusPoint(index: number) {
    this.stage?.place();
    this.stage?.handles.focus(Math.min(index, this.host.editor.state.shown - 1));
  }

  hold(joint: number, mode: string) {
    const { names, degree } = this.host.currentFigure();
    this.change(
      (state) => commands.withJoint(state, joint, mode),
      translated("{0} held: {1}", names[joint * degree], MODE_NAMES[mode as states.JointMode]),
    );
  }

  /**
   * Another mode for the joint at a point.
   *
   * @returns false where there is no joint
   */
  cycle(index: number): boolean {
    const joint = index / (commands.chainOf(this.host.editor.state)?.degree ?? NaN);
    const mode = this.host.joints[joint - 1];
    if (!mode || this.host.readonly) return false;
    this.hold(joint, states.MODES[(states.MODES.indexOf(mode) + 1) % states.MODES.length]);
    return true;
  }

  /** What came by drop or paste. */
  take(text: string) {
    if (!this.host.readonly) this.change((state) => withText(state, text), translated("Opened"));
  }

  /** The words for some points and where they are. */
  places(indices: number[]) {
    const { names, points } = this.host.currentFigure();
    const there = indices.filter((index) => index < points.length); // the page may have taken some away meanwhile
    return there.map((index) => translated("{0} at {1}", names[index], placeWords(points[index]))).join(". ");
  }

  /** The words for the weight of a point. */
  weightWords(index: number) {
    const { names, weights } = this.host.currentFigure();
    return translated("Weight of {0}: {1}", names[index], weightWords(weights?.[index] ?? 1));
  }

  /** What is drawn of this figure, from the back to the front. */
  get layers() {
    const { rational, editor } = this.host;
    return rational && states.weightsOf(editor.state) ? rational.RATIONAL_LAYERS : ALL_LAYERS;
  }

  zoom(factor: number) {
    const { x, y, width, height } = this.host.editor.state.view;
    this.host.editor.show(states.zoomed(this.host.editor.state, factor, [x + width / 2, y + height / 2]));
  }

  #actions() {
    const download = (ending: string, content: BlobPart, type: string) =>
      save(
        this.host.ownerDocument,
        `curve.${ending}`,
        content instanceof Blob ? content : new Blob([content], { type }),
      );
    return {
      play: () => this.#play(),
      removeSelected: () => void this.removeAt(this.selected),
      tapping: () => {
        this.tapping = !this.tapping;
        this.host.say(this.tapping ? translated("Tap a point, then the place where it shall be.") : "", true);
        this.host.requestUpdate();
      },
      help: () => this.host.renderRoot.querySelector("dialog")?.showModal(),
      home: () => this.host.editor.show(states.withHome(this.host.editor.state)),
      saveSvg: () => download("svg", this.toSVG(), "image/svg+xml"),
      savePng: async () => {
        const blob = await this.toBlob();
        if (blob) download("png", blob, "");
      },
      saveJson: () => download("json", JSON.stringify(this.host), "application/json"),
      open: async (file: File) => this.take(await textIn(file)),
      refresh: () => this.host.requestUpdate(),
      language: (language: string) => {
        this.#language = language as import("../../editor/code.js").Language;
        this.host.requestUpdate();
      },
      copy: () => this.#copy(),
    };
  }

  panelPort(): import("./panel.js").PanelPort {
    const figure = this.host.currentFigure();
    const state = this.host.editor.state;
    const wanted = controlGroups(this.host.controls);
    const codeShown = (this.host.renderRoot.querySelector("details.save") as HTMLDetailsElement | null)?.open;
    return {
      state,
      figure,
      joints: jointsOf(figure),
      modes: this.host.joints,
      messages: this.messages,
      layers: switchable(this.layers),
      groups: wanted,
      shows: (group) => !wanted.size || wanted.has(group),
      isComplete: !wanted.size,
      readonly: this.host.readonly,
      playing: this.player.playing,
      tapping: this.tapping,
      selected: this.selected < state.shown ? this.selected : -1,
      can: (name) => actionOf(name).enabled?.(this.host.editor) ?? true,
      run: (name) => this.run(name),
      set: (change) => void this.change(change),
      put: (name, value, done = true) => {
        this.host.attempt(() =>
          this.host.editor.dispatch((now) => put(now, name, value), { origin: "user", merge: true }),
        );
        if (done) this.host.editor.commit();
      },
      act: this.actions,
      hold: (joint, mode) => this.hold(joint, mode),
      zoom: (factor) => this.zoom(factor),
      code: codeShown ? codeOf(this.host.editor.state, this.host.currentFigure(), this.#language) : "",
      language: this.#language,
    };
  }

  #advance(by: number) {
    const state = this.host.editor.state;
    const [min, max] = states.rangeOfT(state);
    const t = Math.min(Math.max(state.t + by, min), max);
    this.host.editor.show({ ...state, t });
    this.host.fire("input");
    return t === (by > 0 ? max : min);
  }

  #play() {
    const { playing } = this.player;
    if (playing) this.player.stop();
    else this.player.start();
    if (playing) this.host.fire("change");
    this.host.requestUpdate();
  }

  async #copy() {
    try {
      await navigator.clipboard.writeText(codeOf(this.host.editor.state, this.host.currentFigure(), this.#language));
      this.host.say(translated("Copied."), true);
    } catch {
      this.host.say(translated("The page may not write to the clipboard: mark the code and copy it."));
    }
    this.speaker?.say("");
  }
}

/** A field of the state by the user's hand. A matrix of their own begins with what the curve has. */
function put(state: State, name: string, value: unknown): State {
  const next = FIELDS[name].put(state, value);
  return name === "basis" && value === "matrix" ? commands.withOwnMatrix(next, state) : next;
}
