// The middle of the applet: holds the state, lets the user change it, shows it at most once a frame.
import { History } from "../editor/history.js";
import { createControls } from "./controls.js";
import { derive } from "./derive.js";
import { Drags } from "./drag.js";
import { draw } from "./draw.js";
import { Handles } from "./handles.js";
import { arrowStep } from "../ui/keys.js";
import { listenToKeys } from "./keys.js";
import { generator, randomized, roomiestPlace } from "./random.js";
import * as states from "./state.js";
import { onDoubleTap } from "./taps.js";
import { followTheme, readTheme } from "./theme.js";
import { createView, followSize } from "./view.js";
import { Voice } from "./voice.js";
import { place, shownWords } from "./words.js";
import type { State } from "./state.js";
import type { Box } from "./state.js";

export type Point2 = [number, number];

export class Engine {
  /** Undo what was done to the page, in this order. */
  endings: (() => void)[] = [];
  #state: State;
  /** What Esc returns to. */
  #before: State;
  #history = new History<State>();
  /** Whether the user has changed something; what the page sets before makes no undo step. */
  #isTouched = false;
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
   * @param fire tells the page what the user does
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
    this.#state = this.#before = states.firstState(box);
    this.#view = createView(canvas, box);
    this.#handles = new Handles(this.#view.overlay, box);
    this.#drags = new Drags(this.#view.overlay, this.#dragPort());
    this.#controls = createControls(this.#view.controls, this.#controlPort());
    this.#voice = new Voice(this.#view);
    this.#theme = readTheme(this.#view.probe);
    this.#listen();
    this.#render();
  }

  get state() {
    return this.#state;
  }

  set(state: State) {
    this.#state = state;
    this.#schedule();
  }

  /** A change of which points there are: fingers let go first. What is refused changes nothing. */
  command(change: (state: State) => State) {
    const next = change(this.#state);
    const dragging = this.#drags.active;
    this.#drags.end();
    this.#history.close(this.#state);
    if (this.#isTouched) this.#history.touch(this.#state);
    this.set(dragging ? change(this.#state) : next);
    this.#history.close(this.#state);
  }

  undo() {
    this.#drags.end();
    this.set(this.#history.undo(this.#state));
  }

  redo() {
    this.#drags.end();
    this.set(this.#history.redo(this.#state));
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
      followSize(this.#canvas, this.#view, (width) => this.#resized(width)),
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
    this.#px = width > 0 ? this.#state.box.width / width : 1;
    this.#render(); // at once: a canvas of a new size is empty
  }

  #render() {
    const state = this.#state;
    const derived = derive(state);
    const { width, height } = this.#canvas;
    this.#context.setTransform(width / state.box.width, 0, 0, height / state.box.height, 0, 0);
    draw({ ctx: this.#context, theme: this.#theme, px: this.#px }, state, derived);
    this.#handles.update(derived.points);
    this.#controls.update(state, { undo: this.#history.canUndo, redo: this.#history.canRedo });
    this.#voice.show(state, derived);
  }

  /** Moves a point as far as the picture goes. */
  #move(index: number, to: Point2) {
    this.set(states.withPointAt(this.#state, index, states.clamped(this.#state.box, to)));
  }

  /** Where a point stands on the screen: at the edge if it is outside. */
  #placeOf(index: number): Point2 {
    return states.clamped(this.#state.box, states.pointsOf(this.#state)[index]);
  }

  #toBox({ clientX, clientY }: MouseEvent): Point2 {
    const { left, top, width, height } = this.#view.overlay.getBoundingClientRect();
    const { box } = this.#state;
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
    this.#moveByKey(index, input.dataset.axis === "x" ? [value, y] : [x, this.#state.box.height - value]);
  }

  /** The user is about to change something; `#closeStep` completes the undo step. */
  #openStep() {
    this.#isTouched = true;
    this.#history.touch(this.#state);
  }

  #closeStep() {
    if (!this.#drags.active && this.#history.close(this.#state)) this.#schedule();
  }

  #moveByKey(index: number, to: Point2) {
    this.#openStep();
    this.#move(index, to);
    this.#voice.say(place(this.#placeOf(index), index));
    this.#fire("input");
    this.#fire("change");
  }

  #updateByUser(change: (state: State) => State, words: (state: State) => string) {
    this.#isTouched = true;
    this.command(change);
    this.#voice.say(words(this.#state));
    this.#fire("input");
    this.#fire("change");
  }

  #append(at: Point2) {
    const added = (state: State) => `Point added. ${shownWords(state)}`;
    this.#updateByUser((state) => states.appended(state, at), added);
  }

  #appendByPointer(event: MouseEvent) {
    this.#append(states.clamped(this.#state.box, this.#toBox(event)));
    this.#render(); // so that the new point's handle is there to be focused
    this.#handles.focus(this.#handles.count - 1);
  }

  #randomize() {
    const seed = Math.floor(Math.random() * 2 ** 32);
    this.#updateByUser(
      (state) => randomized(state, generator(seed)),
      () => "Points randomized",
    );
  }

  #toggle() {
    if (states.pointCount(this.#state) > states.FEWEST_POINTS) this.#updateByUser(states.allPointsToggled, shownWords);
  }

  #stepByUser(name: "undo" | "redo") {
    const { canUndo, canRedo } = this.#history;
    if (!(name === "undo" ? canUndo || this.#history.open : canRedo)) return;
    this[name]();
    this.#voice.say(name === "undo" ? "Undone" : "Redone");
    this.#fire("input");
    this.#fire("change");
  }

  #keyPort(): import("./keys.js").KeyPort {
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

  #dragPort(): import("./drag.js").DragPort {
    return {
      placeOf: (index) => this.#placeOf(index),
      toBox: (event) => this.#toBox(event),
      boxOf: (index) => this.#handles.boxOf(index),
      count: () => this.#handles.count,
      grabbed: (index) => this.#handles.focus(index),
      schedule: () => this.#schedule(),
      move: (index, to) => {
        this.#openStep();
        this.#move(index, to);
      },
      begun: () => {
        this.#history.close(this.#state);
        this.#before = this.#state;
      },
      restored: () => {
        this.#history.abandon();
        this.set({ ...this.#state, spline: this.#before.spline });
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

  #controlPort(): import("./controls.js").ControlPort {
    return {
      randomize: () => this.#randomize(),
      toggle: () => this.#toggle(),
      append: () => this.#append(roomiestPlace(this.#state)),
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
        this.#openStep();
        this.set(states.withT(this.#state, t));
        if (done) this.#closeStep();
        this.#fire(done ? "change" : "input");
      },
    };
  }
}
