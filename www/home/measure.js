// Measures one row of the benchmarks in the reader's browser, as `npm run bench` does: the median of many batches.
import { Curve } from "casteljau/core";

const CALLS = 20_000;
const BATCHES = 31;
const NS_PER_MS = 1e6;

/** @param {HTMLButtonElement} button @param {HTMLElement} output */
export async function measure(button, output) {
  button.disabled = true;
  output.textContent = "Measuring …";
  await new Promise((resolve) => setTimeout(resolve, 50)); // until the text is visible
  const curve = new Curve([
    [20, 130],
    [60, -40],
    [200, 180],
    [280, 20],
  ]);
  const points = Array.from(
    { length: 256 },
    (_, i) => /** @type {[number, number]} */ ([(i * 37) % 300, (i * 61) % 180]),
  );
  const batch = () => {
    const start = performance.now();
    for (let i = 0; i < CALLS; i++) curve.nearest(points[i % points.length]);
    return ((performance.now() - start) / CALLS) * NS_PER_MS;
  };
  batch(); // compiles the code
  const times = Array.from({ length: BATCHES }, batch).sort((a, b) => a - b);
  const median = times[(BATCHES - 1) / 2];
  output.textContent = `${Math.round(median)} ns in this browser, the median of ${BATCHES} batches of ${CALLS.toLocaleString("en-US")} calls.`;
  button.disabled = false;
}
