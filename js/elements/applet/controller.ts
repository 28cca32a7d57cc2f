// What the user does in `<bezier-applet>`. Pointers, keys and controls become changes of the editor's state; controls and picture are
// rendered together in the next frame.
import { controlGroups } from "../attribute-text.js";
import { Announcer, setText } from "../../ui/announcer.js";
import { Drags } from "../../ui/drag.js";
import { listenToFiles, save } from "../../ui/files.js";
import { listenToPageKeys } from "../../ui/key-targets.js";
import { arrowStep, historyStep, isForText, isPlain, keyOf } from "../../ui/keys.js";
import { Player } from "../../ui/playback.js";
import { onDoubleTap } from "../../ui/taps.js";
import { listenToGestures } from "../../ui/viewport.js";
import { actionOf, actionOfKey } from "../../editor/actions.js";
import { codeOf } from "../../editor/code.js";
import * as commands from "../../editor/commands.js";
import { description, MODE_NAMES, placeWords, weightWords } from "../../editor/descriptions.js";
import { textIn, withText } from "../../editor/import.js";
import { jointsOf } from "../../editor/joints.js";
import { clamped } from "../../editor/plane.js";
import { FIELDS } from "../../editor/schema.js";
import { snapped, turnedBy15 } from "../../editor/snapping.js";
import * as states from "../../editor/state.js";
import { translated } from "../../editor/translations.js";
import { ALL_LAYERS } from "../../layers/index.js";
import { svgFigure } from "../../layers/svg.js";
import { blobOf } from "./export.js";
import { Picture } from "./picture.js";
import type { ActionName } from "../../editor/actions.js";
import type { Language } from "../../editor/code.js";
import type { Point2, State } from "../../editor/state.js";
import type { LayerMessage } from "../../layers/draw-figure.js";
import type { ControlGroups } from "../attribute-text.js";
import type { AppletHost, Rational } from "./model.js";

/** A tap that moves farther is none. */
const TAP_PX = 8;

/** Actions whose keys count on the whole page. */
const PAGE_WIDE: readonly ActionName[] = ["randomize", "toggle"];

