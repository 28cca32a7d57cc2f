// Fingers, mouse, wheel and keys on the picture: what they do to the view.

import { cssZoom } from "../../ui/canvas-size.js";
import { arrowDirection } from "../../ui/keys.js";
import { PressedPointers } from "../../ui/pressed-pointers.js";
import { HOME, radiiPerPixel, ZOOM_STEP } from "./camera.js";
import type { Span } from "../../ui/pressed-pointers.js";
import type { View } from "./camera.js";

type Callbacks = {
  view: () => View;
  move: (changes: Partial<View>, isDone: boolean) => void;
  /** A click, in CSS pixels of the canvas */
  pick: (x: number, y: number) => void;
};

const DEGREES_PER_PIXEL = 0.4;
const DEGREES_PER_KEY = 5;
/** A press that moved no further is a click. */
const CLICK_PX = 4;
const ZOOM_PER_WHEEL_PIXEL = 1.0015;
const LINE_PX = 16;
const PAN_PER_KEY = 0.05;

export class Gestures {
  #canvas;
  #callbacks;
  #pointers = new PressedPointers({
    move: (before, after, event) => this.#moved(before, after, event),
    end: (event, released) => this.#up(event, released),
  });
  #travelled = 0;

  constructor(canvas: HTMLCanvasElement, callbacks: Callbacks) {
    this.#canvas = canvas;
    this.#callbacks = callbacks;
  }

  /** Listens; what comes back ends it. */
  listen() {
    const listeners: [string, (event: any) => void][] = [
      ["pointerdown", (event) => this.#down(event)],
      ["wheel", (event) => this.#wheel(event)],
      ["keydown", (event) => this.#key(event)],
    ];
    for (const [type, listener] of listeners) this.#canvas.addEventListener(type, listener, { passive: false });
    return () => {
      for (const [type, listener] of listeners) this.#canvas.removeEventListener(type, listener);
    };
  }

  #down(event: PointerEvent) {
    if (event.button > 1) return;
    if (this.#pointers.count === 0) this.#travelled = 0;
    this.#pointers.add(event);
  }

  #moved(before: Span, after: Span, event: PointerEvent) {
    const { count } = this.#pointers;
    const [dx, dy] = [after.clientX - before.clientX, after.clientY - before.clientY];
    this.#travelled += count * Math.hypot(dx, dy);
    if (this.#travelled < CLICK_PX) return;
    if (count > 1) this.#pinch(before, after);
    else if (event.shiftKey || event.buttons & 4) this.#pan(dx, dy);
    else this.#orbit(dx, dy);
  }

  #up(event: PointerEvent, released: boolean) {
    if (this.#pointers.count > 0) return;
    if (this.#travelled >= CLICK_PX) return this.#callbacks.move({}, true);
    if (!released) return;
    const box = this.#canvas.getBoundingClientRect();
    const zoom = cssZoom(this.#canvas);
    this.#callbacks.pick((event.clientX - box.left) / zoom, (event.clientY - box.top) / zoom);
  }

  #orbit(dx: number, dy: number) {
    const { turn, tilt } = this.#callbacks.view();
    this.#callbacks.move({ turn: turn + dx * DEGREES_PER_PIXEL, tilt: tilt + dy * DEGREES_PER_PIXEL }, false);
  }

  #pan(dx: number, dy: number) {
    const view = this.#callbacks.view();
    const scale = radiiPerPixel(view, this.#canvas.clientWidth, this.#canvas.clientHeight) / cssZoom(this.#canvas);
    this.#callbacks.move({ panX: view.panX + dx * scale, panY: view.panY - dy * scale }, false);
  }

  /** Two fingers: their distance is the zoom, their centre the shift. */
  #pinch(before: Span, after: Span) {
    const { zoom } = this.#callbacks.view();
    this.#callbacks.move({ zoom: (zoom * Math.max(1, after.width)) / Math.max(1, before.width) }, false);
    this.#pan(after.clientX - before.clientX, after.clientY - before.clientY);
  }

  /**
   * The wheel belongs to the page, until the picture has the focus or Ctrl is held (which pinching on a pad sends, too).
   */
  #wheel(event: WheelEvent) {
    const focused = (this.#canvas.getRootNode() as ShadowRoot | Document).activeElement === this.#canvas;
    if (!focused && !event.ctrlKey) return;
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? LINE_PX : 1) * (event.ctrlKey ? 4 : 1);
    this.#callbacks.move({ zoom: this.#callbacks.view().zoom * ZOOM_PER_WHEEL_PIXEL ** -pixels }, true);
  }

  #key(event: KeyboardEvent) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const view = this.#callbacks.view();
    const arrow = arrowDirection(event);
    if (arrow && event.shiftKey) {
      const scale = PAN_PER_KEY / view.zoom;
      this.#callbacks.move({ panX: view.panX + arrow[0] * scale, panY: view.panY - arrow[1] * scale }, true);
    } else if (arrow)
      this.#callbacks.move(
        { turn: view.turn + arrow[0] * DEGREES_PER_KEY, tilt: view.tilt + arrow[1] * DEGREES_PER_KEY },
        true,
      );
    else if (event.key === "+" || event.key === "=") this.#callbacks.move({ zoom: view.zoom * ZOOM_STEP }, true);
    else if (event.key === "-" || event.key === "_") this.#callbacks.move({ zoom: view.zoom / ZOOM_STEP }, true);
    else if (event.key === "0") this.#callbacks.move(HOME, true);
    else return;
    event.preventDefault();
  }
}
