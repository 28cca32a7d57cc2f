// Scrolling a page with 60 applets and 20 teapots from its start to its end: the longest task of the main thread, in its processor
// time, so that other programs on the machine count little.
import { fileURLToPath } from "node:url";
import { hasBrowser, traceOf } from "./trace.js";

const APPLETS = 60;
const TEAPOTS = 20;
/** The wheel turns by so many pixels at a time, and waits so long. */
const WHEEL_PX = 1600;
const PAUSE_MS = 60;
/** Of the longest tasks so many events are printed. */
const SHOWN_EVENTS = 8;

/** Three applets, then a teapot, and so on. */
const ELEMENTS = Array.from(
  { length: TEAPOTS },
  () =>
    `${'<bezier-applet controls show="polygon construction"></bezier-applet>'.repeat(APPLETS / TEAPOTS)}<bezier-surface></bezier-surface>`,
).join("\n");
const PAGE = `<!doctype html><html lang="en"><title>Scroll</title><script type="module" src="/dist/elements.js"></script>
<style>body { margin: 0 }</style>${ELEMENTS}</html>`;

/**
 * @returns {Promise<import("./trace.js").Result[]>} empty without Chromium
 */
export async function results() {
  if (!hasBrowser()) return [];
  return [
    {
      id: "scroll",
      work: `longest task while scrolling, ${APPLETS} applets and ${TEAPOTS} teapots`,
      peer: null,
      unit: "ns",
      theirs: null,
      ours: 1000 * (await tasks())[0].us,
      ratio: null,
      spread: [0, 0],
    },
  ];
}

/**
 * The tasks of the main thread of the page, the longest first, with the longest events in each.
 *
 * @returns {Promise<{ us: number, events: string[] }[]>}
 */
async function tasks() {
  const events = await traceOf(
    PAGE,
    ["devtools.timeline", "toplevel", "disabled-by-default-devtools.timeline"],
    async (page) => {
      await page.locator("bezier-applet [data-index='1']").first().waitFor({ state: "attached" });
      await page.mouse.move(350, 600);
      return async () => {
        for (;;) {
          const left = await page.evaluate(() => document.documentElement.scrollHeight - innerHeight - scrollY);
          if (left < 1) return;
          await page.mouse.wheel(0, WHEEL_PX);
          await page.waitForTimeout(PAUSE_MS); // waits here, not in the page
        }
      };
    },
  );
  const main = events.find(({ name, args }) => name === "FunctionCall" && args?.data?.url?.includes("/dist/"));
  if (!main) throw new Error("scroll: expected script of the elements");
  const own = events
    .filter(({ ph, pid, tid, dur }) => ph === "X" && pid === main.pid && tid === main.tid && dur)
    .sort((a, b) => a.ts - b.ts || Number(b.dur) - Number(a.dur));
  /** @type {{ us: number, end: number, events: import("./trace.js").TraceEvent[] }[]} */
  const found = [];
  for (const event of own) {
    const last = found.at(-1);
    const end = event.ts + Number(event.dur);
    if (last && event.ts < last.end) last.events.push(event);
    else if (event.name.endsWith("RunTask")) found.push({ us: event.tdur ?? Number(event.dur), end, events: [] });
  }
  return found
    .sort((a, b) => b.us - a.us)
    .map(({ us, events }) => ({ us, events: longest(events.filter(({ name }) => !name.endsWith("RunTask"))) }));
}

/**
 * The longest events, in ms.
 *
 * @param {import("./trace.js").TraceEvent[]} events
 */
function longest(events) {
  const time = (/** @type {import("./trace.js").TraceEvent} */ { tdur, dur }) => tdur ?? Number(dur);
  const sorted = [...events].sort((a, b) => time(b) - time(a)).slice(0, SHOWN_EVENTS);
  return sorted.map((event) => `${event.name} ${time(event) / 1000}`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const all = await tasks();
  for (const { us, events } of all.slice(0, 8)) console.log(`${us / 1000} ms of processor time: ${events.join(", ")}`);
  console.log(`${all.length} tasks, ${all.filter(({ us }) => us > 50_000).length} above 50 ms`);
}
