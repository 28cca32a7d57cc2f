// Templates that several figures share: sliders, choices, marks, handles.
import { html, svg } from "lit";
import { arrowDirection } from "#js/ui/keys.js";
import { dragHandle } from "#js/ui/capture.js";
import { live } from "lit/directives/live.js";

/**
 * A slider with its name before it and its value behind.
 *
 * @param {{ name: unknown, value: number, min: number, max: number, step?: number | "any", text: string, spoken?: string, change: (value: number) => void }} options
 *   `spoken`: what screen readers say for the value
 */
export const slider = ({ name, value, min, max, step = 0.01, text, spoken = text, change }) => html`
  <label class="slider">
    <span>${name}</span>
    <input type="range" min=${min} max=${max} step=${step} .value=${live(String(value))} aria-valuetext=${spoken}
      @input=${(/** @type {Event} */ event) => change(Number(/** @type {HTMLInputElement} */ (event.target).value))} />
    <span class="value" aria-hidden="true">${text}</span>
  </label>
`;

const PLAY = "M4 2.5v11l9-5.5z";
const PAUSE = "M4 2.5h3v11H4zM9 2.5h3v11H9z";

/** A button that starts and stops. @param {{ playing: boolean, toggle: () => void }} options */
export const playButton = ({ playing, toggle }) => html`
  <button class="play" aria-label=${playing ? "Pause" : "Play"} @click=${toggle}><svg viewBox="0 0 16 16" aria-hidden="true"><path d=${playing ? PAUSE : PLAY} /></svg></button>
`;

/**
 * One of several, as radio buttons.
 *
 * @template T
 * @param {{ name: string, options: readonly (readonly [T, unknown])[], value: T, change: (value: T) => void }} options
 */
export const choice = ({ name, options, value, change }) => html`
  <fieldset>
    <legend>${name}</legend>
    ${options.map(
      ([key, words]) => html`
      <label><input type="radio" name=${name} .checked=${live(key === value)} @change=${() => change(key)} />${words}</label>
    `,
    )}
  </fieldset>
`;

/**
 * A long choice, as a list that opens.
 *
 * @param {{ name: string, options: readonly (readonly [string, string])[], value: string, disabled?: boolean, change: (value: string) => void }} options
 */
export const list = ({ name, options, value, disabled = false, change }) => html`
  <label><span>${name}</span>
    <select ?disabled=${disabled} @change=${(/** @type {Event} */ event) => change(/** @type {HTMLSelectElement} */ (event.target).value)}>
      ${options.map(([key, words]) => html`<option value=${key} ?selected=${key === value}>${words}</option>`)}
    </select>
  </label>
`;

/**
 * @param {{ name: string, value: boolean, change: (value: boolean) => void }} options
 */
export const check = ({ name, value, change }) => html`
  <label><input type="checkbox" .checked=${live(value)} @change=${(/** @type {Event} */ event) => change(/** @type {HTMLInputElement} */ (event.target).checked)} />${name}</label>
`;

/** A disc: a point on the curve. @param {number} x @param {number} y */
export const disc = (x, y, radius = 6) => svg`<circle class="on" cx=${x} cy=${y} r=${radius} />`;

/** A square: a point off the curve. @param {number} x @param {number} y */
export const square = (x, y, half = 5) =>
  svg`<rect class="off" x=${x - half} y=${y - half} width=${2 * half} height=${2 * half} />`;

/** A diamond: the point at t. @param {number} x @param {number} y */
export const diamond = (x, y, half = 7) =>
  svg`<path class="at" d="M${x} ${y - half}L${x + half} ${y}L${x} ${y + half}L${x - half} ${y}Z" />`;

/** A small ring: a point that was computed. @param {number} x @param {number} y @param {string} colour */
export const ring = (x, y, colour, radius = 3.5) =>
  svg`<circle class="hollow" cx=${x} cy=${y} r=${radius} stroke=${colour} />`;

/**
 * A polyline through places.
 *
 * @param {string} className
 * @param {ArrayLike<number>} flat
 * @param {boolean} [closed]
 */
export const polyline = (className, flat, closed = false) => svg`<path class=${className} d=${pathOf(flat, closed)} />`;

/**
 * @param {ArrayLike<number>} flat
 * @param {boolean} [closed]
 */
export function pathOf(flat, closed = false) {
  let d = "";
  for (let i = 0; i + 1 < flat.length; i += 2) d += `${i === 0 ? "M" : "L"}${round(flat[i])} ${round(flat[i + 1])}`;
  return closed ? `${d}Z` : d;
}

/** Hundredths of a pixel are enough. @param {number} value */
const round = (value) => Math.round(value * 100) / 100;

/**
 * A point that can be dragged, over a stage of width × height CSS pixels: two sliders for screen readers and keys, of
 * which the first is in the tab order and takes all four arrows (Shift: ten steps, Alt: a tenth).
 *
 * @typedef {object} HandleOptions
 * @property {string} name
 * @property {"on" | "off"} [kind] its shape
 * @property {readonly [number, number]} at in the figure's own units
 * @property {(point: readonly [number, number]) => readonly [number, number]} place to pixels of the stage
 * @property {(pixels: readonly [number, number]) => [number, number]} unplace and back
 * @property {readonly [number, number]} size of the stage
 * @property {{ min: readonly [number, number], max: readonly [number, number] }} box where the point may be
 * @property {number} step of an arrow key
 * @property {(value: number) => string} [say] a coordinate in words
 * @property {(point: [number, number]) => void} move
 * @property {() => void} [done] after a drag or a key
 * @property {() => void} [cancel] undoes a drag; without it the point goes back to where it was
 * @property {() => void} [focus]
 */

