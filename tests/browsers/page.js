// What the tests in other browsers share: the browsers that are asked for, and pages in them.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { serve } from "../page/server.js";
import { start } from "./session.js";

const root = fileURLToPath(new URL("../../", import.meta.url));
/** Where each is: a variable (scripts/browsers.js sets one), else a name on PATH. */
const PROGRAMS = [
  { name: "firefox", variable: "FIREFOX_PATH", names: ["firefox-esr", "firefox"] },
  { name: "webkit", variable: "WEBKIT_DRIVER", names: ["WebKitWebDriver"] },
];

/** Collects what goes wrong before anything else runs. */
const WATCH = `<script>globalThis.problems = [];
addEventListener("error", (event) => problems.push(String(event.message || event.target?.src || event.type)), true);
addEventListener("unhandledrejection", (event) => problems.push(String(event.reason)));
const loud = console.error; console.error = (...words) => (problems.push(words.join(" ")), loud(...words));</script>`;

/**
 * Defines tests in each browser that a variable names, or else in those on PATH. The page's errors count as failures.
 *
 * `pages` can put something else in the place of a file.
 *
 *     inEach((test) => {
 *       test("…", html, async (session, pages) => { … });
 *
 * @param {(test: (title: string, html: string, act: (session: import("./session.js").Session, pages: Map<string, string>) => Promise<void>) => void) => void} define
 */
export function inEach(define) {
  for (const [name, path] of found()) {
    if (!path) test(`${name}: not installed`, { skip: true });
    else define(browserTests(name, path));
  }
}

function found() {
  const { env } = process;
  const folders = (env.PATH ?? "").split(delimiter);
  const onPath = (names) =>
    names.flatMap((name) => folders.map((folder) => join(folder, name))).find((path) => existsSync(path));
  const given = PROGRAMS.filter(({ variable }) => env[variable]);
  return (given.length > 0 ? given : PROGRAMS).map(({ name, variable, names }) => [
    name,
    env[variable] ?? onPath(names),
  ]);
}

/**
 * One server, and one session of each browser, for all tests of a process.
 *
 * @type {{ site?: ReturnType<typeof serve>, sessions: Map<string, any>, count: number }}
 */
const shared = { sessions: new Map(), count: 0 };

after(async () => {
  for (const session of shared.sessions.values()) await (await session).end();
  (await shared.site)?.close();
});

/** The running browser; started at the first call. */
function sessionOf(name, path) {
  const session = shared.sessions.get(name) ?? start(name, path);
  shared.sessions.set(name, session);
  return session;
}

function browserTests(name, path) {
  return (title, html, act) =>
    test(`${name}: ${title}`, async () => {
      shared.site ??= serve({ "/": `${root}site`, "/dist/": `${root}dist` });
      const { url, pages } = await shared.site;
      const page = `/${name}-${++shared.count}.html`;
      pages.set(page, html.replace('<meta charset="utf-8">', `<meta charset="utf-8">${WATCH}`));
      const browser = await sessionOf(name, path);
      await browser.open(url + page);
      await act(browser, pages);
      assert.deepEqual(await browser.evaluate(() => globalThis.problems), [], "the page's console is clean");
    });
}
