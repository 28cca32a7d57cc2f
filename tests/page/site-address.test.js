// What a reader changes is in the page's address, and any address can be read: what cannot be used is told, nothing breaks.
import assert from "node:assert/strict";
import { test } from "node:test";
import { propertyOf, SHARED } from "../../www/parts/address.js";
import { openPage } from "./browser.js";
import { centreOf, pullFrom } from "./gestures.js";
import { openStrict, settled } from "./site-pages.js";

/** The page with the figure. */
const ELEMENTS = "/elements/";
const HERO = "#hero";
/** Opens a page at some fragment, in a window with the hero in it; waits until the address has been read. */
async function openAt(t, path, fragment) {
  const page = await openPage(t, path + fragment, { viewport: { width: 1000, height: 1000 }, reducedMotion: "reduce" });
  await ready(page);
  return page;
}
const ready = async (page) => {
  await page.waitForSelector("html[data-address]");
  await settled(page);
};
const hero = (page) => page.locator("#hero bezier-applet");
const attribute = (page, name) => hero(page).getAttribute(name);
const pointOf = (page, i) => hero(page).evaluate((applet, i) => applet.points[i], i);
const message = (page) => page.locator(".address-message");
const hash = (page) => page.evaluate(() => location.hash);

test("a drag is in the address when it is done, undone it is gone, and the address opened anew shows the same", async (t) => {
  const page = await openAt(t, ELEMENTS, "");
  const handle = hero(page).locator('[part="handle"][data-index="1"]');
  await pullFrom(page, await centreOf(handle), 40, 30);
  assert.equal(await hash(page), "", "not while it moves");
  await page.mouse.up();
  await page.waitForFunction(() => location.hash.startsWith("#hero?points="));
  assert.ok((await page.evaluate(() => history.length)) <= 2, "no entry in the history");
  const moved = await pointOf(page, 1);
  const other = await openAt(t, ELEMENTS, await hash(page));
  assert.ok(
    (await pointOf(other, 1)).every((value, k) => Math.abs(value - moved[k]) <= 0.005),
    `${await pointOf(other, 1)} and ${moved}`,
  );
  assert.equal(await message(other).count(), 0);
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => location.hash === "#hero");
});

test("another address while the page is open", async (t) => {
  const page = await openAt(t, ELEMENTS, `${HERO}?t=0.25`);
  assert.equal(await attribute(page, "t"), "0.25");
  await page.evaluate(() => (location.hash = "#hero?t=0.75&show=hull+construction"));
  await hero(page).and(page.locator('[t="0.75"][show="hull construction"]')).waitFor();
});

test("whatever an address can set of an element, it can be read off it", async (t) => {
  const page = await openAt(t, "/surfaces/patches/", "#figure-patch?u=0.2&v=0.9&segments=5");
  const patch = page.locator("#figure-patch bezier-surface");
  assert.deepEqual(await patch.evaluate((/** @type {any} */ { u, v, segments }) => [u, v, segments]), [0.2, 0.9, 5]);
  for (const [path, name] of [
    [ELEMENTS, "bezier-applet"],
    ["/surfaces/patches/", "bezier-surface"],
  ]) {
    await page.goto(path);
    await ready(page);
    const kinds = await page
      .locator(name)
      .first()
      .evaluate(
        (element, names) => names.map((each) => [each, typeof element[each]]),
        Object.keys(SHARED[name]).map(propertyOf),
      );
    for (const [each, kind] of kinds) assert.match(kind, /^(string|number|object)$/, `${name}.${each} is a ${kind}`);
  }
  await page.goto(ELEMENTS);
  await ready(page);
  await hero(page).evaluate((applet) => {
    applet.setAttribute("show", "hull");
    applet.edit({ t: 0.25 }, true);
  });
  await page.waitForFunction(() => location.hash === "#hero?t=0.25&show=hull");
});