/** @param {HandleOptions} options */
export function handle(options) {
  const { name, kind = "on", at, place, size, box, step, say = String, move, done = () => {}, focus } = options;
  const [x, y] = place(at);
  const spot = `left: ${(100 * x) / size[0]}%; top: ${(100 * y) / size[1]}%`;
  const set = (/** @type {0 | 1} */ axis) => (/** @type {Event} */ event) => {
    const to = /** @type {[number, number]} */ ([...at]);
    to[axis] = Number(/** @type {HTMLInputElement} */ (event.target).value);
    move(to);
    done();
  };
  const input = (/** @type {0 | 1} */ axis) => html`
    <input type="range" min=${box.min[axis]} max=${box.max[axis]} step="any" .value=${live(String(at[axis]))} tabindex=${axis === 0 ? 0 : -1}
      aria-label=${`${name}, ${"xy"[axis]}`} aria-valuetext=${say(at[axis])} @input=${set(axis)} />
  `;
  return html`
    <div class="handle" data-kind=${kind} .style=${spot} @focusin=${focus} @pointerdown=${(/** @type {PointerEvent} */ event) => drag(event, options)}
      @keydown=${(/** @type {KeyboardEvent} */ event) => key(event, { ...options, step, done })}>
      ${input(0)}${input(1)}
    </div>
  `;
}

/**
 * @param {{ min: readonly [number, number], max: readonly [number, number] }} box
 * @param {readonly [number, number]} point
 * @returns {[number, number]}
 */
const within = ({ min, max }, [x, y]) => [clamp(x, min[0], max[0]), clamp(y, min[1], max[1])];

/** @param {number} value @param {number} min @param {number} max */
const clamp = (value, min, max) => Math.min(Math.max(value, min), max);

/**
 * Boxes for fingers overlap: the handle is meant whose centre is nearest.
 *
 * @param {HTMLElement} handle
 * @param {PointerEvent} event
 */
function nearestHandle(handle, { clientX, clientY }) {
  const distance = (/** @type {Element} */ one) => {
    const { x, y, width, height } = one.getBoundingClientRect();
    return Math.hypot(x + width / 2 - clientX, y + height / 2 - clientY);
  };
  const others = /** @type {HTMLElement[]} */ ([...(handle.parentElement?.querySelectorAll(".handle") ?? [])]);
  return others.reduce((best, other) => (distance(other) < distance(best) ? other : best), handle);
}

/**
 * @param {PointerEvent} start
 * @param {HandleOptions} options
 */
function drag(start, { at, place, unplace, size, box, move, done = () => {}, cancel = () => move([at[0], at[1]]) }) {
  if (start.button !== 0) return;
  const handle = /** @type {HTMLElement} */ (start.currentTarget);
  start.preventDefault(); // the focus goes where this function sends it
  const nearest = nearestHandle(handle, start);
  if (nearest !== handle) return void nearest.dispatchEvent(new PointerEvent("pointerdown", start));
  const stage = /** @type {HTMLElement} */ (handle.offsetParent ?? handle.parentElement);
  handle.querySelector("input")?.focus({ preventScroll: true });
  /** @returns {[number, number]} */
  const pixels = (/** @type {PointerEvent} */ event) => {
    const rect = stage.getBoundingClientRect();
    return [((event.clientX - rect.left) * size[0]) / rect.width, ((event.clientY - rect.top) * size[1]) / rect.height];
  };
  const end = (/** @type {boolean} */ released) => {
    handle.removeEventListener("keydown", onEscape);
    if (!released) cancel();
    done();
  };
  const stop = dragHandle(start, {
    from: place(at),
    placeOf: pixels,
    move: (to) => move(within(box, unplace(to))),
    end: (_, released) => end(released),
  });
  const onEscape = (/** @type {KeyboardEvent} */ event) => {
    if (event.key !== "Escape") return;
    stop();
    end(false);
  };
  handle.addEventListener("keydown", onEscape);
}

/**
 * @param {KeyboardEvent} event
 * @param {HandleOptions & { done: () => void }} options
 */
function key(event, { at, place, unplace, box, step, move, done }) {
  const arrow = arrowDirection(event);
  if (!arrow) return;
  event.preventDefault();
  const length = step * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
  const [x, y] = place(at);
  const [ax, ay] = unplace([x + arrow[0], y + arrow[1]]);
  // On the screen's axes, but in the figure's units: the direction of one pixel, made as long as a step.
  const direction = [ax - at[0], ay - at[1]].map((change, k) => (arrow[k] === 0 ? 0 : Math.sign(change)));
  move(within(box, [at[0] + direction[0] * length, at[1] + direction[1] * length]));
  done();
}
