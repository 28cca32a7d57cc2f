// <live-figure>: points to drag by pointer and keyboard, sliders and choices. Each change runs the entry's sample again; the picture, the
// literals in the code and the printed lines follow. The samples and the package are loaded at the first use.
import { arrowDirection } from "#js/ui/keys.js";
import { capture } from "#js/ui/capture.js";
import { LiveCode } from "./live-code.js";
import { Drawing } from "./drawing.js";
import { handlesOf } from "./handles.js";
import { inspect } from "./inspect.js";
import { Projection } from "./projection.js";

/**
 * @import { View } from "./projection.js"
 * @typedef {{ run(values: Record<string, any>, console: { log(...values: unknown[]): void }, draw: Drawing): unknown }} Sample
 * @typedef {Record<string, () => Promise<{ default: Record<string, Sample> }>>} Sources
 */

/** How far a key moves a point, in units of the picture: alone and with Shift. */
const [KEY_STEP, FINE_KEY_STEP] = [8, 1];
/** Significant digits of the numbers that are printed after a change. */
const DIGITS = 6;

/** The samples of each page. @type {Sources} */
let sources = {};

/** Defines the element. @param {Sources} samples */
export function defineLiveFigure(samples) {
  sources = samples;
  customElements.define("live-figure", LiveFigure);
}

class LiveFigure extends HTMLElement {
  /** @type {Promise<Sample> | undefined} */
  #loading;
  /** @type {View} */
  #view = JSON.parse(this.dataset.view ?? "{}");
  /** @type {{ name: string, kind: string, value: any }[]} */
  #inputs = JSON.parse(this.dataset.inputs ?? "[]");
  /** @type {Record<string, any>} */
  #values = {};
  /** @type {HTMLButtonElement[]} */
  #buttons = [];
  #code = new LiveCode(this.parentElement?.querySelector("pre"));
  #frame = 0;

  connectedCallback() {
    if (this.#buttons.length > 0) return;
    for (const { name, value } of this.#inputs) this.#values[name] = structuredClone(value);
    for (const control of this.querySelectorAll("input, select")) {
      /** @type {HTMLInputElement} */ (control).disabled = false;
      control.addEventListener("input", () => this.#onControl(/** @type {HTMLInputElement} */ (control)));
    }
    for (const type of ["pointerenter", "focusin"]) this.addEventListener(type, () => void this.#load());
    this.#buttons = this.#handles.map((_, k) => this.#button(k));
    this.querySelector(".view")?.append(...this.#buttons);
    this.#placeButtons();
  }

  get #handles() {
    return handlesOf(this.#inputs, this.#values);
  }

  #load() {
    const { page = "", entry = "" } = this.dataset;
    this.#loading ??= sources[page]().then(({ default: samples }) => samples[entry]);
    return this.#loading;
  }

  /** @param {number} k the number of the handle */
  #button(k) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "handle";
    button.setAttribute("aria-roledescription", "draggable point");
    button.addEventListener("keydown", (event) => this.#onKey(event, k));
    button.addEventListener("pointerdown", (event) => {
      capture(event, { move: (now) => this.#onPointer(now, k) });
      event.preventDefault(); // keeps the page from selecting text
      button.focus();
    });
    return button;
  }

  /** @param {KeyboardEvent} event @param {number} k */
  #onKey(event, k) {
    const direction = arrowDirection(event);
    if (!direction) return;
    event.preventDefault();
    const step = event.shiftKey ? FINE_KEY_STEP : KEY_STEP;
    this.#move(k, direction[0] * step, direction[1] * step);
  }

  /** @param {PointerEvent} event @param {number} k */
  #onPointer(event, k) {
    const box = /** @type {HTMLElement} */ (this.querySelector(".view")).getBoundingClientRect();
    const zoom = this.#view.width / box.width;
    const [x, y] = new Projection(this.#view).place(this.#point(k));
    this.#move(
      k,
      clamp((event.clientX - box.left) * zoom, this.#view.width) - x,
      clamp((event.clientY - box.top) * zoom, this.#view.height) - y,
    );
  }

  /** @param {number} k */
  #point(k) {
    const [x, y, z = 0] = this.#handles[k].point;
    return /** @type {[number, number, number]} */ ([x, y, z]);
  }

  /** Moves a point by so many units of the picture. @param {number} k @param {number} dx @param {number} dy */
  #move(k, dx, dy) {
    const { input, index, point } = this.#handles[k];
    const moved = new Projection(this.#view).moved(this.#point(k), dx, dy);
    const step = 10 ** Math.floor(Math.log10(1 / this.#view.scale)); // the largest power of ten below a pixel
    const rounded = moved.slice(0, point.length).map((x) => Number((Math.round(x / step) * step).toPrecision(12)));
    if (index === undefined) this.#values[input] = rounded;
    else this.#values[input][index] = rounded;
    this.#code.setInput(input, this.#values[input]);
    this.#changed();
  }

  /** @param {HTMLInputElement} control */
  #onControl(control) {
    const output = control.parentElement?.querySelector("output");
    if (output) output.textContent = control.value;
    if (control.dataset.turn !== undefined) this.#view.turn = Number(control.value);
    else {
      const { kind } = this.#inputs.find(({ name }) => name === control.name) ?? {};
      const value = kind === "number" ? Number(control.value) : choice(control.value);
      this.#values[control.name] = value;
      this.#code.setInput(control.name, value);
    }
    this.#changed();
  }

  #changed() {
    this.#placeButtons();
    this.setAttribute("aria-busy", "true");
    cancelAnimationFrame(this.#frame);
    this.#frame = requestAnimationFrame(() => this.#run());
  }

  async #run() {
    const sample = await this.#load();
    const drawing = new Drawing();
    const printed = /** @type {string[]} */ ([]);
    const log = (/** @type {unknown[]} */ ...values) =>
      printed.push(values.map((value) => inspect(value, DIGITS)).join(" "));
    try {
      sample.run(structuredClone(this.#values), { log }, drawing);
      this.#show(drawing);
    } catch (error) {
      printed.push(String(error));
    }
    this.#code.setOutput(printed);
    this.removeAttribute("aria-busy");
  }

  /** @param {Drawing} drawing */
  #show(drawing) {
    const old = this.querySelector("svg");
    if (old) old.outerHTML = drawing.toSVG(this.#view);
  }

  #placeButtons() {
    const projection = new Projection(this.#view);
    for (const [k, button] of this.#buttons.entries()) {
      const { input, index, label, point } = this.#handles[k];
      const [x, y] = projection.place(this.#point(k));
      button.style.left = `${(100 * x) / this.#view.width}%`;
      button.style.top = `${(100 * y) / this.#view.height}%`;
      button.dataset.label = label;
      button.setAttribute("aria-label", `${index === undefined ? input : `${input}[${index}]`} (${point.join(", ")})`);
    }
  }
}

/** @param {number} x @param {number} max */
const clamp = (x, max) => Math.min(Math.max(x, 0), max);

/** The value of a choice. @param {string} text */
const choice = (text) => (text === "true" || text === "false" ? text === "true" : text);
