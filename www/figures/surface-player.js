// <surface-player for="id">: lets the curve of constant u run over the surface.

import { LinkedFigure } from "./lib/linked-figure.js";

const SECONDS = 6;

class SurfacePlayer extends LinkedFigure {
  #button = document.createElement("button");
  #frame = 0;
  #before = 0;

  build() {
    this.#button.type = "button";
    this.#button.onclick = () => (this.#frame ? this.#stop() : this.#start());
    this.#showState();
    this.append(this.#button);
  }

  connectedCallback() {
    super.connectedCallback();
    this.target?.addEventListener("input", this.#onInput);
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.target?.removeEventListener("input", this.#onInput);
    this.#stop();
  }

  #showState() {
    this.#button.textContent = this.#frame ? "Stop" : "Play";
  }

  #start() {
    if (this.target.u >= 1) this.target.u = 0;
    this.#before = performance.now();
    this.#frame = requestAnimationFrame((now) => this.#step(now));
    this.#showState();
  }

  #stop() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#showState();
  }

  /** Stops when the reader moves the slider of u. @param {Event} event */
  #onInput = (event) => {
    if (event.isTrusted || !this.#frame) return;
    this.#stop();
  };

  /** @param {number} now */
  #step(now) {
    const target = this.target;
    target.u = Math.min(target.u + Math.max(now - this.#before, 0) / 1000 / SECONDS, 1);
    this.#before = now;
    this.#frame = target.u < 1 ? requestAnimationFrame((then) => this.#step(then)) : 0;
    this.#showState();
  }
}

customElements.define("surface-player", SurfacePlayer);
