// WebGL contexts are few: an element far from what is visible gives its context back, and restores it later.
import { cached } from "../../editor/memo.js";

export class ContextSlot {
  #extension;
  #state: "held" | "ending" | "ended" = "held";
  #wanted = true;

  /** @param canvas with its context, or with none */
  constructor(canvas: HTMLCanvasElement) {
    this.#extension = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context") ?? null; // a lost context has no extensions
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault(); // it may come back
      this.#notified();
    });
  }

  /** Gives the context back; the loss is an event of the canvas. */
  end() {
    this.#wanted = false;
    if (this.#state !== "held" || !this.#extension) return;
    this.#state = "ending";
    this.#extension.loseContext();
  }

  /** Asks for it again; an event of the canvas follows. */
  renew() {
    this.#wanted = true;
    if (this.#state !== "ended") return; // the loss has not been notified yet: the answer waits for it
    this.#state = "held";
    this.#extension?.restoreContext();
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

/** One for each canvas, since a canvas has one context as long as it lives. */
export const contextSlotOf = cached((canvas: HTMLCanvasElement) => new ContextSlot(canvas));
