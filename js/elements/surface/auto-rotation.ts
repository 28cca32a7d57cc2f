const REDUCED_MOTION = "(prefers-reduced-motion: reduce)";

/**
 * Whether the surface rotates by itself: as the attribute says, until the user drags it; under prefers-reduced-motion only
 * after a press of the button.
 */
export class AutoRotation {
  #asked = false;
  #stopped = false;

  isOn(attribute: boolean) {
    return attribute && !this.#stopped && (this.#asked || !matchMedia(REDUCED_MOTION).matches);
  }

  /** The button, which overrides what the system prefers. */
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
