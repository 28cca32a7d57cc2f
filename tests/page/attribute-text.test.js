// Frameworks as React 19 set a property where an element has one, with the text that a template gives its attribute.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./browser.js";

const PAGE = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Properties</title><body><main></main>
<script type="module">import "./dist/elements.js"; globalThis.ready = true;</script></body></html>`;

/** What React 19 does with the attributes of a custom element; undefined for those that are no longer given. */
function setAsReact(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name in element) element[name] = value;
    else if (value === undefined) element.removeAttribute(name);
    else element.setAttribute(name, value === true ? "" : value);
  }
}

/**
 * The properties of an element after its attributes are given as React gives them, and after they are given no longer.
 *
 * @param {import("node:test").TestContext} t
 * @param {string} name
 * @param {Record<string, string>} attributes
 */
async function given(t, name, attributes) {
  const page = await openPage(t, { html: PAGE });
  await page.waitForFunction("globalThis.ready");
  await page.evaluate(`globalThis.setAsReact = ${setAsReact}`);
  return page.evaluate(
    async ([name, attributes]) => {
      const element = /** @type {any} */ (document.createElement(name));
      const values = () => Object.fromEntries(Object.keys(attributes).map((key) => [key, element[key]]));
      const before = values();
      globalThis.setAsReact(element, attributes);
      document.querySelector("main")?.append(element);
      await element.updateComplete;
      const after = values();
      const none = Object.fromEntries(Object.keys(attributes).map((key) => [key, undefined]));
      globalThis.setAsReact(element, none);
      await element.updateComplete;
      return { before, after, removed: values(), message: element.shadowRoot?.textContent ?? "" };
    },
    /** @type {const} */ ([name, attributes]),
  );
}

test("<bezier-applet> takes attributes' texts as properties, and undefined for their removal", async (t) => {
  const attributes = {
    points: "70,330 200,40 400,40 600,40 650,400",
    joints: "c1",
    t: "0.25",
    readonly: "",
    controls: "",
  };
  const more = { degree: "2", show: "polygon hull", hotkeys: "off", label: "Curve" };
  const { before, after, removed } = await given(t, "bezier-applet", { ...attributes, ...more });
  const points = [
    [70, 330],
    [200, 40],
    [400, 40],
    [600, 40],
    [650, 400],
  ];
  assert.deepEqual(after, { ...attributes, ...more, points, t: 0.25, readonly: true, joints: ["c1"] });
  assert.deepEqual(removed, before);
});

test("a text that no attribute can have changes nothing, as in the attribute", async (t) => {
  const { before, after } = await given(t, "bezier-applet", { points: "70,330 x", t: "half", joints: "c7" });
  assert.deepEqual(after, before);
});

test("<bezier-surface> takes attributes' texts as properties, and undefined for their removal", async (t) => {
  const attributes = { model: "teacup", segments: "24", tolerance: "0.01", u: "0.25", patch: "3" };
  const { before, after, removed } = await given(t, "bezier-surface", { ...attributes, swept: "", controls: "" });
  const numbers = { segments: 24, tolerance: 0.01, u: 0.25, patch: 3 };
  assert.deepEqual(after, { ...attributes, ...numbers, swept: true, controls: true });
  assert.deepEqual(removed, before);
});

test("<bezier-easing> takes attributes' texts as properties, `form` too", async (t) => {
  const attributes = { value: "ease-in", name: "easing", required: "", disabled: "" };
  const { after, removed } = await given(t, "bezier-easing", attributes);
  assert.deepEqual(after, { value: "cubic-bezier(0.42, 0, 1, 1)", name: "easing", required: true, disabled: true });
  assert.deepEqual([removed.name, removed.required, removed.disabled], ["", false, false]);
  const page = await openPage(t, { html: PAGE.replace("<main>", '<main><form id="f"></form>') });
  await page.waitForFunction("globalThis.ready");
  const [own, none] = await page.evaluate(() => {
    const element = /** @type {any} */ (document.createElement("bezier-easing"));
    document.querySelector("main")?.append(element);
    element.form = "f";
    const id = element.form?.id;
    element.form = undefined;
    return [id, element.form];
  });
  assert.deepEqual([own, none], ["f", null]);
});

test("the companions take attributes' texts as properties", async (t) => {
  const bernstein = await given(t, "bezier-bernstein", { degree: "5", t: "0.25", htmlFor: "a" });
  assert.deepEqual(bernstein.after, { degree: 5, t: 0.25, htmlFor: "a" });
  assert.deepEqual(bernstein.removed, bernstein.before);
  const equation = await given(t, "bezier-equation", { editable: "", degree: "2", points: "0,0 10,20 30,0" });
  const points = [
    [0, 0],
    [10, 20],
    [30, 0],
  ];
  assert.deepEqual(equation.after, { editable: true, degree: 2, points });
  assert.deepEqual(equation.removed, equation.before);
});
