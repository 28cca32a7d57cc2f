// The site under some folder of a plain file server: every link, anchor and asset is there, and nothing asks for the root.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, test } from "node:test";
import { intersectionsReported, launch, root } from "./browser.js";
import { serve } from "./server.js";
import { PAGES } from "./site-pages.js";

const FOLDER = "/some/deep/path/";
const server = await serve({ [FOLDER]: `${root}site` });
after(() => server.close());

/** What the text of a page, style sheet or script refers to. */
const REFERENCES = {
  "text/html": /<(?:a|link|script|img|iframe|source)\b[^>]*?\s(?:href|src)="([^"]*)"/g,
  "text/css": /url\(\s*["']?([^"')]+)/g,
  "text/javascript": /(?:\bimport\s*\(?|\bfrom\s*|new URL\(\s*)["'`](\.{0,2}\/[^"'`]+)["'`]/g,
};
const unescaped = (text) => text.replace(/&amp;/g, "&");
const idsOf = (html) => [...html.matchAll(/<[a-z][^<>]*?\sid="([^"]+)"/g)].map(([, id]) => id);

/** Everything that can be reached from the first page, by its address without the fragment. */
async function crawl() {
  const found = new Map();
  const links = [];
  const queue = PAGES.map((path) => new URL(`.${path}`, server.url + FOLDER).href);
  for (const address of queue) {
    const response = await fetch(address);
    const type = response.headers.get("content-type")?.split(";")[0] ?? "";
    const text = await response.text();
    found.set(address, { status: response.status, text });
    if (new URL(address).pathname.startsWith(`${FOLDER}rust/`)) continue; // rustdoc's links are its own
    for (const [, reference] of text.matchAll(REFERENCES[type] ?? /$^/g)) {
      if (/^(data|blob|https?):/.test(reference) && !reference.startsWith(server.url)) continue;
      const target = new URL(unescaped(reference), address);
      links.push({ from: address, reference, target });
      const bare = target.href.split("#")[0];
      if (!queue.includes(bare)) queue.push(bare);
    }
  }
  return { found, links };
}

const { found, links } = await crawl();

test("every link and asset is there, by a relative address", () => {
  assert.ok(links.length > 200, `${links.length} links`);
  for (const { from, reference, target } of links) {
    assert.ok(!reference.startsWith("/"), `${from}: ${reference} is not relative`);
    assert.ok(target.pathname.startsWith(FOLDER), `${from}: ${reference} leaves the folder`);
    assert.equal(found.get(target.href.split("#")[0])?.status, 200, `${from}: ${reference}`);
  }
});

test("every anchor is there", () => {
  const anchors = links.filter(({ target }) => target.hash);
  assert.ok(anchors.length > 100, `${anchors.length} anchors`);
  const missing = anchors.filter(
    ({ target }) =>
      !idsOf(found.get(target.href.split("#")[0])?.text ?? "").includes(
        decodeURIComponent(target.hash.slice(1).split("?")[0]),
      ),
  );
  assert.deepEqual([...new Set(missing.map(({ from, reference }) => `${from}: ${reference}`))], []);
});

test("no id is given twice, and all pages have the same names of pages above", () => {
  const names = (html) =>
    [
      ...(html.match(/<header class="site-bar">.*?<\/header>/s)?.[0] ?? "").matchAll(
        /<li><a href="(?:\.\.\/)*([a-z]+\/)"[^>]*><b>([^<]+)<\/b>/g,
      ),
    ].map(([, path, name]) => `${path} ${name}`);
  const expected = names(readFileSync(`${root}site/index.html`, "utf8"));
  assert.ok(expected.length >= 15, expected.join(", "));
  for (const path of PAGES) {
    const { text } = found.get(new URL(`.${path}`, server.url + FOLDER).href);
    const all = idsOf(text);
    assert.deepEqual(
      all.filter((id, i) => all.indexOf(id) !== i),
      [],
      path,
    );
    if (path !== "/embed.html") assert.deepEqual(names(text), expected, path);
  }
});

test("in the browser, too, nothing is missing and nothing is asked of another place", async (t) => {
  const context = await (await launch()).newContext();
  t.after(() => context.close());
  const wrong = [];
  context.on(
    "response",
    (response) => response.status() >= 400 && wrong.push(`${response.status()} ${response.url()}`),
  );
  context.on(
    "request",
    (request) =>
      /^https?:/.test(request.url()) && !request.url().startsWith(server.url + FOLDER) && wrong.push(request.url()),
  );
  const left = "net::ERR_ABORTED"; // asked for by a page that was left meanwhile
  context.on(
    "requestfailed",
    (request) =>
      request.failure()?.errorText === left || wrong.push(`${request.failure()?.errorText} ${request.url()}`),
  );
  const pending = new Set();
  let whenIdle = () => {};
  context.on("request", (request) => pending.add(request));
  for (const type of ["requestfinished", "requestfailed"])
    context.on(/** @type {any} */ (type), (request) => pending.delete(request) && pending.size === 0 && whenIdle());
  const page = await context.newPage();
  for (const path of PAGES) {
    await page.goto(new URL(`.${path}`, server.url + FOLDER).href);
    await intersectionsReported(page); // what draws has been asked for
    if (pending.size > 0) await new Promise((resolve) => (whenIdle = () => resolve(undefined)));
  }
  assert.deepEqual(
    wrong.filter((line) => !line.endsWith("/favicon.ico")),
    [],
  );
});