export class AppletController {
  host: AppletHost;
  picture: Picture | null = null;
  announcer: Announcer | null = null;
  /** The messages of the layers. */
  messages: LayerMessage[] = [];
  /** The point that was touched last; −1 for none. */
  selected = -1;
  /** Whether a tap moves it. */
  isTapping = false;
  /** What has been said of the message and the joints; it is not said again. */
  announced: string[] = [];
  /** The language of the code that is shown. */
  language: Language = "js";
  player = new Player((by) => this.#advance(by));
  #drags: Drags | null = null;
  /** Where the user points, in the plane; it is no part of the state. */
  #pointer: Point2 | null = null;
  /** What the canvas shows: the state, whether handles are disabled, and the theme of the colours. */
  #drawn: { state: State | null; readonly: boolean; theme: string } = { state: null, readonly: false, theme: "" };
  /** The next frame, and what waits for it. */
  #next: { frame: number; rendered: Promise<void>; finish: () => void } | null = null;
  #stopListening: (() => void) | null = null;

  constructor(host: AppletHost) {
    this.host = host;
  }

  get model() {
    return this.host.model;
  }

  get editor() {
    return this.host.model.editor;
  }

  // One render of controls and picture in a frame

  /** Begins to listen to the element. */
  listen() {
    const { host } = this;
    host.addEventListener("keydown", (event) => {
      const isElsewhere =
        event.defaultPrevented ||
        isForText(event) ||
        event.composedPath().some((each) => each instanceof HTMLDialogElement);
      if (!isElsewhere && this.#press(event)) event.preventDefault();
    });
    for (const type of ["keyup", "focusout"])
      host.addEventListener(type, () => void (this.#drags?.active || this.editor.commit()));
    host.addEventListener("focusin", (event) => this.#select(this.#pointOf(event)));
    listenToFiles(host, { busy: isForText, take: (text) => this.open(text), textIn });
  }

  get isRunning() {
    return this.#stopListening !== null;
  }

  /** The element is in the page, and its shadow tree is up to date. */
  start() {
    const { host } = this;
    const isNew = !this.picture; // then it has just read the colours
    this.picture ??= this.#createPicture();
    const wasRunning = this.isRunning;
    if (!wasRunning) {
      this.#stopListening = this.#listenToPage();
      this.picture.start(() => this.#draw()); // draws in the next frame, when the size is known
      this.#drawn.theme = isNew ? host.theme : ""; // colours may have changed meanwhile
    }
    if (!this.announced.includes(this.message)) this.announcer?.say();
    const { state, readonly, theme } = this.#drawn;
    if (theme !== host.theme) this.picture.readTheme();
    const isDrawn = state === this.editor.state && readonly === host.readonly && theme === host.theme;
    if (wasRunning && !isDrawn) void this.schedule();
    this.#drawn.theme = host.theme;
  }

  /** Leaves nothing running. */
  end() {
    this.player.stop();
    this.#drags?.cancel();
    this.#stopListening?.();
    this.#stopListening = null;
    this.picture?.end();
    this.announcer?.end();
    if (!this.#next) return;
    cancelAnimationFrame(this.#next.frame);
    this.host.renderControls();
    this.#finish();
  }

  /** Renders controls and picture in the next frame. @returns resolves when that has happened */
  schedule(): Promise<void> {
    if (!this.#next) {
      let finish = () => {};
      const rendered = new Promise<void>((resolve) => (finish = resolve));
      this.#next = { frame: requestAnimationFrame(() => this.#render()), rendered, finish };
    }
    return this.#next.rendered;
  }

  #render() {
    try {
      this.#drags?.apply();
      this.host.renderControls();
      this.#draw();
    } finally {
      this.#finish();
    }
  }

  #finish() {
    this.#next?.finish();
    this.#next = null;
  }

  #draw() {
    const { state } = this.editor;
    this.#drawn = { ...this.#drawn, state, readonly: this.host.readonly };
    const messages = this.picture?.draw(this.#pointer, this.layers, this.host.readonly) ?? [];
    if (JSON.stringify(messages) === JSON.stringify(this.messages)) return;
    this.messages = messages;
    this.announcer?.say(); // the description has other words
    if (this.hasControls) this.host.requestUpdate();
  }

  #createPicture() {
    const root = this.host.renderRoot;
    const picture = new Picture(root, this.model);
    const { overlay } = picture;
    this.#drags = new Drags(overlay, {
      count: () => (this.host.readonly ? 0 : picture.handleCount),
      elementOf: (index) => picture.handleElement(index),
      placeOf: (index) => picture.handlePlace(index),
      toViewBox: (event) => picture.planePoint(event),
      schedule: () => void this.schedule(),
      started: () => this.editor.commit(),
      grabbed: (index) => {
        picture.focusHandle(index);
        const target = picture.handleTarget(index);
        if (target.kind === "point") this.#select(index);
      },
      move: (index, to, drag) => this.#move(index, to, drag),
      cancelled: () => this.editor.revert(),
      ended: (moved) => this.#moved(moved),
    });
    onDoubleTap(overlay, (event) => {
      if (!this.host.readonly && !this.isTapping) this.#append(picture.planePoint(event));
    });
    overlay.addEventListener("input", (event) => this.#slide(event.target as HTMLInputElement));
    overlay.addEventListener("change", () => this.editor.commit());
    let [x, y] = [0, 0];
    overlay.addEventListener("pointerdown", (event) => ([x, y] = [event.clientX, event.clientY]));
    overlay.addEventListener("click", (event) => {
      const isStill = Math.hypot(event.clientX - x, event.clientY - y) <= TAP_PX;
      if (event.target === overlay && isStill) this.#tap(picture.planePoint(event));
    });
    overlay.addEventListener("pointermove", (event) => this.#point(event));
    overlay.addEventListener("pointerleave", () => this.#point(null));
    listenToGestures(overlay, {
      place: (event) => picture.planePoint(event),
      isEnlarged: () => !states.isHome(this.editor.state),
      zoomAt: (factor, from, to) => this.#zoomAt(factor, from, to),
    });
    this.announcer = new Announcer(root.querySelector("[role=status]") as HTMLElement, () => this.#describe());
    this.#describe();
    return picture;
  }

  // Pointers

  /** A part of what the user is doing. */
  #changePart(change: (state: State) => State) {
    this.model.attempt(() => this.editor.dispatch(change, { by: "user", merge: true }));
  }

  /** A handle is dragged to a place in the plane. */
  #move(index: number, to: Point2, { from, event }: { from: Point2; event?: PointerEvent }) {
    if (!this.picture || index >= this.picture.handleCount) return; // the page may have removed it meanwhile
    const { state, figure } = this.model;
    const place = clamped(state.view, to);
    const target = this.picture.handleTarget(index);
    if (target.kind === "weight")
      return this.#changeWeight((state, { withWeightPointAt }) => withWeightPointAt(state, target.index, place));
    if (index >= figure.points.length) return;
    const { unitsPerPixel } = this.picture;
    const rounded = this.#roundedToPixels(place);
    const { shiftKey = false, altKey = false, ctrlKey = false, metaKey = false } = event ?? {};
    this.#changePart((state) => {
      const free = altKey ? commands.broken(state, index) : state;
      const there = shiftKey
        ? turnedBy15(free, index, rounded, from)
        : ctrlKey || metaKey || altKey
          ? rounded
          : snapped(free, index, rounded, unitsPerPixel);
      return commands.withPointAt(free, index, there);
    });
  }

  /** Rounded to a fraction of a pixel that nobody sees, because positions of pointers are quotients with many digits. */
  #roundedToPixels([x, y]: Point2): Point2 {
    const digits = 3 - Math.floor(Math.log10(states.scaleOf(this.editor.state)));
    return [Number(x.toFixed(digits)), Number(y.toFixed(digits))];
  }

  /** The last pointer has let go of its handle. */
  #moved(handles: number[]) {
    this.editor.commit();
    const targets = handles.flatMap((index) => this.picture?.handleTarget(index) ?? []);
    const indices = (kind: string) => targets.filter((each) => each.kind === kind).map(({ index }) => index);
    const words = [this.placeWords(indices("point")), ...indices("weight").map((index) => this.weightWords(index))];
    if (words.some(Boolean)) this.announcer?.say(words.filter(Boolean).join(". "));
  }

  /** A screen reader has moved a slider of a point, or a slider of a weight has been moved. */
  #slide(input: HTMLInputElement) {
    const { picture } = this;
    if (!picture) return;
    const weight = picture.weightOf(input);
    if (weight >= 0) {
      const value = picture.sliderWeight(weight);
      this.#changeWeight((state, { withWeight }) => withWeight(state, weight, value));
      return this.announcer?.say(this.weightWords(weight));
    }
    const index = picture.pointOf(input);
    const { points, box } = this.editor.state;
    const [x, y] = points[index];
    const value = Number(input.value);
    const to: Point2 = input.dataset.axis === "x" ? [value, y] : [x, box.height - value]; // more is higher up
    this.#moveByKey(index, to);
  }

