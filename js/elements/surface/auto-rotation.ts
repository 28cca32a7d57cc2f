const REDUCED_MOTION = "(prefers-reduced-motion: reduce)";

/**
 * Whether the picture turns by itself: as the attribute asks, until a hand stops it; for those who want less motion only
 * when they ask by the button.
 */
export class AutoRotation {
  #asked = false;
  #stopped = false;

  on(attribute: boolean) {
    return attribute && !this.#stopped && (this.#asked || !matchMedia(REDUCED_MOTION).matches);
  }

  /** The button: it counts for more than what the system prefers. */
  ask(on: boolean) {
    this.#asked = on;
    this.#stopped = !on;
  }

  stop() {
    this.#stopped = true;
  }

  /** The attribute was written. */
  restart() {
    this.#stopped = false;
  }
}
