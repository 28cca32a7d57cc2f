// The graphics card is lent: an element that is far from what is seen gives its context back and asks again later.

/** One for each canvas, since a canvas has one context for ever. */
const leases: WeakMap<HTMLCanvasElement, ContextSlot> = new WeakMap();

export class ContextSlot {
  #loser;
  #state: "held" | "ending" | "ended" = "held";
  #wanted = true;

  constructor(canvas: HTMLCanvasElement) {
    this.#loser = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context") ?? null; // a lost context hands out nothing
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault(); // it may come back
      this.#notified();
    });
  }

  /**
   * @param canvas with its context, or with none
   */
  static of(canvas: HTMLCanvasElement): ContextSlot {
    const known = leases.get(canvas) ?? new ContextSlot(canvas);
    leases.set(canvas, known);
    return known;
  }

  /** Gives the context back; the canvas tells of the loss later. */
  end() {
    this.#wanted = false;
    if (this.#state !== "held" || !this.#loser) return;
    this.#state = "ending";
    this.#loser.loseContext();
  }

  /** Asks for it again; the canvas tells when it is there. */
  renew() {
    this.#wanted = true;
    if (this.#state !== "ended") return; // the loss has not been notified yet: the answer waits for it
    this.#state = "held";
    this.#loser?.restoreContext();
  }

  /** Whether the context is away because it was given back. */
  get ended() {
    return this.#state === "ended";
  }

  #notified() {
    if (this.#state !== "ending") return;
    this.#state = "ended";
    setTimeout(() => this.#wanted && this.renew()); // a context cannot be restored while its loss is notified
  }
}