/** Fragments, and what is said of them. @type {[string, RegExp][]} */
const ABUSE = [
  ["#hero?t=NaN", /t: expected a number, got “NaN”/],
  ["#hero?t=Infinity&segments=1e999", /t: expected a number.*segments: expected a number/],
  ["#hero?points=1,2 3,NaN", /points: expected pairs of numbers/],
  ["#hero?points=1,2,3", /points/],
  ["#hero?points=%E0%A4%A", /points/],
  [
    "#hero?onclick=alert(1)&style=color:red&__proto__=1",
    /“onclick” is not known.*“style” is not known.*“__proto__” is not known/,
  ],
  ["#hero?show=<img src=x onerror=alert(1)>", /show: expected words/],
  ["#%E0%A4%A", /not on this page/],
  ["#nowhere?t=0.3", /not on this page/],
  ["#main?t=0.3&%=%", /is not known here/],
  ["#npm?t=0.3", /no figure/],
  ["#?", /not on this page/],
  [`#hero?${"t=0.1&".repeat(170_000)}`, /1020006 characters long/],
];

test("any address: a bad one is reported, nothing breaks, the last good state is kept", async (t) => {
  const page = await openAt(t, ELEMENTS, "#hero?t=0.3");
  for (const [fragment, words] of ABUSE) {
    await page.evaluate((fragment) => (location.hash = fragment), fragment);
    await page.waitForFunction(
      (source) => new RegExp(source).test(document.querySelector(".address-message")?.textContent),
      words.source,
    );
    assert.equal(await attribute(page, "t"), "0.3", fragment.slice(0, 60));
    assert.equal(await hero(page).evaluate((applet) => applet.points.length), 7);
  }
  await page.evaluate(() => (location.hash = "#hero?t=0.6"));
  await message(page).waitFor({ state: "detached" });
  assert.equal(await attribute(page, "t"), "0.6");
});

test("opened with what cannot be used: the page or the element says so, and the figure is there", async (t) => {
  for (const [fragment, teller, words] of /** @type {[string, string, RegExp][]} */ ([
    ["#hero?points=1,2,3&t=NaN", ".address-message", /points: expected/],
    [`#${"%".repeat(1_000_000)}`, ".address-message", /1000001 characters long/],
    ["#hero?t=7&points=1e300,0+5,5&degree=zzz", '#hero [part="message"]:not([hidden])', /t: expected|points/],
  ])) {
    const page = await openAt(t, ELEMENTS, fragment);
    await page.locator(teller).waitFor();
    assert.match(await page.locator(teller).innerText(), words);
    assert.equal(await hero(page).evaluate((applet) => applet.points.length), 7);
  }
});

/** Queries of embed.html, the element that comes, and what is said. @type {[string, string, RegExp | null][]} */
const EMBEDDED = [
  ["", "bezier-applet", null],
  ["?points=60,360+160,60+500,60+600,360&t=0.3&controls=", "bezier-applet", null],
  ["?label=My+curve:+100%25!", "bezier-applet", null],
  ["?element=bezier-surface&model=patch&show=surface+net&u=0.3", "bezier-surface", null],
  [
    "?element=script&src=x",
    "bezier-applet",
    /element: expected bezier-applet or bezier-surface, got “script”.*“src” is not known/,
  ],
  ["?element=constructor", "bezier-applet", /got “constructor”/],
  ["?onload=1&style=x&t=%E0%A4%A", "bezier-applet", /“onload”.*“style”.*t: expected a number/],
  [`?t=0.3&x=${"y".repeat(12_000)}`, "bezier-applet", /longer than 10000/],
];

test("embed.html: one element as the query says; unknown parameters are reported", async (t) => {
  const page = await openStrict(t, "/embed.html");
  for (const [query, name, words] of EMBEDDED) {
    await page.goto(`/embed.html${query}`);
    const element = page.locator(`main > ${name}`);
    await element.waitFor();
    assert.equal(await page.locator("main > :not(p, h1)").count(), 1);
    if (words) assert.match(await message(page).innerText(), words);
    else assert.equal(await message(page).count(), 0, query);
    for (const [key, value] of words ? [] : new URLSearchParams(query))
      if (key !== "element") assert.equal(await element.getAttribute(key), value);
  }
});

test("the embedding page learns how tall the figure is", async (t) => {
  const page = await openStrict(t, "/elements/", { viewport: { width: 1200, height: 900 } });
  const frame = page.locator("iframe");
  await frame.scrollIntoViewIfNeeded();
  await page.frameLocator("iframe").locator("bezier-surface canvas").waitFor();
  await page.waitForFunction(() => {
    const { contentDocument, clientHeight } = document.querySelector("iframe");
    return Math.abs(contentDocument.querySelector("main").getBoundingClientRect().height - clientHeight) <= 1;
  });
});
