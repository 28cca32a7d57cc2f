// <surface-player for="id">: lets the curve of constant u run over the surface.

const SECONDS = 6;

class SurfacePlayer extends HTMLElement {
  #button = document.createElement("button");
  #frame = 0;
  #before = 0;

  connectedCallback() {
    this.#button.type = "button";
    this.#button.onclick = () => (this.#frame ? this.#stop() : this.#start());
    this.#say();
    if (!this.contains(this.#button)) this.append(this.#button);
    this.#target?.addEventListener("input", this.#byHand);
  }

  disconnectedCallback() {
    this.#target?.removeEventListener("input", this.#byHand);
    this.#stop();
  }

  /** @returns {any} */
  get #target() {
    return document.getElementById(this.getAttribute("for") ?? "");
  }

  #say() {
    this.#button.textContent = this.#frame ? "Stop" : "Let it grow";
  }

  #start() {
    if (this.#target.u >= 1) this.#target.u = 0;
    this.#before = performance.now();
    this.#frame = requestAnimationFrame((now) => this.#step(now));
    this.#say();
  }

  #stop() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#say();
  }

  /** Who moves the slider wants to hold it. @param {Event} event */
  #byHand = (event) => {
    if (event.isTrusted || !this.#frame) return;
    this.#stop();
  };

  /** @param {number} now */
  #step(now) {
    const target = this.#target;
    target.u = Math.min(target.u + Math.max(now - this.#before, 0) / 1000 / SECONDS, 1);
    this.#before = now;
    this.#frame = target.u < 1 ? requestAnimationFrame((then) => this.#step(then)) : 0;
    this.#say();
  }
}

customElements.define("surface-player", SurfacePlayer);
