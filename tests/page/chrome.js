// Which Chromium the tests and the benchmarks start, and how.
import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";
import { chromium } from "playwright-core";
import { runTests } from "../node-tests.js";

/** What the browser's own window shows (the list below the address bar is a page): twice the processor time for each page. */
const WINDOW_FEATURES = ["WebUIOmniboxPopup", "WebUIOmniboxAimPopup", "WebUIOmniboxFullPopup", "PreloadTopChromeWebUI"];
/** Those that Playwright switches off and that matter here: of two lists of features Chromium reads the last. */
const PLAYWRIGHT_FEATURES = [
  "DestroyProfileOnBrowserClose",
  "HttpsUpgrades",
  "HttpsFirstBalancedModeAutoEnable",
  "LensOverlay",
  "MediaRouter",
  "PaintHolding",
  "ThirdPartyStoragePartitioning",
  "OptimizationHints",
  "NetworkTimeServiceQuerying",
  "PreconnectToSearch",
];

/** No sandbox, which Chromium run as root does not have; WebGL2 in software; some features off. */
export const FLAGS = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  `--disable-features=${[...PLAYWRIGHT_FEATURES, ...WINDOW_FEATURES]}`,
];
const NAMES = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/**
 * The browser for page tests: where there is one, the program beside Chromium that lacks the browser's window (Debian's
 * package chromium-headless-shell). The pages are the same; opening one takes half of the processor time.
 */
export function headlessPath() {
  const shell = `${chromePath()}-headless-shell`;
  return existsSync(shell) ? shell : chromePath();
}

/** CHROME_PATH (which scripts/browsers.js finds), else a browser on PATH, else Playwright's own download. */
export function chromePath() {
  const folders = (process.env.PATH ?? "").split(delimiter);
  const onPath = NAMES.flatMap((name) => folders.map((folder) => join(folder, name))).find((path) => existsSync(path));
  return process.env.CHROME_PATH ?? onPath ?? chromium.executablePath();
}

/** The variable with the address of a running browser (of Playwright's `launchServer`), which page tests then share. */
export const BROWSER_ADDRESS = "CASTELJAU_BROWSER";

/** How Chromium is started. */
export const launchOptions = () => ({ executablePath: headlessPath(), args: FLAGS });

/** Test files that run at once: more are not faster on two cores. */
const CONCURRENCY = 2;

/**
 * Starts one Chromium, which all test files share, runs them, and ends it.
 *
 * @param {{ files: string[], patterns: string[] }} chosen
 * @param {Record<string, string>} [env] additional variables for the tests
 * @returns {Promise<number>} the exit code of Node's test runner
 */
export async function runInSharedBrowser(chosen, env = {}) {
  const browser = await chromium.launchServer({ ...launchOptions(), host: "127.0.0.1" });
  try {
    return await runTests(chosen, {
      concurrency: CONCURRENCY,
      env: { ...env, [BROWSER_ADDRESS]: browser.wsEndpoint() },
    });
  } finally {
    await browser.close();
  }
}
