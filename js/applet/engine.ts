// The middle of the applet: holds the state, lets the user change it, shows it at most once a frame.
import { Editor } from "../editor/editor.js";
import { clamped } from "../editor/plane.js";
import { createControls } from "./controls.js";
import { derive } from "./derive.js";
import { Drags } from "../ui/drag.js";
import { draw } from "./draw.js";
import { Handles } from "../ui/handles.js";
import { arrowStep } from "../ui/keys.js";
import { listenToKeys } from "./keys.js";
import { generator } from "../editor/random.js";
import * as states from "./state.js";
import { onDoubleTap } from "../ui/taps.js";
import { followTheme, readTheme } from "../ui/theme.js";
import { createView } from "./view.js";
import { followSize } from "../ui/canvas-size.js";
import { Voice } from "./voice.js";
import { isOnCurve, place, shownWords } from "./words.js";
import { translated } from "../editor/translations.js";
import type { Nature } from "../ui/handles.js";
import type { State } from "./state.js";
import type { Box } from "../editor/plane.js";
import type { KeyPort } from "./keys.js";
import type { DragOptions } from "../ui/drag.js";
import type { ControlPort } from "./controls.js";

export type Point2 = [number, number];

/** What the handles are called, and whether their points lie on the curve. */
const NATURE: Nature = {
  nameOf: (index) => `P${index}`,
  kindOf: (index) => (isOnCurve(index) ? "on" : "off"),
};

export class Engine {
  /** Undo what was done to the page, in this order. */
  endings: (() => void)[] = [];
  #editor: Editor<State>;
  /** What Esc returns to. */
  #before: State;
  /** The length of a CSS pixel in the view box. */
  #px = 1;
  #frame = 0;
  #canvas;
  #context;
  #fire;
  #view;
  #handles;
  #drags;
  #controls;
  #voice;
  #theme;

  /**
   * @param fire dispatches the event for what the user does
   */
  constructor(
    canvas: HTMLCanvasElement,
    context: CanvasRenderingContext2D,
    box: Box,
    fire: (type: "input" | "change") => void,
  ) {
    this.#canvas = canvas;
    this.#context = context;
    this.#fire = fire;
    this.#before = states.firstState(box);
    this.#editor = new Editor(this.#before);
    this.#editor.subscribe((event) => event === "state" && this.#schedule());
    this.#view = createView(canvas, box);
    this.#handles = new Handles(this.#view.overlay, box);
    this.#drags = new Drags(this.#view.overlay, this.#dragOptions());
    this.#controls = createControls(this.#view.controls, this.#controlPort());
    this.#voice = new Voice(this.#view);
    this.#theme = readTheme(this.#view.probe);
    this.#listen();
    this.#render();
  }

  get state() {
    return this.#editor.state;
  }

  set(state: State) {
    this.#editor.replaceState(state);
  }

  /** A change of which points there are: fingers let go first. What is refused changes nothing. */
  command(change: (state: State) => State, origin: "page" | "user" = "page") {
    change(this.state);
    this.#drags.end();
    this.#editor.dispatch(change, { origin, initial: true });
  }

  undo() {
    this.#drags.end();
    this.#editor.undo();
  }

  redo() {
    this.#drags.end();
    this.#editor.redo();
  }

  end() {
    for (const ending of this.endings.splice(0)) ending();
    this.#frame = -1; // no more frames
  }

  #listen() {
    const { overlay } = this.#view;
    overlay.addEventListener("keydown", (event) => this.#arrow(event));
    overlay.addEventListener("input", (event) => this.#slide(event.target as HTMLInputElement));
    for (const type of ["keyup", "change", "focusout"]) overlay.addEventListener(type, () => this.#closeStep());
    onDoubleTap(overlay, (event) => this.#appendByPointer(event));
    this.endings.push(
      followTheme(this.#view.probe, (theme) => {
        this.#theme = theme;
        this.#schedule();
      }),
      followSize(this.#canvas, this.#view.overlay, (width) => this.#resized(width)),
      listenToKeys(this.#keyPort()),
      () => this.#voice.end(),
      () => cancelAnimationFrame(this.#frame),
      () => this.#view.unwrap(),
    );
  }

  #schedule() {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#nextFrame());
  }

  #nextFrame() {
    this.#frame = 0;
    if (this.#drags.apply()) this.#fire("input");
    this.#render();
  }

  /** @param width in CSS pixels */
  #resized(width: number) {
    this.#px = width > 0 ? this.state.box.width / width : 1;
    this.#render(); // at once: a canvas of a new size is empty
  }

  #render() {
    const state = this.state;
    const derived = derive(state);
    const { width, height } = this.#canvas;
    this.#context.setTransform(width / state.box.width, 0, 0, height / state.box.height, 0, 0);
    draw({ ctx: this.#context, theme: this.#theme, px: this.#px }, state, derived);
    this.#handles.update(derived.points, state.box, NATURE);
    this.#controls.update(state, { undo: this.#editor.canUndo, redo: this.#editor.canRedo });
    this.#voice.show(state, derived);
  }

  /** A part of what the user is doing; `#closeStep` completes the undo step. */
  #change(change: (state: State) => State) {
    this.#editor.dispatch(change, { origin: "user", merge: true });
  }

  /** Moves a point as far as the picture goes. */
  #move(index: number, to: Point2) {
    this.#change((state) => states.withPointAt(state, index, clamped(state.box, to)));
  }

  /** Where a point stands on the screen: at the edge if it is outside. */
  #placeOf(index: number): Point2 {
    return clamped(this.state.box, states.pointsOf(this.state)[index]);
  }

  #toViewBox({ clientX, clientY }: MouseEvent): Point2 {
    const { left, top, width, height } = this.#view.overlay.getBoundingClientRect();
    const { box } = this.state;
    return [((clientX - left) / width) * box.width, ((clientY - top) / height) * box.height];
  }

