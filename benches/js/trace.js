// A page in Chromium, what it does while it is traced, and the trace.
import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { chromePath, FLAGS } from "../../tests/page/chrome.js";
import { serve } from "../../tests/page/server.js";

const root = fileURLToPath(new URL("../../", import.meta.url));

/** @typedef {{ name: string, ph: string, pid: number, tid: number, ts: number, dur?: number, tdur?: number, args?: any }} TraceEvent times in µs */

/** @typedef {{ id: string, work: string, peer: null, unit: string, theirs: null, ours: number, ratio: null, spread: number[] }} Result */

/** The folder of the built site. */
export const SITE = `${root}site`;

export const hasBrowser = () => existsSync(chromePath());

/**
 * @param {string} source HTML, which finds the built files in /dist/, or a path of the site
 * @param {string[]} categories
 * @param {(page: import("playwright-core").Page) => Promise<() => Promise<void>>} prepare returns what is traced
 * @returns {Promise<TraceEvent[]>}
 */
export async function traceOf(source, categories, prepare) {
  const isPath = source.startsWith("/");
  const site = await serve(isPath ? { "/": SITE } : { "/dist/": `${root}dist` });
  if (!isPath) site.pages.set("/page.html", source);
  const browser = await chromium.launch({ executablePath: chromePath(), args: FLAGS });
  try {
    const page = await browser.newPage({ viewport: { width: 700, height: 1200 } });
    await page.goto(site.url + (isPath ? source : "/page.html"));
    const act = await prepare(page);
    await browser.startTracing(page, { categories });
    await act();
    return JSON.parse((await browser.stopTracing()).toString()).traceEvents;
  } finally {
    await browser.close();
    site.close();
  }
}
