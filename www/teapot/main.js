// The teapot turns: each frame is one matrix and one call of the core.
import { arrowDirection } from "#js/ui/keys.js";
import { capture } from "#js/ui/capture.js";
import { Surface } from "casteljau/surfaces";
import { pixelsFromSurface, sphereAround } from "./matrix.js";

const TURN_DEGREES_PER_SECOND = 24;
const DEGREES_PER_DRAGGED_PIXEL = 0.5;
const DEGREES_PER_KEY = 5;
/** Above and below, the picture ends: no standing on the head. */
const MAX_TILT = 90;
/** A frame after a pause (a hidden tab) does not make the teapot jump. */
const LONGEST_FRAME_MS = 100;

const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("teapot"));
const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
const button = /** @type {HTMLButtonElement} */ (document.getElementById("rotate"));
const icon = /** @type {SVGPathElement} */ (button.querySelector("path"));
const [turnSlider, tiltSlider, lineSlider] = ["turn", "tilt", "lines"].map(
  (id) => /** @type {HTMLInputElement} */ (document.getElementById(id)),
);

const teapot = Surface.teapot({ up: "z" });
const sphere = sphereAround(teapot.vertices);
const view = { turn: -35, tilt: 24, rotating: !matchMedia("(prefers-reduced-motion: reduce)").matches };
let frame = 0;
let before = 0;

function draw() {
  const { width, height } = canvas;
  const matrix = pixelsFromSurface(sphere, view, width, height);
  context.clearRect(0, 0, width, height);
  context.beginPath();
  teapot.trace(context, { matrix, lines: Number(lineSlider.value) });
  context.strokeStyle = getComputedStyle(canvas).color;
  context.lineWidth = devicePixelRatio;
  context.lineJoin = "round";
  context.stroke();
}

/** @param {number} now */
function step(now) {
  frame = 0;
  const passed = Math.min(now - before, LONGEST_FRAME_MS);
  before = now;
  if (view.rotating) turnTo(view.turn + (TURN_DEGREES_PER_SECOND * passed) / 1000, view.tilt);
  draw();
}

function schedule() {
  if (frame === 0) frame = requestAnimationFrame(step);
}

/** @param {number} turn in degrees @param {number} tilt */
function turnTo(turn, tilt) {
  view.turn = ((((turn + 180) % 360) + 360) % 360) - 180; // −180 … 180
  view.tilt = Math.min(Math.max(tilt, -MAX_TILT), MAX_TILT);
  turnSlider.value = String(view.turn);
  tiltSlider.value = String(view.tilt);
  schedule();
}

/** @param {boolean} rotating */
function setRotating(rotating) {
  view.rotating = rotating;
  button.setAttribute("aria-label", rotating ? "Pause" : "Play");
  icon.setAttribute("d", rotating ? "M8 5v14M16 5v14" : "M8 5l11 7-11 7z");
  icon.setAttribute("fill", rotating ? "none" : "currentColor");
  schedule();
}

button.addEventListener("click", () => setRotating(!view.rotating));
lineSlider.addEventListener("input", schedule);
for (const slider of [turnSlider, tiltSlider]) {
  slider.addEventListener("input", () => {
    setRotating(false);
    turnTo(Number(turnSlider.value), Number(tiltSlider.value));
  });
}

canvas.addEventListener("pointerdown", (event) => {
  if (event.button !== 0) return;
  const { turn, tilt } = view;
  setRotating(false);
  capture(event, {
    move: ({ clientX, clientY }) =>
      turnTo(
        turn + (clientX - event.clientX) * DEGREES_PER_DRAGGED_PIXEL,
        tilt + (clientY - event.clientY) * DEGREES_PER_DRAGGED_PIXEL,
      ),
  });
});

canvas.addEventListener("keydown", (event) => {
  const arrow = arrowDirection(event);
  if (!arrow || event.altKey) return;
  event.preventDefault();
  setRotating(false);
  turnTo(view.turn + arrow[0] * DEGREES_PER_KEY, view.tilt + arrow[1] * DEGREES_PER_KEY);
});

new ResizeObserver(() => {
  canvas.width = Math.round(canvas.clientWidth * devicePixelRatio);
  canvas.height = Math.round(canvas.clientHeight * devicePixelRatio);
  draw();
}).observe(canvas);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", schedule);

turnTo(view.turn, view.tilt);
setRotating(view.rotating);