  #arrow(event: KeyboardEvent) {
    const step = arrowStep(event);
    const index = this.#handles.indexOf(event.target);
    if (!step || index < 0) return;
    event.preventDefault();
    const [x, y] = this.#placeOf(index);
    this.#moveByKey(index, [x + step[0], y + step[1]]);
  }

  /** What the browser's own keys and a screen reader do to a range input. */
  #slide(input: HTMLInputElement) {
    const index = this.#handles.indexOf(input);
    const [x, y] = this.#placeOf(index);
    const value = Number(input.value);
    this.#moveByKey(index, input.dataset.axis === "x" ? [value, y] : [x, this.state.box.height - value]);
  }

  #closeStep() {
    if (!this.#drags.active) this.#editor.commit();
  }

  #moveByKey(index: number, to: Point2) {
    this.#move(index, to);
    this.#voice.say(place(this.#placeOf(index), index));
    this.#fire("input");
    this.#fire("change");
  }

  #updateByUser(change: (state: State) => State, words: (state: State) => string) {
    this.command(change, "user");
    this.#voice.say(words(this.state));
    this.#fire("input");
    this.#fire("change");
  }

  #append(at: Point2) {
    const added = (state: State) => `${translated("Point added")}. ${shownWords(state)}`;
    this.#updateByUser((state) => states.appended(state, at), added);
  }

  #appendByPointer(event: MouseEvent) {
    this.#append(clamped(this.state.box, this.#toViewBox(event)));
    this.#render(); // so that the new point's handle is there to be focused
    this.#handles.focus(this.#handles.count - 1);
  }

  #randomize() {
    const seed = Math.floor(Math.random() * 2 ** 32);
    this.#updateByUser(
      (state) => states.randomized(state, generator(seed)),
      () => translated("Points randomized"),
    );
  }

  #toggle() {
    if (states.pointCount(this.state) > states.FEWEST_POINTS) this.#updateByUser(states.allPointsToggled, shownWords);
  }

  #stepByUser(name: "undo" | "redo") {
    const { canUndo, canRedo, isOpen } = this.#editor;
    if (!(name === "undo" ? canUndo || isOpen : canRedo)) return;
    this[name]();
    this.#voice.say(name === "undo" ? translated("Undone") : translated("Redone"));
    this.#fire("input");
    this.#fire("change");
  }

  #keyPort(): KeyPort {
    return {
      host: this.#view.host,
      pageWide: () => this.#controls.pageWide(),
      randomize: () => this.#randomize(),
      toggle: () => this.#toggle(),
      undo: () => this.#stepByUser("undo"),
      redo: () => this.#stepByUser("redo"),
      escape: () => this.#drags.cancel(),
    };
  }

  #dragOptions(): DragOptions {
    return {
      placeOf: (index) => this.#placeOf(index),
      toViewBox: (event) => this.#toViewBox(event),
      elementOf: (index) => this.#handles.boxOf(index),
      count: () => this.#handles.count,
      grabbed: (index) => this.#handles.focus(index),
      schedule: () => this.#schedule(),
      move: (index, to) => this.#move(index, to),
      started: () => {
        this.#editor.commit();
        this.#before = this.state;
      },
      cancelled: () => {
        const { state } = this;
        this.#editor.revert();
        this.set({ ...state, spline: this.#before.spline });
        this.#fire("input");
      },
      ended: (moved) => {
        this.#closeStep();
        if (!moved.length) return;
        this.#voice.say(moved.map((index) => place(this.#placeOf(index), index)).join(". "));
        this.#fire("input");
        this.#fire("change");
      },
    };
  }

  #controlPort(): ControlPort {
    return {
      randomize: () => this.#randomize(),
      toggle: () => this.#toggle(),
      append: () => this.#append(states.roomiestPlace(this.state)),
      undo: () => this.#stepByUser("undo"),
      redo: () => this.#stepByUser("redo"),
      setJoint: (mode) =>
        this.#updateByUser(
          (state) => states.withJoint(state, mode),
          () => "",
        ),
      setLayer: (name, on) =>
        this.#updateByUser(
          (state) => states.withLayers(state, { [name]: on }),
          () => "",
        ),
      setT: (t, done) => {
        this.#change((state) => states.withT(state, t));
        if (done) this.#closeStep();
        this.#fire(done ? "change" : "input");
      },
    };
  }
}
