// The picture: a canvas, a handle over each point, and the gestures that move them; drawn at most once a frame.
import { Drags } from "../../ui/drag.js";
import { Handles } from "../../ui/handles.js";
import { clamped } from "../../editor/plane.js";
import { onDoubleTap } from "../../ui/taps.js";
import { followTheme, readTheme } from "../../ui/theme.js";
import { followSize } from "../../ui/canvas-size.js";
import { nameOf } from "../../editor/figure.js";
import { listenToGestures } from "../../ui/viewport.js";
import { drawFigure, ROLES } from "../../layers/index.js";
import { isHome, scaleOf, toPlane } from "../../editor/state.js";
import type { State } from "../../editor/state.js";
import type { Point2 } from "../../editor/state.js";
import type { Figure } from "../../editor/figure.js";
import type { Layer } from "../../layers/index.js";

/** A tap that wanders farther is none. */
const TAP_PX = 8;

export interface StagePort {
  now: () => { state: State; figure: Figure };
  /** What curves with weights need, once it is loaded */
  rational: () => import("./loading.js").Rational | null;
  /** From the back to the front */
  layers: () => readonly Layer[];
  /** Whether nothing can be moved */
  fixed: () => boolean;
  begun: () => void;
  move: (index: number, to: Point2, drag: { from: Point2; event?: PointerEvent }) => void;
  restored: () => void;
  /** The points that have been moved, and those whose weights have changed */
  ended: (moved: number[], weighed: number[]) => void;
  grabbed: (index: number) => void;
  /** What a screen reader does to a slider */
  slide: (index: number, to: Point2) => void;
  slid: () => void;
  /** The handle of the weight of a point has been dragged */
  weigh: (index: number, to: Point2) => void;
  /** Its slider has been moved */
  slideWeight: (index: number, weight: number) => void;
  doubleTap: (at: Point2) => unknown;
  /** On an empty place */
  tap: (at: Point2) => unknown;
  /** The pointer has moved */
  point: (at: (() => Point2) | null) => unknown;
  look: (factor: number, from: Point2, to: Point2) => void;
  /** With the messages of the layers */
  drawn: (messages: { name: string; words: string }[]) => void;
}

export class Stage {
  /** The length of a CSS pixel in the box's units. */
  px = 1;
  #canvas;
  #overlay;
  #probe;
  #port;
  #handles;
  /** Of the weights: that on the leg after point k is the one of point k + 1. */
  #weights: import("./weight-handles.js").WeightHandles | null = null;
  #drags;
  #context;
  #theme;
  #frame = 0;
  /** What the canvas shows. */
  #drawn: State | null = null;
  #drawnFixed = false;
  #endings: (() => void)[] = [];

  constructor(
    { canvas, overlay, probe }: { canvas: HTMLCanvasElement; overlay: HTMLElement; probe: HTMLElement },
    port: StagePort,
  ) {
    this.#canvas = canvas;
    this.#overlay = overlay;
    this.#probe = probe;
    this.#port = port;
    this.#context = canvas.getContext("2d") as CanvasRenderingContext2D;
    this.#theme = readTheme(probe, ROLES);
    this.#handles = new Handles(overlay, port.now().state.box);
    this.#drags = new Drags(overlay, this.#dragPort());
    this.#listen();
  }

  get handles() {
    return this.#handles;
  }

  get weights() {
    return this.#weights;
  }

  get dragging() {
    return this.#drags.active;
  }

  get theme() {
    return this.#theme;
  }

