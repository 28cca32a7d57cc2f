// What the user does in the applet: pointers, keys and controls become changes of the editor's state; controls and picture are rendered
// together in the next frame.
import { append, randomize, redo, toggle, undo } from "../editor/actions.js";
import { appended, withPointAt } from "../editor/commands.js";
import { Editor } from "../editor/editor.js";
import { bezierFigure } from "../editor/figure.js";
import { clamped } from "../editor/plane.js";
import { firstState } from "../editor/state.js";
import * as base from "../layers/base.js";
import * as construction from "../layers/construction.js";
import { drawFigure } from "../layers/draw-figure.js";
import { ROLES } from "../layers/theme.js";
import { Announcer, setText } from "../ui/announcer.js";
import { followSize } from "../ui/canvas-size.js";
import { Drags } from "../ui/drag.js";
import { Handles } from "../ui/handles.js";
import { listenToPageKeys } from "../ui/key-targets.js";
import { arrowStep, historyStep, isForText, isPlain, keyOf } from "../ui/keys.js";
import { onDoubleTap } from "../ui/taps.js";
import { followTheme, readTheme } from "../ui/theme.js";
import { MIN_POINTS, withJoint, withLayers, withT } from "./changes.js";
import { createControls } from "./controls.js";
import { createView } from "./view.js";
import { description, jointLabel, place } from "./words.js";
import type { Action } from "../editor/actions.js";
import type { Figure } from "../editor/figure.js";
import type { Box } from "../editor/plane.js";
import type { Point2, State } from "../editor/state.js";
import type { KeyTarget } from "../ui/key-targets.js";

/** From the back to the front. */
const LAYERS = [
  construction.hull,
  construction.polygon,
  base.curve,
  construction.halves,
  base.handles,
  construction.construction,
  base.points,
  base.atT,
];

export class Engine {
  /** Undo what was done to the page, in this order. */
  endings: (() => void)[] = [];
  #editor: Editor<State>;
  /** The length of a CSS pixel in the view box. */
  #px = 1;
  #frame = 0;
  /** What is drawn. */
  #drawn: State | null = null;
  /** What has been said of P3; it is not said again. */
  #announced = "";
  #canvas;
  #context;
  #view;
  #handles;
  #drags;
  #controls;
  #announcer;
  #theme;

