// t that runs by itself, to and fro, once the user has asked for it.

/** From one end to the other. */
const WAY_MS = 4000;
/** The step of t, and its duration, under `prefers-reduced-motion`. */
const STEP = 0.1;
const STEP_MS = 800;

export class Player {
  #move;
  #frame = 0;
  #timer = 0;
  #sign = 1;
  #last = 0;

  /** @param move by how much t changes; whether it has come to an end */
  constructor(move: (by: number) => boolean) {
    this.#move = move;
  }

  get playing() {
    return this.#frame !== 0 || this.#timer !== 0;
  }

  start() {
    if (this.playing) return;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches)
      this.#timer = window.setInterval(() => this.#by(STEP), STEP_MS);
    else this.#frame = requestAnimationFrame((now) => this.#first(now));
  }

  stop() {
    cancelAnimationFrame(this.#frame);
    clearInterval(this.#timer);
    this.#frame = this.#timer = 0;
  }

  #first(now: number) {
    this.#last = now;
    this.#frame = requestAnimationFrame((next) => this.#next(next));
  }

  #next(now: number) {
    this.#frame = requestAnimationFrame((next) => this.#next(next));
    this.#by((now - this.#last) / WAY_MS);
    this.#last = now;
  }

  #by(by: number) {
    if (this.#move(this.#sign * by)) this.#sign = -this.#sign;
  }
}
