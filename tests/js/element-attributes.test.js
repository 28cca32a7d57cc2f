// Frameworks as React 19 set a property where an element has one, with the text that a template gives its attribute.
import assert from "node:assert/strict";
import { test } from "node:test";
import { elementOf } from "./element-node.js";

const { BezierApplet, BezierBernstein, BezierEasing, BezierEquation, BezierSurface } = /** @type {any} */ (
  await import("#js/elements/index.js")
);

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
    { points: JSON.parse("[[0,0],[9,9],[20,0],[31,-9],[40,0]]"), joints: ["c1"] },
  ],
  [
    BezierSurface,
    { model: "teacup", segments: "24", tolerance: "0.01", u: "0.25", patch: "3", swept: "", controls: "" },
    { segments: 24, tolerance: 0.01, u: 0.25, patch: 3, swept: true, controls: true },
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

test("a text that no attribute can have changes nothing, as in the attribute", () => {
  const element = elementOf(BezierApplet);
  const before = JSON.stringify(element);
  setAsReact(element, { points: "70,330 x", t: "half", joints: "c7" });
  assert.equal(JSON.stringify(element), before);
});