  /** @param fire dispatches the event for what the user does */
  constructor(
    canvas: HTMLCanvasElement,
    context: CanvasRenderingContext2D,
    box: Box,
    fire: (type: "input" | "change") => void,
  ) {
    this.#canvas = canvas;
    this.#context = context;
    this.#editor = new Editor(firstState(box));
    this.#editor.subscribe((event) => (event === "state" ? this.#schedule() : fire(event)));
    this.#view = createView(canvas, box);
    this.#handles = new Handles(this.#view.overlay, box);
    this.#drags = this.#createDrags();
    this.#controls = createControls(this.#view.controls, {
      run: (action) => this.#run(action),
      setJoint: (mode) => this.#editor.dispatch((state) => withJoint(state, mode), { by: "user" }),
      setLayer: (name, on) => this.#editor.dispatch((state) => withLayers(state, { [name]: on }), { by: "user" }),
      setT: (t) => this.#changePart((state) => withT(state, t)),
      commit: () => this.#editor.commit(),
    });
    this.#announcer = new Announcer(this.#view.live, () => this.#describe());
    this.#theme = readTheme(this.#view.probe, ROLES);
    this.#listen();
    this.#render();
    this.#describe(); // what is there from the start is described, not announced
  }

  get state() {
    return this.#editor.state;
  }

  get figure(): Figure {
    return bezierFigure(this.state);
  }

  set(state: State) {
    this.#editor.replaceState(state);
  }

  /** A change by the page of which points there are: fingers let go first. What is refused changes nothing. */
  command(change: (state: State) => State) {
    change(this.state);
    this.#drags.end();
    this.#editor.dispatch(change, { by: "page", initial: true });
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
    const { overlay, probe, host } = this.#view;
    overlay.addEventListener("keydown", (event) => this.#arrow(event));
    overlay.addEventListener("input", (event) => this.#slide(event.target as HTMLInputElement));
    for (const type of ["keyup", "change", "focusout"])
      overlay.addEventListener(type, () => void (this.#drags.active || this.#editor.commit()));
    onDoubleTap(overlay, (event) => this.#appendByPointer(event));
    const followed = followTheme(
      probe,
      (theme) => {
        this.#theme = theme;
        this.#schedule();
      },
      ROLES,
    );
    this.endings.push(
      followed,
      followSize(this.#canvas, overlay, (width) => this.#resized(width)),
      listenToPageKeys(host, (event, target) => this.#press(event, target)),
      () => this.#announcer.end(),
      () => cancelAnimationFrame(this.#frame),
      () => this.#view.unwrap(),
    );
  }

  #createDrags() {
    return new Drags(this.#view.overlay, {
      placeOf: (index) => this.#placeOf(index),
      toViewBox: (event) => this.#toViewBox(event),
      elementOf: (index) => this.#handles.elementOf(index),
      count: () => this.#handles.count,
      grabbed: (index) => this.#handles.focus(index),
      schedule: () => this.#schedule(),
      move: (index, to) => this.#move(index, to),
      started: () => this.#editor.commit(),
      cancelled: () => this.#editor.revert(),
      ended: (moved) => {
        this.#editor.commit();
        if (moved.length) this.#announcer.say(moved.map((index) => place(this.figure, index)).join(". "));
      },
    });
  }

  // Pictures

  #schedule() {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#nextFrame());
  }

  #nextFrame() {
    this.#drags.apply();
    this.#frame = 0;
    this.#render();
  }

  /** @param width in CSS pixels */
  #resized(width: number) {
    this.#px = width > 0 ? this.state.box.width / width : 1;
    this.#render(); // at once: a canvas of a new size is empty
  }

  #render() {
    const { state, figure } = this;
    const { width, height } = this.#canvas;
    this.#context.setTransform(width / state.box.width, 0, 0, height / state.box.height, 0, 0);
    drawFigure({ ctx: this.#context, theme: this.#theme, px: this.#px }, state, figure, LAYERS);
    const { names, kinds, points } = figure;
    this.#handles.update(points, state.box, { nameOf: (i) => names[i], kindOf: (i) => kinds[i] });
    this.#controls.update(state, this.#editor);
    const { verdict, text } = jointLabel(figure);
    setText(this.#view.verdict, verdict);
    this.#view.verdict.dataset.verdict = verdict;
    setText(this.#view.label, text);
    if (this.#drawn && this.#drawn !== state) this.#announcer.say();
    this.#drawn = state;
  }

  /** @returns what is to be announced besides what the user has done */
  #describe(): string {
    const { figure } = this;
    setText(this.#view.description, description(figure, this.state.t));
    const { verdict, text } = jointLabel(figure);
    const news = verdict === this.#announced || this.#announced === "" ? "" : text;
    this.#announced = verdict;
    return news;
  }

  // Changes

  /** A part of what the user is doing. */
  #changePart(change: (state: State) => State) {
    this.#editor.dispatch(change, { by: "user", merge: true });
  }

  /** Moves a point as far as the picture goes. */
  #move(index: number, to: Point2) {
    this.#changePart((state) => withPointAt(state, index, clamped(state.box, to)));
  }

  #moveByKey(index: number, to: Point2) {
    this.#move(index, to);
    this.#announcer.say(place(this.figure, index));
  }

  #run(action: Action) {
    this.#drags.end();
    this.#editor.commit();
    const isOff = action === toggle && this.state.points.length === MIN_POINTS;
    if (isOff || action.enabled?.(this.#editor) === false) return;
    action.run(this.#editor);
    this.#announcer.say(action.done(this.state));
  }

  /** Where a point stands on the screen: at the edge if it is outside. */
  #placeOf(index: number): Point2 {
    return clamped(this.state.box, this.state.points[index]);
  }

  #toViewBox({ clientX, clientY }: MouseEvent): Point2 {
    const { left, top, width, height } = this.#view.overlay.getBoundingClientRect();
    const { box } = this.state;
    return [((clientX - left) / width) * box.width, ((clientY - top) / height) * box.height];
  }

  #appendByPointer(event: MouseEvent) {
    const at = clamped(this.state.box, this.#toViewBox(event));
    this.#drags.end();
    this.#editor.dispatch((state) => appended(state, at), { by: "user" });
    this.#announcer.say(append.done(this.state));
    this.#render(); // so that the new point's handle is there to be focused
    this.#handles.focus(this.#handles.count - 1);
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

  /** @returns whether the key was used */
  #press(event: KeyboardEvent, target: () => KeyTarget): boolean {
    if (event.key === "Escape") return this.#drags.cancel();
    const step = historyStep(event);
    const letters = isPlain(event) ? [randomize, toggle] : [];
    const action = step ? { undo, redo }[step] : letters.find(({ key }) => key === keyOf(event));
    if (!action || isForText(event)) return false;
    const where = target();
    const counts = where === "focus" || (where === "page" && !step && this.#controls.pageWide());
    if (counts) this.#run(action);
    return counts;
  }
}
