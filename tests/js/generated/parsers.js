// The readers of the site: addresses (figures, camera, glyph, easing) and timing functions of CSS.
import assert from "node:assert/strict";
import { easing } from "casteljau";
import { readTiming, timingText } from "#js/elements/companions/timing.js";
import { read, SHARED, write } from "../../../www/parts/address.js";
import { checked } from "../../../www/camera/state.js";
import { css, parse } from "../../../www/easing/value.js";
import { fromSvg, pathOf } from "../../../www/glyph/outline.js";

/** What a reader makes of a text; undefined where it refuses, in its own words. */
function readBy(reader, text) {
  try {
    return reader(text);
  } catch (/** @type {any} */ error) {
    assert.ok(error instanceof RangeError || error instanceof TypeError, `${error.stack}`);
    assert.match(error.message, /expected /);
    return undefined;
  }
}

/** A timing function as the package reads it: finite, and the same after writing and reading. */
function readCss(text) {
  const ease = readBy(easing, text);
  if (!ease) return;
  assert.equal(easing(ease.css).css, ease.css);
  for (const x of [-1e308, -1, 0, 0.3, 1, 2, 1e308]) {
    assert.ok(Number.isFinite(ease(x)), `${ease(x)} at ${x}`);
    assert.equal(easing(ease.css)(x), ease(x));
  }
}

/** A timing function as the page and as the elements read it: four numbers that come back from their text. */
function readEasing({ text }) {
  readCss(text);
  const [onPage, inElement] = [readBy(parse, text), readBy(readTiming, text)];
  for (const handles of [onPage, inElement].filter(Boolean)) {
    assert.ok(handles.length === 4 && handles.every(Number.isFinite));
    assert.equal(easing(.../** @type {[number, number, number, number]} */ (handles))(1), 1);
    // The text of −0 is 0.
    const expected = handles.map((x) => x + 0);
    assert.deepEqual(readTiming(timingText(handles)), expected);
  }
  if (onPage) assert.equal(css(parse(css(onPage))), css(onPage));
  return onPage ?? inElement ?? null;
}

/** A state of an application, as figures/address.js reads it. */
function stateOf(text) {
  try {
    return JSON.parse(decodeURIComponent(text));
  } catch (/** @type {any} */ error) {
    assert.ok(error instanceof SyntaxError || error instanceof URIError, `${error.stack}`);
    return null;
  }
}

function readState(text) {
  const state = stateOf(text);
  if (typeof state !== "object" || state === null) return;
  const camera = readBy(checked, state);
  if (camera) assert.deepEqual(checked(JSON.parse(JSON.stringify(camera))), camera);
  const outline = readBy(fromSvg, state.d);
  if (outline) assert.ok(pathOf(fromSvg(pathOf(outline).toSVG({ arcs: false }))).equals(pathOf(outline)));
  if (Array.isArray(state.curve)) readBy(parse, state.curve.join(","));
}

/** The part of an address behind its #: a figure's values, or a state. */
function readAddress({ text }) {
  if (text.startsWith("state=")) readState(text.slice("state=".length));
  const query = text.split(/\?(.*)/s)[1] ?? text;
  for (const known of Object.values(SHARED)) {
    const { values, problems } = read(query, known);
    for (const name of values.keys()) assert.ok(Object.hasOwn(known, name), name);
    const longest = Math.max(0, ...problems.map((problem) => problem.length));
    assert.ok(longest < 200, "a problem that quotes too much");
    const again = read(write(values), known);
    assert.deepEqual([...again.values.keys()], [...values.keys()], "other values are read from what was written");
    assert.deepEqual(again.problems, []);
  }
  return null;
}

/** By the names of the generator's rows. */
export const READERS = { "Easing.text": readEasing, "Address.read": readAddress };
