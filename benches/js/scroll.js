// Scrolling pages from their start to their end: the longest task of the main thread, in its processor time, so that other programs
// on the machine count little. One page has 60 applets and 20 teapots; the others are those of the site (`npm run build:site`).
import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { hasBrowser, SITE, traceOf } from "./trace.js";

const APPLETS = 60;
const TEAPOTS = 20;
/** The pause between two turns of the wheel, so that each has its own frames. */
const PAUSE_MS = 60;
/** Of the longest tasks so many events are printed. */
const SHOWN_EVENTS = 8;

/** Three applets, then a teapot, and so on. */
const ELEMENTS = Array.from(
  { length: TEAPOTS },
  () =>
    `${'<bezier-applet controls show="polygon construction"></bezier-applet>'.repeat(APPLETS / TEAPOTS)}<bezier-surface></bezier-surface>`,
).join("\n");
const MANY = `<!doctype html><html lang="en"><title>Scroll</title><script type="module" src="/dist/elements.js"></script>
<style>body { margin: 0 }</style>${ELEMENTS}</html>`;

/**
 * @typedef {object} Scrolled
 * @property {string} id of the row
 * @property {string} work
 * @property {string} page HTML, or a path of the site
 * @property {number} wheelPx by which the wheel turns at a time
 */

/** @type {Scrolled[]} */
const PAGES = [
  {
    id: "scroll",
    work: `longest task while scrolling, ${APPLETS} applets and ${TEAPOTS} teapots`,
    page: MANY,
    wheelPx: 1600,
  },
  ...Object.entries({
    "scroll-curves": "/curves/properties/",
    "scroll-surfaces": "/surfaces/patches/",
    "scroll-ink": "/ink/",
  }).map(([id, page]) => ({ id, work: `longest task while ${page} is scrolled`, page, wheelPx: 200 })),
];

/**
 * @returns {Promise<import("./trace.js").Result[]>} empty without Chromium; without the pages of the site if it is not built
 */
export async function results() {
  if (!hasBrowser()) return [];
  const rows = [];
  for (const scrolled of pages()) {
    const { id, work } = scrolled;
    const ours = 1000 * (await tasks(scrolled))[0].us;
    rows.push({ id, work, peer: null, unit: "ns", theirs: null, ours, ratio: null, spread: [0, 0] });
  }
  return rows;
}

/** Those that are built. */
const pages = () => PAGES.filter(({ page }) => !page.startsWith("/") || existsSync(`${SITE}/index.html`));

/**
 * The tasks of the main thread of the page, the longest first, with the longest events in each.
 *
 * @param {Scrolled} scrolled
 * @returns {Promise<{ us: number, events: string[] }[]>}
 */
async function tasks({ page, wheelPx }) {
  const events = await traceOf(
    page,
    ["devtools.timeline", "toplevel", "disabled-by-default-devtools.timeline"],
    async (opened) => {
      if (page === MANY) await opened.locator("bezier-applet [data-index='1']").first().waitFor({ state: "attached" });
      else await opened.waitForLoadState("networkidle");
      await opened.mouse.move(350, 600);
      return async () => {
        for (;;) {
          const left = await opened.evaluate(() => document.documentElement.scrollHeight - innerHeight - scrollY);
          if (left < 1) return;
          await opened.mouse.wheel(0, wheelPx);
          await opened.waitForTimeout(PAUSE_MS); // waits here, not in the page
        }
      };
    },
  );
  const main = events.find(({ name, args }) => name === "EventDispatch" && args?.data?.type === "wheel");
  const scrolling = main ?? events.find(({ name }) => name === "FireAnimationFrame");
  if (!scrolling) throw new Error("scroll: expected a page that scrolls");
  const own = events
    .filter(({ ph, pid, tid, dur }) => ph === "X" && pid === scrolling.pid && tid === scrolling.tid && dur)
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

// node benches/js/scroll.js [ID …]
if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const ids = process.argv.slice(2);
  for (const scrolled of pages().filter(({ id }) => ids.length === 0 || ids.includes(id))) {
    const all = await tasks(scrolled);
    console.log(`${scrolled.id}: ${all.length} tasks, ${all.filter(({ us }) => us > 50_000).length} above 50 ms`);
    for (const { us, events } of all.slice(0, 8))
      console.log(`  ${us / 1000} ms of processor time: ${events.join(", ")}`);
  }
}
