// The Web Worker of <ray-tracing>: computes a picture in passes and sends what it has several times a second. The page cancels
// it by ending the worker.
import { Surface } from "casteljau/surfaces";
import { progressiveBlocks, RayTracer } from "./ray-tracer.js";

/** @typedef {{ surface: import("casteljau").SurfaceJSON, view: import("./ray-tracer.js").View }} TraceRequest */
/** @typedef {{ image: Uint8ClampedArray<ArrayBuffer>, progress: number }} TraceProgress RGBA; progress from 0 to 1 */

/** Time between two messages to the page. */
const MESSAGE_INTERVAL_MS = 100;

addEventListener("message", ({ data }) => trace(data));

/** @param {TraceRequest} request */
function trace({ surface, view }) {
  const model = Surface.fromJSON(surface);
  const patches = Array.from({ length: model.patchCount }, (_, k) => model.patch(k));
  const tracer = new RayTracer(/** @type {any} */ (patches), view);
  const { width, height } = view.matrices;
  const image = new Uint8ClampedArray(4 * width * height);
  let [done, sent] = [0, performance.now()];
  for (const { x, y, size } of progressiveBlocks(width, height)) {
    fill(image, width, height, { x, y, size }, tracer.colour(x + 0.5, y + 0.5));
    done++;
    if (performance.now() - sent < MESSAGE_INTERVAL_MS) continue;
    send(image, done / (width * height));
    sent = performance.now();
  }
  send(image, 1);
}

/** @param {Uint8ClampedArray} image @param {number} progress */
function send(image, progress) {
  const copy = image.slice();
  postMessage({ image: copy, progress }, { transfer: [copy.buffer] });
}

/**
 * @param {Uint8ClampedArray} image
 * @param {number} width
 * @param {number} height
 * @param {{ x: number, y: number, size: number }} block
 * @param {number[] | null} colour
 */
function fill(image, width, height, { x, y, size }, colour) {
  const [r, g, b, alpha] = colour ? [...colour.map((c) => 255 * c), 255] : [0, 0, 0, 0];
  for (let j = y; j < Math.min(y + size, height); j++)
    for (let i = x; i < Math.min(x + size, width); i++) image.set([r, g, b, alpha], 4 * (j * width + i));
}
