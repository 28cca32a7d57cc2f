// The pointers that are pressed on a picture: one moves it, two pinch.
import { capture } from "./capture.js";

/** One pressed pointer, or two: their centre in the window, and their distance, 0 for one. */
export type Span = { clientX: number; clientY: number; width: number };

export interface PressedListener {
  /** A pointer has moved; both spans are of the same pointers */
  move: (before: Span, after: Span, event: PointerEvent) => void;
  /** `released` is false if the browser has taken the pointer away */
  end?: (event: PointerEvent, released: boolean) => void;
}

export class PressedPointers {
  /** By pointerId */
  #pointers: Map<number, PointerEvent> = new Map();
  #listener;

  constructor(listener: PressedListener) {
    this.#listener = listener;
  }

  get count() {
    return this.#pointers.size;
  }

  /** Follows a pointer until it is released or taken away. */
  add(event: PointerEvent) {
    this.#pointers.set(event.pointerId, event);
    capture(event, {
      move: (moved) => {
        const before = this.#span();
        this.#pointers.set(moved.pointerId, moved);
        this.#listener.move(before, this.#span(), moved);
      },
      end: (last, released) => {
        this.#pointers.delete(event.pointerId);
        this.#listener.end?.(last, released);
      },
    });
  }

  #span(): Span {
    const [a, b = a] = this.#pointers.values();
    return {
      clientX: (a.clientX + b.clientX) / 2,
      clientY: (a.clientY + b.clientY) / 2,
      width: Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY),
    };
  }
}
