// What the pictures of the first page share: points of an SVG, marks that can be dragged, and animations that end.

import { capture } from "#js/ui/capture.js";

const SVG = "http://www.w3.org/2000/svg";

/** Whether the reader wants no animation. */
export const REDUCED_MOTION = matchMedia("(prefers-reduced-motion: reduce)");

/** Steps of the arrow keys, in units of the picture, and with Shift. */
const [STEP, LARGE_STEP] = [3, 15];
/** What moves by itself stops after so long. */
const ANIMATION_MS = 5000;
/** A frame counts as at most so long: after a pause, nothing jumps. */
const MAX_FRAME_MS = 100;
/** A pointer that rests so long on a picture wants to use it. */
const REST_MS = 150;

/** The one element that a selector finds. @param {string} selector @param {ParentNode} [within] @returns {any} */
export function find(selector, within = document) {
  const element = within.querySelector(selector);
  if (!element) throw new Error(`expected an element ${selector}`);
  return element;
}

/** @param {Element} element @param {Record<string, string | number>} attributes */
export function setAttributes(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
}

/** Appends an element of SVG. @param {Element} parent @param {string} name @param {Record<string, string | number>} [attributes] */
export function append(parent, name, attributes = {}) {
  const element = document.createElementNS(SVG, name);
  setAttributes(element, attributes);
  parent.append(element);
  return /** @type {SVGElement} */ (element);
}

/** Where a pointer is in the units of an SVG. @param {SVGSVGElement} svg @param {{ clientX: number, clientY: number }} event @returns {[number, number]} */
export function pointIn(svg, { clientX, clientY }) {
  const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(svg.getScreenCTM()?.inverse());
  return [x, y];
}

/** @type {Record<string, readonly [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** The step of an arrow key in the picture's units, or undefined. @param {KeyboardEvent} event @returns {[number, number] | undefined} */
export function arrowStep({ key, shiftKey }) {
  const arrow = ARROWS[key];
  const size = shiftKey ? LARGE_STEP : STEP;
  return arrow && [arrow[0] * size, arrow[1] * size];
}

/**
 * Lets a pointer drag a mark.
 *
 * @param {SVGSVGElement} svg
 * @param {SVGElement} mark
 * @param {{ start(point: [number, number]): void, move(point: [number, number]): void, end?(cancelled: boolean): void }} listeners
 */
export function onDrag(svg, mark, { start, move, end }) {
  mark.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    start(pointIn(svg, event));
    capture(event, {
      move: (moved) => move(pointIn(svg, moved)),
      end: (_, released) => end?.(!released),
    });
  });
}

/**
 * Makes a mark that is dragged or moved by the arrow keys.
 *
 * @param {SVGSVGElement} svg
 * @param {SVGElement} mark
 * @param {{ label: string, position(): readonly number[], move(x: number, y: number): void }} options
 */
export function makeDraggable(svg, mark, { label, position, move }) {
  setAttributes(mark, { tabindex: 0, role: "button", "aria-roledescription": "draggable point", "aria-label": label });
  let [x, y] = [0, 0];
  onDrag(svg, mark, {
    start(point) {
      mark.focus();
      const [px, py] = position();
      [x, y] = [px - point[0], py - point[1]];
    },
    move: (point) => move(point[0] + x, point[1] + y),
  });
  mark.addEventListener("keydown", (event) => {
    const step = arrowStep(event);
    if (!step) return;
    event.preventDefault();
    const [px, py] = position();
    move(px + step[0], py + step[1]);
  });
}

/**
 * Calls `start` once, at the first sign that the reader wants to use a picture: a pointer that rests on it or is pressed, or
 * the focus.
 *
 * @param {Element} element
 * @param {() => unknown} start
 */
export function whenWanted(element, start) {
  const wanted = new AbortController();
  const { signal } = wanted;
  const begin = () => {
    wanted.abort();
    start();
  };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  element.addEventListener("pointerenter", () => (timer = setTimeout(begin, REST_MS)), { signal });
  element.addEventListener("pointerleave", () => clearTimeout(timer), { signal });
  for (const type of ["pointerdown", "focusin"]) element.addEventListener(type, begin, { signal });
  signal.addEventListener("abort", () => clearTimeout(timer));
}

/**
 * Calls `draw` with the milliseconds of an animation: for five seconds after the picture has come into view, and while the
 * pointer or the focus is in its box. With reduced motion it is called once.
 *
 * @param {Element} picture
 * @param {Element} box
 * @param {(ms: number) => void} draw
 */
export function animate(picture, box, draw) {
  if (REDUCED_MOTION.matches) return draw(0);
  let [clock, before, frame, until] = [0, 0, 0, 0];
  const step = (/** @type {number} */ now) => {
    clock += Math.min(MAX_FRAME_MS, Math.max(0, now - before));
    before = now;
    draw(clock);
    frame = now < until || box.matches(":hover, :focus-within") ? requestAnimationFrame(step) : 0;
  };
  const run = () => {
    if (frame) return;
    before = performance.now();
    frame = requestAnimationFrame(step);
  };
  new IntersectionObserver((entries) => {
    cancelAnimationFrame(frame);
    frame = 0;
    if (!entries.at(-1)?.isIntersecting) return;
    until = performance.now() + ANIMATION_MS;
    run();
  }).observe(picture);
  for (const type of ["pointerenter", "focusin"]) box.addEventListener(type, run);
}
