// Frameworks as React 19 set a property where an element has one, with the text that a template gives its attribute.
import assert from "node:assert/strict";
import { test } from "node:test";
import { elementOf } from "./element-node.js";

/** The class of an element. @returns {Promise<any>} */
const classOf = async (name, kind) => (await import(`#js/elements/define/${kind}.js`))[name];
const BezierApplet = await classOf("BezierApplet", "applet");
const BezierBernstein = await classOf("BezierBernstein", "bernstein");
const BezierEasing = await classOf("BezierEasing", "easing");
const BezierEquation = await classOf("BezierEquation", "equation");
const BezierSurface = await classOf("BezierSurface", "surface");

/** What React 19 does with the attributes of a custom element; undefined for those that are no longer given. */
function setAsReact(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name in element) element[name] = value;
    else if (value === undefined) element.removeAttribute(name);
    else element.setAttribute(name, value === true ? "" : value);
  }
}

/** The class, the texts of a template, and the properties after them where they differ from the texts. */
const GIVEN = [
  [
    BezierApplet,
    { points: "70,330 200,40 400,40 600,40 650,400", joints: "c1", t: "0.25", readonly: "", controls: "" },
    { points: JSON.parse("[[70,330],[200,40],[400,40],[600,40],[650,400]]"), joints: [], t: 0.25, readonly: true },
  ],
  [
    BezierApplet,
    {
      degree: "2",
      points: "0,0 9,9 20,0 30,-9 40,0",
      joints: "c1",
      show: "polygon hull",
      hotkeys: "off",
      label: "Curve",
    },
    { degree: 2, points: JSON.parse("[[0,0],[9,9],[20,0],[31,-9],[40,0]]"), joints: ["c1"] },
  ],
  [
    BezierApplet,
    {
      visiblePoints: "4",
      segment: "1",
      tolerance: "2",
      segments: "8",
      offset: "-12.5",
      ticks: "5",
      view: "10 20 67 48",
      matrix: "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
      basis: "hermite",
      show: "hull ticks",
    },
    {
      visiblePoints: 4,
      segment: 1,
      tolerance: 2,
      segments: 8,
      offset: -12.5,
      ticks: 5,
      view: { x: 10, y: 20, width: 67, height: 48 },
      matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
    },
  ],
  [
    BezierSurface,
    { model: "teacup", segments: "24", tolerance: "0.01", u: "0.25", patch: "3", swept: "", controls: "" },
    { segments: 24, tolerance: 0.01, u: 0.25, patch: 3, swept: true },
  ],
  [
    BezierEasing,
    { value: "ease-in", name: "easing", required: "", disabled: "" },
    { value: "cubic-bezier(0.42, 0, 1, 1)", required: true, disabled: true },
  ],
  [BezierBernstein, { degree: "5", t: "0.25", htmlFor: "a" }, { degree: 5, t: 0.25 }],
  [
    BezierEquation,
    { editable: "", degree: "2", points: "0,0 10,20 30,0" },
    { editable: true, degree: 2, points: JSON.parse("[[0,0],[10,20],[30,0]]") },
  ],
];

for (const [Type, texts, after] of GIVEN) {
  test(`${Type.name} takes the texts of ${Object.keys(texts).join(", ")} as properties, and undefined for their removal`, () => {
    const element = elementOf(Type);
    const values = () => Object.fromEntries(Object.keys(texts).map((key) => [key, element[key]]));
    const before = values();
    setAsReact(element, texts);
    assert.deepEqual(values(), { ...texts, ...after });
    setAsReact(element, Object.fromEntries(Object.keys(texts).map((key) => [key, undefined])));
    assert.deepEqual(values(), before);
  });
}

test("numbers, lists and views are set as they are read", () => {
  const element = elementOf(BezierApplet);
  const values = {
    visiblePoints: 4,
    degree: "n",
    tolerance: 0.25,
    offset: -3,
    matrix: Array.from({ length: 16 }, (_, k) => k / 4),
    view: { x: -5, y: 1.5, width: 67, height: 48 },
  };
  Object.assign(element, values);
  const read = () => Object.fromEntries(Object.keys(values).map((key) => [key, element[key]]));
  assert.deepEqual(read(), values);
  Object.assign(element, read());
  assert.deepEqual(read(), values);
  element.visiblePoints = null;
  assert.equal(element.visiblePoints, null);
});

/** What the console says while something is done. */
function warningsOf(act) {
  const warnings = [];
  const { warn } = console;
  console.warn = (text) => warnings.push(text);
  try {
    act();
  } finally {
    console.warn = warn;
  }
  return warnings;
}

for (const [Type, bad, message] of [
  [BezierApplet, { tolerance: -1 }, "tolerance: expected a number from 0.01 to 200, got -1"],
  [BezierApplet, { basis: "bezzier" }, /^basis: expected bezier, .*, got "bezzier"$/],
  [BezierSurface, { segments: 65 }, "segments: expected a number from 1 to 64, got 65"],
  [BezierSurface, { shading: "shiny" }, /^shading: expected smooth, .*, got "shiny"$/],
  [BezierSurface, { show: "surface nett" }, /^show\[1\]: expected surface, .*, got "nett"$/],
  [BezierSurface, { probe: "1 2" }, 'probe: expected three numbers, got "1 2"'],
]) {
  const [[name, value]] = Object.entries(bad);
  test(`${Type.name} keeps the last good ${name}, and the console says so once`, () => {
    const element = elementOf(Type);
    const good = { tolerance: 2, basis: "hermite", segments: 7, shading: "mean", show: "net", probe: "1 2 3" };
    element[name] = good[name];
    const shown = () => {
      const { ms: _, ...mesh } = element.figure.mesh ?? {};
      return JSON.stringify([element.state, { ...element.figure, mesh }]);
    };
    const before = shown();
    const warnings = warningsOf(() => {
      element[name] = value;
      assert.equal(shown(), before);
      element.label = "Other";
      shown();
    });
    assert.equal(warnings.length, 1);
    const said = warnings[0].replace(/^<[^>]+> /, "");
    if (typeof message === "string") assert.equal(said, message);
    else assert.match(said, message);
  });
}

test("a text that no attribute can have changes nothing, as in the attribute", () => {
  const element = elementOf(BezierApplet);
  const before = JSON.stringify(element);
  setAsReact(element, { points: "70,330 x", t: "half", joints: "c7" });
  assert.equal(JSON.stringify(element), before);
});
