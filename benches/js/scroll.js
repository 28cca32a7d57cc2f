// The longest task of the main thread while a page of the site is scrolled from its beginning to its end, from the browser's trace.
import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { chromePath, FLAGS } from "../../tests/page/chrome.js";
import { serve } from "../../tests/page/server.js";
import { median, spread } from "./harness.js";

const root = fileURLToPath(new URL("../../", import.meta.url));

/** The pages: a section with many figures of curves, one with surfaces, and a tool. @type {Record<string, string>} */
const PAGES = {
  "scroll-curves": "/curves/properties/",
  "scroll-surfaces": "/surfaces/patches/",
  "scroll-ink": "/ink/",
};
const VIEWPORT = { width: 1280, height: 800 };
const STEP_PX = 200;
/** The pause between two steps, so that each has its own frames. */
const PAUSE_MS = 50;

/** @typedef {{ name: string, ph: string, pid: number, tid: number, dur?: number, args?: any }} TraceEvent times in µs */

/**
 * @param {import("./harness.js").Effort} effort
 * @returns {Promise<import("./frame.js").Result[]>} empty without Chromium or the site
 */
export async function results(effort) {
  if (!existsSync(chromePath()) || !existsSync(`${root}site/index.html`)) return [];
  const rows = [];
  for (const [id, path] of Object.entries(PAGES)) {
    const times = await longestTasks(path, Math.min(5, effort.rounds));
    const ns = times.map((us) => 1000 * us);
    const work = `longest task while ${path} is scrolled`;
    rows.push({
      id,
      work,
      peer: null,
      unit: "ns",
      theirs: null,
      ours: median(ns),
      ratio: null,
      spread: [0, spread(ns)],
    });
  }
  return rows;
}

/**
 * @param {string} path
 * @param {number} count
 * @returns {Promise<number[]>} in µs, for each time that the page is opened
 */
async function longestTasks(path, count) {
  const site = await serve({ "/": `${root}site` });
  const browser = await chromium.launch({ executablePath: chromePath(), args: FLAGS });
  try {
    const times = [];
    for (let i = 0; i < count; i++) {
      const page = await browser.newPage({ viewport: VIEWPORT });
      await page.goto(site.url + path, { waitUntil: "networkidle" });
      await browser.startTracing(page, { categories: ["devtools.timeline", "disabled-by-default-devtools.timeline"] });
      const end = await page.evaluate(() => document.documentElement.scrollHeight);
      await page.mouse.move(VIEWPORT.width / 4, VIEWPORT.height / 2);
      for (let y = 0; y < end; y += STEP_PX) {
        await page.mouse.wheel(0, STEP_PX);
        await page.waitForTimeout(PAUSE_MS); // waits here, not in the page
      }
      const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
      times.push(longestTask(traceEvents));
      await page.close();
    }
    return times;
  } finally {
    await browser.close();
    site.close();
  }
}

/** @param {TraceEvent[]} events */
function longestTask(events) {
  const isMain = events.find(({ name, args }) => name === "EventDispatch" && args?.data?.type === "wheel");
  const scroll = isMain ?? events.find(({ name }) => name === "FireAnimationFrame");
  if (!scroll) throw new Error("scroll: the page did not scroll");
  const tasks = events.filter(({ name, pid, tid }) => name === "RunTask" && pid === scroll.pid && tid === scroll.tid);
  if (tasks.length === 0) throw new Error("scroll: the trace has no tasks");
  return Math.max(...tasks.map(({ dur }) => dur ?? 0));
}

if (process.argv[1] === fileURLToPath(import.meta.url))
  for (const path of process.argv.length > 2 ? process.argv.slice(2) : Object.values(PAGES)) {
    const times = await longestTasks(path, 3);
    console.log(`${path}: longest task ${times.map((us) => `${(us / 1000).toFixed(0)} ms`).join(", ")}`);
  }
