// Drawing, noted down by a fake context.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Curve, Spline } from "casteljau";
import { CUBIC, near, pointsOf, recorder, refused, SEVEN, SPACE, untyped } from "./reference.js";

const drawn = (shape, options) => {
  const target = recorder();
  assert.equal(shape.trace(target, options), undefined);
  return target.calls;
};

/** The calls as a text. */
const written = ([name, ...numbers]) => `${name}(${numbers})`;
const listed = (shape) => drawn(shape).map(written).join(" ");

test("degrees 1 to 3 are drawn as they are", () => {
  assert.equal(listed(new Curve([1, 2, 3, 4])), "moveTo(1,2) lineTo(3,4)");
  assert.equal(listed(new Curve([1, 2, 3, 4, 5, 0])), "moveTo(1,2) quadraticCurveTo(3,4,5,0)");
  assert.equal(listed(new Curve(CUBIC)), "moveTo(0,0) bezierCurveTo(0,8,8,8,8,0)");
});

test("higher degrees are drawn by cubics, more of them for a finer tolerance", () => {
  const points = pointsOf("0,0 1,9 8,-9 4,7 3,-5 9,2");
  const curve = new Curve(points);
  const [coarse, fine] = [drawn(curve, { tolerance: 1 }), drawn(curve, { tolerance: 1e-6 })];
  assert.ok(coarse.length < fine.length);
  for (const calls of [coarse, fine, drawn(curve)]) {
    assert.deepEqual(calls[0], ["moveTo", 0, 0]);
    assert.ok(calls.slice(1).every(([name, ...rest]) => name === "bezierCurveTo" && rest.length === 6));
    assert.deepEqual(calls.at(-1).slice(5), [9, 2]);
  }
  // An elevated cubic is drawn as that cubic.
  const [, [, ...numbers]] = drawn(new Curve(CUBIC).elevate(), { tolerance: 1e-9 });
  near(numbers, CUBIC.slice(1).flat());
});

test("a spline moves once; a closed one is closed", () => {
  const seven = "moveTo(0,0) bezierCurveTo(0,2,2,2,2,0) bezierCurveTo(2,-4,4,-2,4,0)";
  assert.equal(listed(new Spline(SEVEN)), seven);
  const triangle = new Spline([0, 0, 1, 0, 0, 1], { degree: 1, closed: true });
  assert.equal(listed(triangle), "moveTo(0,0) lineTo(1,0) lineTo(0,1) lineTo(0,0) closePath()");
});

test("what cannot be drawn on, and what cannot be drawn", () => {
  const curve = new Curve(CUBIC);
  for (const bad of [undefined, null, 5, "canvas", {}, [], { ...recorder(), lineTo: 1 }]) {
    refused(() => curve.trace(untyped(bad)), TypeError, /^target: /);
    refused(() => new Spline(SEVEN).trace(untyped(bad)), TypeError, /^target: /);
  }
  refused(() => new Curve(SPACE).trace(recorder()), TypeError, /^trace: .*2D.*3D/);
  refused(() => new Spline(SPACE).trace(recorder()), TypeError, /^trace: .*2D.*3D/);
  for (const tolerance of [0, -1, NaN, Infinity])
    refused(() => curve.trace(recorder(), { tolerance }), RangeError, /^tolerance: /);
  const target = recorder();
  refused(() => curve.trace(target, { tolerance: 1e-30 }), RangeError, /^tolerance: /);
  refused(() => curve.trace(target, { tolerance: untyped("1") }), TypeError, /^tolerance: /);
  assert.deepEqual(target.calls, []);
});

test("a target that throws, or that calls back, does no harm", () => {
  const shapes = [new Curve(CUBIC), new Curve([...CUBIC, [1, 1], [2, 5]]), new Spline(SEVEN)];
  for (const shape of shapes) {
    const bezierCurveTo = () => assert.fail("out of ink");
    assert.throws(() => shape.trace({ ...recorder(), bezierCurveTo }), /out of ink/);
    const calls = drawn(shape);
    const busy = recorder();
    const curveTo = (...args) => {
      new Curve([7, 7, 8, 8]).sample(20_000);
      new Spline(SEVEN).trace(recorder());
      busy.bezierCurveTo(...args);
    };
    shape.trace({ ...busy, bezierCurveTo: curveTo });
    assert.deepEqual(busy.calls, calls);
  }
});

test("methods are called on their target", () => {
  class Context {
    calls = [];
  }
  for (const name of ["moveTo", "lineTo", "quadraticCurveTo", "bezierCurveTo", "closePath"])
    Context.prototype[name] = function add(...args) {
      this.calls.push(args);
    };
  const context = new Context();
  new Curve([1, 2, 3, 4]).trace(untyped(context));
  assert.deepEqual(context.calls, pointsOf("1,2 3,4"));
});
