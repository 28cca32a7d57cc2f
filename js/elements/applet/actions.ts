// What the user can do besides dragging: every action once, for its button and its key.
import { controlGroups } from "../attribute-text.js";
import { roomiestAmong } from "../../applet/random.js";
import { save } from "../page-files.js";
import * as edits from "./edits.js";
import { blobOf, codeOf } from "./export.js";
import { svgFigure } from "./layers/svg.js";
import { FIELDS } from "./fields.js";
import { textIn, withText } from "./files.js";
import { Player } from "./player.js";
import { jointsOf } from "./joints.js";
import * as states from "./state.js";
import { MODE_NAMES, placeWords } from "./words.js";
import type { State } from "./state.js";
import type { Point2 } from "./state.js";

export type Actions = AppletActions["actions"];

export class AppletActions {
  host: import("./editing.js").AppletEditing;
  actions: {
    play: () => void;
    undo: () => void;
    redo: () => void;
    reset: () => undefined;
    randomize: () => undefined;
    toggle: () => undefined;
    append: () => void;
    insert: () => undefined;
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
  speaker: import("../../applet/voice.js").Speaker | null = null;
  /** The messages of the layers. */
  messages: { name: string; words: string }[] = [];
  /** The point that was touched last. */
  selected = -1;
  /** What has been said of the message and the joints; it is not said again. */
  announced: string[] = [];
  /** Whether taps move it. */
  tapping = false;
  player = new Player((by) => this.#advance(by));
  #language: import("./export.js").Language = "js";

  constructor(host: import("./editing.js").AppletEditing) {
    this.host = host;
    this.actions = this.#actions();
  }

  begin(stage: import("./stage.js").Stage, speaker: import("../../applet/voice.js").Speaker) {
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
    return svgFigure(this.host.now(), this.host.made(), {
      theme: this.stage?.theme,
      label: this.host.name,
      opaque: true,
    });
  }

  toCode(language: import("./export.js").Language) {
    return codeOf(this.host.now(), this.host.made(), language);
  }

  /** The picture as a PNG. */
  toBlob() {
    return this.stage ? blobOf(this.host.now(), this.host.made(), this.stage.theme) : null;
  }

  /** Something the user does at once, and what is announced of it. */
  do(change: (state: State) => State, words: string) {
    this.stage?.release();
    const done = this.host.updateByUser(change);
    if (!done) this.announced = this.announced.slice(1); // the same refusal is announced again
    this.speaker?.say(done ? words : "");
    return done;
  }

  appendAt(at: Point2) {
    if (this.do((state) => edits.appended(state, at), "Point added")) this.focusPoint(this.host.now().shown - 1);
  }

  /**
   * @param bare without healing
   */
  removeAt(index: number, bare = false) {
    const name = this.host.made().names[index];
    return this.do((state) => edits.removed(state, index, bare), `${name} removed`);
  }

  /** The keyboard goes to a point, also to one that has just come. */
  focusPoint(index: number) {
    this.stage?.place();
    this.stage?.handles.focus(Math.min(index, this.host.now().shown - 1));
  }

  hold(joint: number, mode: string) {
    const { names, degree } = this.host.made();
    this.do(
      (state) => edits.withJoint(state, joint, mode),
      `${names[joint * degree]} held: ${MODE_NAMES[mode as states.JointMode]}`,
    );
  }

  /**
   * Another mode for the joint at a point.
   *
   * @returns false where there is no joint
   */
  cycle(index: number): boolean {
    const joint = index / (edits.chainOf(this.host.now())?.degree ?? NaN);
    const mode = this.host.joints[joint - 1];
    if (!mode || this.host.readonly) return false;
    this.hold(joint, states.MODES[(states.MODES.indexOf(mode) + 1) % states.MODES.length]);
    return true;
  }

  /** What came by drop or paste. */
  take(text: string) {
    if (!this.host.readonly) this.do((state) => withText(state, text), "Opened");
  }

  /** The words for some points and where they are. */
  places(indices: number[]) {
    const { names, points } = this.host.made();
    const there = indices.filter((index) => index < points.length); // the page may have taken some away meanwhile
    return there.map((index) => `${names[index]} at ${placeWords(points[index])}`).join(". ");
  }

  zoom(factor: number) {
    const { x, y, width, height } = this.host.now().view;
    this.host.display(states.zoomed(this.host.now(), factor, [x + width / 2, y + height / 2]));
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
      undo: () => this.#goBack(() => this.host.undo(), "Undone"),
      redo: () => this.#goBack(() => this.host.redo(), "Done again"),
      reset: () => void this.do(() => this.host.origin, "As at first"),
      randomize: () =>
        void this.do((state) => edits.randomized(state, Math.floor(Math.random() * 2 ** 32)), "Points randomized"),
      toggle: () =>
        void (this.do(states.allPointsToggled, "") && this.speaker?.say(`${this.host.now().shown} points shown`)),
      append: () => this.appendAt(roomiestAmong(this.host.now().box, this.host.now().points)),
      insert: () => void this.do((state) => edits.inserted(state), "Split at t"),
      removeSelected: () => void this.removeAt(this.selected),
      tapping: () => {
        this.tapping = !this.tapping;
        this.host.say(this.tapping ? "Tap a point, then the place where it shall be." : "", true);
        this.host.requestUpdate();
      },
      help: () => this.host.renderRoot.querySelector("dialog")?.showModal(),
      home: () => this.host.display(states.withHome(this.host.now())),
      saveSvg: () => download("svg", this.toSVG(), "image/svg+xml"),
      savePng: async () => {
        const blob = await this.toBlob();
        if (blob) download("png", blob, "");
      },
      saveJson: () => download("json", JSON.stringify(this.host), "application/json"),
      open: async (file: File) => this.take(await textIn(file)),
      refresh: () => this.host.requestUpdate(),
      language: (language: string) => {
        this.#language = language as import("./export.js").Language;
        this.host.requestUpdate();
      },
      copy: () => this.#copy(),
    };
  }

  panelPort(): import("./panel.js").PanelPort {
    const figure = this.host.made();
    const state = this.host.now();
    const wanted = controlGroups(this.host.controls);
    const codeShown = (this.host.renderRoot.querySelector("details.save") as HTMLDetailsElement | null)?.open;
    return {
      state,
      figure,
      joints: jointsOf(figure),
      modes: this.host.joints,
      messages: this.messages,
      shows: (group) => !wanted.length || wanted.includes(group),
      isComplete: !wanted.length,
      readonly: this.host.readonly,
      playing: this.player.playing,
      tapping: this.tapping,
      selected: this.selected < state.shown ? this.selected : -1,
      can: { undo: this.host.history.canUndo, redo: this.host.history.canRedo, insert: edits.canInsert(state) },
      set: (change) => void this.do(change, ""),
      put: (name, value, done = true) => {
        this.host.attempt(() => this.host.updateOpenStep((now) => put(now, name, value)));
        if (done) this.host.commit();
      },
      act: this.actions,
      hold: (joint, mode) => this.hold(joint, mode),
      zoom: (factor) => this.zoom(factor),
      code: codeShown ? codeOf(this.host.now(), this.host.made(), this.#language) : "",
      language: this.#language,
    };
  }

  #advance(by: number) {
    const state = this.host.now();
    const [min, max] = states.rangeOfT(state);
    const t = Math.min(Math.max(state.t + by, min), max);
    this.host.display({ ...state, t });
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

  #goBack(act: () => void, words: string) {
    const before = this.host.now();
    this.stage?.cancel();
    act();
    if (this.host.now() === before) return;
    this.speaker?.say(words);
    this.host.fire("input");
    this.host.fire("change");
  }

  async #copy() {
    try {
      await navigator.clipboard.writeText(codeOf(this.host.now(), this.host.made(), this.#language));
      this.host.say("Copied.", true);
    } catch {
      this.host.say("The page may not write to the clipboard: mark the code and copy it.");
    }
    this.speaker?.say("");
  }
}

/** A field of the state by the user's hand. A matrix of their own begins with what the curve has. */
function put(state: State, name: string, value: unknown): State {
  const next = FIELDS[name].put(state, value);
  return name === "basis" && value === "matrix" ? edits.withOwnMatrix(next, state) : next;
}