  /** Moves a point as far as the picture goes. */
  #moveByKey(index: number, to: Point2) {
    this.#changePart((state) => commands.withPointAt(state, index, clamped(state.view, to)));
    this.announcer?.say(this.placeWords([index]));
  }

  #changeWeight(change: (state: State, rational: Rational) => State) {
    const { rational } = this.model;
    if (rational) this.#changePart((state) => change(state, rational));
  }

  /** A tap on an empty place. */
  #tap(at: Point2) {
    if (this.isTapping && this.selected >= 0)
      this.change((state) => commands.withPointAt(state, this.selected, at), this.placeWords([this.selected]));
  }

  /** The pointer has moved or left. Only two layers show where it is. */
  #point(event: PointerEvent | null) {
    const { layers } = this.editor.state;
    const isShown = layers.has("nearest") || (layers.has("construction") && !layers.has("names"));
    if (!isShown && !this.#pointer) return;
    this.#pointer = isShown && event ? (this.picture?.planePoint(event) ?? null) : null;
    void this.schedule();
  }

  /** Enlarges about a place and brings it to another. */
  #zoomAt(factor: number, from: Point2, to: Point2) {
    const state = states.zoomed(this.editor.state, factor, from);
    const { view } = state;
    this.editor.replaceState({ ...state, view: { ...view, x: view.x + from[0] - to[0], y: view.y + from[1] - to[1] } });
  }

  // Keys

  /** @returns whether the key was used */
  #press(event: KeyboardEvent): boolean {
    const { host, picture } = this;
    const isOff = host.hotkeys === "off";
    const index = this.#pointOf(event);
    const arrow = arrowStep(event);
    const weight = arrow ? (picture?.weightOf(event.composedPath()[0]) ?? -1) : -1;
    if (arrow && weight >= 0) return this.#stepWeight(weight, arrow[0] - arrow[1]);
    if (arrow && index >= 0) return this.#stepPoint(index, arrow);
    if (event.key === "Escape") return this.#drags?.cancel() ?? false;
    if (isOff || event.isComposing) return false;
    const step = historyStep(event);
    if (step) return this.#runByKey(step);
    if (event.ctrlKey || event.metaKey || event.altKey || event.repeat) return false;
    if (index >= 0 && event.key === "Enter") return this.cycleJoint(index);
    if (index >= 0 && ["Delete", "Backspace"].includes(event.key)) {
      if (!host.readonly && this.remove(index, event.shiftKey)) this.focusPoint(index);
      return true;
    }
    if (event.key === "?") {
      this.showKeys();
      return true;
    }
    const action = actionOfKey(keyOf(event));
    return action !== undefined && this.#runByKey(action);
  }

  /**
   * Listens to `r` and `m` on the page, which count if the element is under the pointer or the only applet in view.
   *
   * @returns stops listening
   */
  #listenToPage(): () => void {
    const { host } = this;
    return listenToPageKeys(host, (event, target) => {
      const action = actionOfKey(keyOf(event));
      const counts = host.hotkeys !== "off" && isPlain(event) && !isForText(event);
      if (!counts || !action || !PAGE_WIDE.includes(action) || target() !== "page") return false;
      return this.#runByKey(action);
    });
  }

  #runByKey(name: ActionName): true {
    if (!this.host.readonly) this.run(name);
    return true;
  }

  #stepPoint(index: number, [dx, dy]: [number, number]): true {
    if (this.host.readonly) return true;
    const scale = states.scaleOf(this.editor.state);
    const [x, y] = this.editor.state.points[index];
    this.#moveByKey(index, [x + dx * scale, y + dy * scale]);
    return true;
  }

  #stepWeight(index: number, steps: number): true {
    if (this.host.readonly) return true;
    this.#changeWeight((state, { steppedWeight }) => steppedWeight(state, index, steps));
    this.announcer?.say(this.weightWords(index));
    return true;
  }

  #pointOf(event: Event) {
    return this.picture?.pointOf(event.composedPath()[0]) ?? -1;
  }

  /** The last point touched; its segment is the one that t is about. */
  #select(index: number) {
    if (index < 0) return;
    if (this.selected !== index) this.host.requestUpdate();
    this.selected = index;
    const { figure, state } = this.model;
    const pieces = figure.weights ? figure.rational : figure.pieces;
    if (pieces[state.segment]?.indices.includes(index)) return;
    const segment = pieces.findIndex(({ indices }) => indices.includes(index));
    if (segment >= 0) this.editor.replaceState({ ...state, segment });
  }

  /** Moves the focus to a point, also to one that has just been added. */
  focusPoint(index: number) {
    this.picture?.placeHandles(this.host.readonly);
    this.picture?.focusHandle(Math.min(index, this.editor.state.shown - 1));
  }

  // Changes

  /** Something that the user does at once, and what is announced of it; "": what the layers and joints say. */
  #do(act: () => void, words: () => string) {
    this.#drags?.end();
    this.editor.commit();
    const isDone = this.model.attempt(act);
    if (!isDone) this.announced = this.announced.slice(1); // the same refusal is announced again
    this.announcer?.say(isDone ? words() : "");
    return isDone;
  }

  /** A change by the user that is complete. */
  change(change: (state: State) => State, words = "") {
    return this.#do(
      () => this.editor.dispatch(change, { by: "user" }),
      () => words,
    );
  }

  /** An action of the table. */
  run(name: ActionName) {
    const { run, done } = actionOf(name);
    const { editor } = this;
    const before = editor.state;
    if (name === "undo" || name === "redo") this.#drags?.cancel();
    this.#do(
      () => run(editor),
      () => (editor.state === before ? "" : done(editor.state)),
    );
    if (name === "append" && editor.state !== before) this.focusPoint(editor.state.shown - 1);
  }

  /** Whether there is anything that an action could do. */
  canRun(name: ActionName) {
    return actionOf(name).enabled?.(this.editor) ?? true;
  }

  /** Another value of a field of the state. A matrix of the user's own begins with that of the basis before. */
  put(name: string, value: unknown, isDone = true) {
    this.#changePart((state) => {
      const next = FIELDS[name].put(state, value);
      return name === "basis" && value === "matrix" ? commands.withOwnMatrix(next, state) : next;
    });
    if (isDone) this.editor.commit();
  }

  #append(at: Point2) {
    if (this.change((state) => commands.appended(state, at), translated("Point added")))
      this.focusPoint(this.editor.state.shown - 1);
  }

  /** @param isBare only the point, without healing */
  remove(index: number, isBare = false) {
    const name = this.model.figure.names[index];
    return this.change((state) => commands.removed(state, index, isBare), translated("{0} removed", name));
  }

  /** Another mode of a joint, whose numbers begin with 1. */
  holdJoint(joint: number, mode: string) {
    const { names, degree } = this.model.figure;
    this.change(
      (state) => commands.withJoint(state, joint, mode),
      translated("{0} held: {1}", names[joint * degree], MODE_NAMES[mode as states.JointMode]),
    );
  }

  /**
   * The next mode of the joint at a point.
   *
   * @returns false where there is no joint
   */
  cycleJoint(index: number): boolean {
    const joint = index / (commands.chainOf(this.editor.state)?.degree ?? NaN);
    const mode = commands.modesOf(this.editor.state)[joint - 1];
    if (!mode || this.host.readonly) return false;
    this.holdJoint(joint, states.MODES[(states.MODES.indexOf(mode) + 1) % states.MODES.length]);
    return true;
  }

  /** A figure as text, which was dropped, pasted or read from a file. */
  open(text: string) {
    if (!this.host.readonly) this.change((state) => withText(state, text), translated("Opened"));
  }

  async openFile(file: File) {
    this.open(await textIn(file));
  }

  /** Enlarges about the middle of the picture. */
  zoom(factor: number) {
    const { x, y, width, height } = this.editor.state.view;
    this.editor.replaceState(states.zoomed(this.editor.state, factor, [x + width / 2, y + height / 2]));
  }

  zoomToFit() {
    this.editor.replaceState(states.withHome(this.editor.state));
  }

  toggleTapping() {
    this.isTapping = !this.isTapping;
    this.model.say(this.isTapping ? translated("Tap a point, then the place where it shall be.") : "", true);
    this.host.requestUpdate();
  }

  showKeys() {
    this.host.renderRoot.querySelector("dialog")?.showModal();
  }

  togglePlayer() {
    const { playing } = this.player;
    if (playing) this.player.stop();
    else this.player.start();
    if (playing) this.model.fire("change");
    this.host.requestUpdate();
  }

  /** The player changes t. @returns whether it is at an end */
  #advance(by: number) {
    const { state } = this.editor;
    const [min, max] = states.rangeOfT(state);
    const t = Math.min(Math.max(state.t + by, min), max);
    this.editor.replaceState({ ...state, t });
    this.model.fire("input");
    return t === (by > 0 ? max : min);
  }

  // What is saved

  /** The picture with all its layers. */
  toSVG() {
    const { state, figure, name } = this.model;
    const drawn = { ...state, pointer: this.#pointer };
    return svgFigure(drawn, figure, { theme: this.picture?.theme, label: name, opaque: true, layers: this.layers });
  }

  /** The picture as a PNG; null before there is one. */
  toBlob() {
    if (!this.picture) return null;
    const { state, figure } = this.model;
    return blobOf({ ...state, pointer: this.#pointer }, figure, this.picture.theme, this.layers);
  }

  toCode(language: Language) {
    return codeOf(this.editor.state, this.model.figure, language);
  }

  #save(ending: string, content: BlobPart, type: string) {
    save(this.host.ownerDocument, `curve.${ending}`, content instanceof Blob ? content : new Blob([content], { type }));
  }

  saveSVG() {
    this.#save("svg", this.toSVG(), "image/svg+xml");
  }

  async savePNG() {
    const blob = await this.toBlob();
    if (blob) this.#save("png", blob, "");
  }

  saveJSON() {
    this.#save("json", JSON.stringify(this.host), "application/json");
  }

  chooseLanguage(language: Language) {
    this.language = language;
    this.host.requestUpdate();
  }

  async copyCode() {
    try {
      await navigator.clipboard.writeText(this.toCode(this.language));
      this.model.say(translated("Copied."), true);
    } catch {
      this.model.say(translated("The page may not write to the clipboard: mark the code and copy it."));
    }
    this.announcer?.say("");
  }

  // What is shown and said

  /** What is drawn of this figure, from the back to the front. */
  get layers() {
    const { rational, state } = this.model;
    return rational && states.weightsOf(state) ? rational.RATIONAL_LAYERS : ALL_LAYERS;
  }

  get hasControls() {
    return this.host.controls !== null && this.host.controls !== false;
  }

  /** The groups of controls that are shown; none means all. */
  get groups(): ControlGroups {
    return controlGroups(this.host.controls);
  }

  /** The message below the picture. */
  get message() {
    return [...this.model.problems, this.model.message].filter(Boolean).join(" · ");
  }

  /** Brings the description of the picture up to date. @returns what is new in it */
  #describe() {
    const { state, figure } = this.model;
    const joints = jointsOf(figure);
    const messages = this.messages.map(({ words }) => words);
    const root = this.host.renderRoot;
    setText(root.querySelector("#description") as HTMLElement, description(state, figure, joints, messages));
    const facts = joints.map(({ at, verdict }) => translated("At {0}: {1}", at, verdict));
    const news = [this.message, ...facts].filter((each) => each && !this.announced.includes(each));
    this.announced = [this.message, ...facts];
    return news.join(". ");
  }

  /** The names and places of some points. */
  placeWords(indices: number[]) {
    const { names, points } = this.model.figure;
    const known = indices.filter((index) => index < points.length); // the page may have removed some meanwhile
    return known.map((index) => translated("{0} at {1}", names[index], placeWords(points[index]))).join(". ");
  }

  weightWords(index: number) {
    const { names, weights } = this.model.figure;
    return translated("Weight of {0}: {1}", names[index], weightWords(weights?.[index] ?? 1));
  }
}
