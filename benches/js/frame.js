// The cost of moving a point: all script from a pointermove to the end of its frame, with all layers of
// <bezier-applet>, from the browser's trace of its main thread.
import { fileURLToPath } from "node:url";
import { LAYER_NAMES } from "#js/editor/state.js";
import { median, spread } from "./harness.js";
import { hasBrowser, traceOf } from "./trace.js";

/** A page with the two cubics of the tutorial. */
const PAGE = `<!doctype html><html lang="en"><title>Frame</title><script type="module" src="/dist/elements.js"></script>
<style>body { margin: 0 }</style><bezier-applet show="${LAYER_NAMES.join(" ")}"></bezier-applet></html>`;

/** The events of the trace in which script runs. */
const SCRIPT_EVENTS = new Set([
  "EventDispatch",
  "FireAnimationFrame",
  "FunctionCall",
  "RunMicrotasks",
  "v8.callFunction",
  "TimerFire",
]);
const WARM_UP_MOVES = 40;
/** The pause between two moves, so that each has its own frame. */
const PAUSE_MS = 40;

/**
 * @param {import("./harness.js").Effort} effort
 * @returns {Promise<import("./trace.js").Result[]>} empty without Chromium
 */
export async function results(effort) {
  if (!hasBrowser()) return [];
  const times = await moves(WARM_UP_MOVES, Math.max(20, effort.rounds));
  const ns = times.map((us) => 1000 * us);
  return [
    {
      id: "frame",
      work: "pointermove → frame, script, all layers, 2 cubics",
      peer: null,
      unit: "ns",
      theirs: null,
      ours: median(ns),
      ratio: null,
      spread: [0, spread(ns)],
    },
  ];
}

/**
 * @param {number} warmUp the number of moves that are not measured
 * @param {number} count
 * @returns {Promise<number[]>} time of the main thread for each move in µs
 */
async function moves(warmUp, count) {
  const events = await traceOf(PAGE, ["devtools.timeline", "v8"], async (page) => {
    const handle = page.locator("bezier-applet [data-index='1']").first();
    await handle.waitFor({ state: "attached" });
    const box = await handle.boundingBox();
    if (!box) throw new Error("frame: the second point has no handle on the page");
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const at = (/** @type {number} */ k) =>
      /** @type {const} */ ([x + 30 * Math.sin(0.3 * k), y + 30 * Math.cos(0.3 * k)]);
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let k = 0; k < warmUp; k++) await step(page, at(k));
    return async () => {
      for (let k = 0; k < count; k++) await step(page, at(warmUp + k));
    };
  });
  return scriptPerMove(events);
}

/**
 * @param {import("playwright-core").Page} page
 * @param {readonly [number, number]} position
 */
async function step(page, [x, y]) {
  await page.mouse.move(x, y);
  await page.waitForTimeout(PAUSE_MS); // waits here, not in the page
}

/**
 * @param {import("./trace.js").TraceEvent[]} events
 * @returns {number[]}
 */
function scriptPerMove(events) {
  const isMove = (/** @type {import("./trace.js").TraceEvent} */ event) =>
    event.name === "EventDispatch" && event.args?.data?.type === "pointermove";
  const first = events.find(isMove);
  if (!first) throw new Error("frame: the page received no pointermove");
  const scriptEvents = events
    .filter(({ name, ph, pid, tid }) => ph === "X" && pid === first.pid && tid === first.tid && SCRIPT_EVENTS.has(name))
    .sort((a, b) => a.ts - b.ts || (b.dur ?? 0) - (a.dur ?? 0));
  /** @type {number[]} */
  const sums = [];
  let end = 0;
  for (const event of scriptEvents) {
    if (event.ts < end) continue; // nested in the previous event
    end = event.ts + (event.dur ?? 0);
    if (isMove(event)) sums.push(0);
    if (sums.length) sums[sums.length - 1] += event.tdur ?? event.dur ?? 0;
  }
  return sums;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const times = await moves(WARM_UP_MOVES, 100);
  const sorted = [...times].sort((a, b) => a - b);
  const slowest = sorted[sorted.length - 1];
  console.log(
    `${times.length} moves: median ${median(times) / 1000} ms, 90 % under ${sorted[Math.floor(0.9 * sorted.length)] / 1000} ms, maximum ${slowest / 1000} ms`,
  );
}