  /** Begins to follow the size and the colours. */
  start() {
    if (this.#endings.length) return;
    this.#endings = [
      // Draws immediately, because a printer does not wait for a frame.
      followTheme(
        this.#probe,
        (theme) => {
          this.#theme = theme;
          this.draw();
        },
        ROLES,
      ),
      followSize(this.#canvas, this.#overlay, (width) => this.#resized(width)),
      () => cancelAnimationFrame(this.#frame),
    ];
    this.recolour();
  }

  /** Leaves nothing running. */
  end() {
    this.#drags.cancel();
    for (const ending of this.#endings.splice(0)) ending();
    this.#frame = 0;
  }

  /** The colours may be others. */
  recolour() {
    this.#theme = readTheme(this.#probe, ROLES);
    this.schedule();
  }

  schedule() {
    if (this.#frame === 0 && this.#endings.length) this.#frame = requestAnimationFrame(() => this.#nextFrame());
  }

  /** Draws what is not drawn yet. */
  refresh() {
    if (this.#port.now().state !== this.#drawn || this.#port.fixed() !== this.#drawnFixed) this.schedule();
  }

  /** Lets go of all points, which return. @returns whether there was one */
  cancel(): boolean {
    return this.#drags.cancel();
  }

  /** Lets go of all points, which stay where they are. */
  release() {
    this.#drags.end();
  }

  draw() {
    const { state, figure } = this.#port.now();
    this.#drawn = state;
    this.#drawnFixed = this.#port.fixed();
    const { width, height } = this.#canvas;
    this.#context.setTransform(width / state.box.width, 0, 0, height / state.box.height, 0, 0);
    const messages = drawFigure(
      { ctx: this.#context, theme: this.#theme, px: this.px },
      state,
      figure,
      this.#port.layers(),
    );
    this.place();
    this.#port.drawn(messages);
  }

  /** Puts the handles where the points are. */
  place() {
    const { state, figure } = this.#port.now();
    const { names, kinds, points } = figure;
    this.#handles.update(points, state.view, {
      nameOf: (i) => (state.labels === "none" ? nameOf("P0", i) : names[i]),
      kindOf: (i) => kinds[i],
    });
    const rational = this.#port.rational();
    if (rational) {
      this.#weights ??= new rational.WeightHandles(this.#overlay);
      this.#weights?.update(figure, state);
    }
    for (const input of this.#overlay.getElementsByTagName("input")) input.disabled = this.#port.fixed();
  }

  #nextFrame() {
    this.#frame = 0;
    this.#drags.apply();
    this.draw();
  }

  /** @param width in CSS pixels */
  #resized(width: number) {
    this.px = width > 0 ? this.#port.now().state.box.width / width : 1;
    this.draw(); // at once: a canvas of a new size is empty
  }

  /**
   * @returns in the plane
   */
  #placeAt({ clientX, clientY }: { clientX: number; clientY: number }): Point2 {
    const { left, top, width, height } = this.#overlay.getBoundingClientRect();
    const { state } = this.#port.now();
    return toPlane(state, [
      ((clientX - left) / width) * state.box.width,
      ((clientY - top) / height) * state.box.height,
    ]);
  }

  #listen() {
    const [overlay, port] = [this.#overlay, this.#port];
    onDoubleTap(overlay, (event) => port.doubleTap(this.#placeAt(event)));
    overlay.addEventListener("input", (event) => this.#slide(event.target as HTMLInputElement));
    overlay.addEventListener("change", port.slid);
    let [x, y] = [0, 0];
    overlay.addEventListener("pointerdown", (event) => ([x, y] = [event.clientX, event.clientY]));
    overlay.addEventListener("click", (event) => {
      const still = Math.hypot(event.clientX - x, event.clientY - y) <= TAP_PX;
      if (event.target === overlay && still) port.tap(this.#placeAt(event));
    });
    overlay.addEventListener("pointermove", (event) => port.point(() => this.#placeAt(event)));
    overlay.addEventListener("pointerleave", () => port.point(null));
    listenToGestures(overlay, {
      place: (event) => this.#placeAt(event),
      enlarged: () => !isHome(port.now().state),
      look: port.look,
    });
  }

  #slide(input: HTMLInputElement) {
    const weight = this.#weights?.indexOf(input) ?? -1;
    if (this.#weights && weight >= 0) return this.#port.slideWeight(weight + 1, this.#weights.weightOf(weight));
    const index = this.#handles.indexOf(input);
    const { state } = this.#port.now();
    const [x, y] = state.points[index];
    const value = Number(input.value);
    this.#port.slide(index, input.dataset.axis === "x" ? [value, y] : [x, state.box.height - value]); // more is higher up
  }

  /** Drags know the handles of the points, and after these those of the weights. */
  #dragPort(): import("../../ui/drag.js").DragPort {
    const port = this.#port;
    const weightOf = (index: number) => index - this.#handles.count;
    const weights = (index: number) => (weightOf(index) >= 0 ? this.#weights : null);
    return {
      placeOf: (index) =>
        clamped(port.now().state.view, weights(index)?.placeOf(weightOf(index)) ?? port.now().figure.points[index]),
      toBox: (event) => this.#placeAt(event),
      boxOf: (index) => weights(index)?.boxOf(weightOf(index)) ?? this.#handles.boxOf(index),
      count: () => (port.fixed() ? 0 : this.#handles.count + (this.#weights?.count ?? 0)),
      grabbed: (index) => {
        if (weights(index)) return weights(index)?.focus(weightOf(index));
        this.#handles.focus(index);
        port.grabbed(index);
      },
      schedule: () => this.schedule(),
      move: (index, to, drag) => {
        const { state, figure } = port.now();
        const place = clamped(state.view, to);
        const weight = weightOf(index);
        if (weight < 0) {
          if (index < figure.points.length) port.move(index, place, drag);
        } else if (weight < (this.#weights?.count ?? 0)) port.weigh(weight + 1, place);
      },
      begun: port.begun,
      restored: port.restored,
      ended: (moved) =>
        port.ended(
          moved.filter((index) => weightOf(index) < 0),
          moved.filter((index) => weightOf(index) >= 0).map((index) => weightOf(index) + 1),
        ),
    };
  }

  /** The length of a CSS pixel in the plane. */
  get reach() {
    return this.px * scaleOf(this.#port.now().state);
  }
}
