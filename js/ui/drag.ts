// Pointers that move points: any number at once. A move only notes the pointer's place; the next frame uses it.

import { dragHandle } from "./capture.js";
import type { Point2 } from "./capture.js";

/** What dragging needs to know and may do. */
export interface DragOptions {
  /** Where a handle stands, in the view box */
  placeOf: (index: number) => Point2;
  /** A pointer's place in the view box */
  toViewBox: (event: PointerEvent) => Point2;
  /** A handle's element */
  elementOf: (index: number) => HTMLElement;
  /** How many handles there are */
  count: () => number;
  grabbed: (index: number) => void;
  /** Asks for a frame, which calls `apply` */
  schedule: () => void;
  /** Where it came from, and the move, which knows the keys that are held */
  move: (index: number, to: Point2, drag: { from: Point2; event?: PointerEvent }) => void;
  /** The first pointer has come down: its drag may be cancelled */
  started: () => void;
  /** Esc, or the only pointer was taken away: back to what was at the beginning */
  cancelled: () => void;
  /** The last pointer has gone up; the points that have been moved */
  ended: (moved: number[]) => void;
}

export interface Drag {
  index: number;
  from: Point2;
  to: Point2 | null;
  /** The last move */
  event?: PointerEvent;
  /** Stops following the pointer */
  stop: () => void;
}

/** A second press within this distance of the last one is on the same stack. */
const SAME_PLACE_PX = 4;

export class Drags {
  #drags: Set<Drag> = new Set();
  /** Points that have moved since the first pointer came down. */
  #moved: Set<number> = new Set();
  /** The last press that has not moved anything. */
  #lastPress: { x: number; y: number; index: number } | null = null;
  #options;

  constructor(overlay: HTMLElement, options: DragOptions) {
    this.#options = options;
    overlay.addEventListener("pointerdown", (event) => this.#down(event));
    overlay.addEventListener("mousedown", (event) => event.preventDefault()); // focus stays where `grabbed` puts it
  }

  get active() {
    return this.#drags.size > 0;
  }

  /**
   * Moves the points to where their pointers are by now.
   *
   * @returns whether any has moved
   */
  apply(): boolean {
    const waiting = [...this.#drags].filter(({ to }) => to);
    for (const drag of waiting) {
      this.#moved.add(drag.index);
      this.#options.move(drag.index, drag.to ?? drag.from, drag);
      drag.to = null;
    }
    return waiting.length > 0;
  }

  /** Lets all points go where they are. */
  end() {
    if (!this.active) return;
    this.release();
    this.#options.ended([...this.#moved]);
  }

  /**
   * Lets all points go; they return to where they were.
   *
   * @returns whether there was one
   */
  cancel(): boolean {
    if (!this.active) return false;
    this.release();
    this.#options.cancelled();
    return true;
  }

  /** Lets all points go where they are, without a report. */
  release() {
    for (const { stop } of this.#drags) stop();
    this.#drags.clear();
  }

  #down(event: PointerEvent) {
    if (event.button !== 0) return;
    const index = this.#choose(this.#stackUnder(event), event);
    if (index === undefined) return;
    if (!this.active) {
      this.#moved.clear();
      this.#options.started();
    }
    const from = this.#options.placeOf(index);
    const stop = dragHandle(
      event,
      {
        from,
        placeOf: this.#options.toViewBox,
        move: (to, now) => this.#move(drag, to, now),
        end: (_, released) => this.#end(drag, released),
      },
      this.#options.elementOf(index),
    );
    const drag: Drag = { index, from, to: null, stop };
    this.#drags.add(drag);
    this.#options.grabbed(index);
  }

  /** The free handles whose boxes contain the pointer, the nearest first. */
  #stackUnder({ clientX, clientY }: PointerEvent): number[] {
    const found: { index: number; distance: number }[] = [];
    for (let index = 0; index < this.#options.count(); index++) {
      if ([...this.#drags].some((drag) => drag.index === index)) continue;
      const { left, top, width, height } = this.#options.elementOf(index).getBoundingClientRect();
      const [dx, dy] = [clientX - left - width / 2, clientY - top - height / 2];
      const inside = Math.abs(dx) <= width / 2 && Math.abs(dy) <= height / 2;
      if (inside) found.push({ index, distance: Math.hypot(dx, dy) });
    }
    return found.sort((a, b) => a.distance - b.distance).map(({ index }) => index);
  }

  /** The nearest; but a second press at the same place takes the next of the stack. */
  #choose(stack: number[], event: PointerEvent): number | undefined {
    const last = isNear(this.#lastPress, event) ? stack.indexOf(this.#lastPress?.index ?? -1) : -1;
    const index = stack[(last + 1) % stack.length];
    this.#lastPress = index === undefined ? null : { x: event.clientX, y: event.clientY, index };
    return index;
  }

  #move(drag: Drag, to: Point2, event: PointerEvent) {
    drag.to = to;
    drag.event = event;
    if (!isNear(this.#lastPress, event)) this.#lastPress = null;
    this.#options.schedule();
  }

  #end(drag: Drag, released: boolean) {
    if (released) this.apply();
    else if (this.#drags.size === 1) return void this.cancel();
    this.#drags.delete(drag);
    if (!this.active) return this.#options.ended([...this.#moved]);
    if (released) return;
    this.#options.move(drag.index, drag.from, { from: drag.from }); // others are still moving
    this.#options.schedule();
  }
}

function isNear(press: { x: number; y: number } | null, { clientX, clientY }: PointerEvent): boolean {
  return press !== null && Math.hypot(clientX - press.x, clientY - press.y) <= SAME_PLACE_PX;
}
