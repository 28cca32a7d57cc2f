// What all pictures with controls share: a pointer from press to release, and the arrow keys.
import assert from "node:assert/strict";
import { test } from "node:test";
import { arrowDirection, arrowStep } from "#js/ui/keys.js";
import { capture } from "#js/ui/capture.js";

/** An element that knows only about captures. */
class Target extends EventTarget {
  captured = new Set();
  ownerDocument = new EventTarget();
  setPointerCapture(id) {
    this.captured.add(id);
  }
  hasPointerCapture(id) {
    return this.captured.has(id);
  }
  releasePointerCapture(id) {
    this.captured.delete(id);
    this.send("lostpointercapture", id);
  }
  send(type, pointerId = 1, x = 0) {
    this.dispatchEvent(Object.assign(new Event(type), { pointerId, clientX: x }));
  }
}

/** Follows pointer 1; what is reported goes to a list. */
function followed() {
  const target = new Target();
  /** @type {unknown[]} */
  const reports = [];
  const stop = capture(/** @type {any} */ ({ pointerId: 1, currentTarget: target }), {
    move: ({ clientX }) => reports.push(clientX),
    end: (_, released) => reports.push(released ? "released" : "taken away"),
  });
  return { target, reports, stop };
}

test("a captured pointer reports its own moves and its end, once", () => {
  const { target, reports } = followed();
  assert.ok(target.hasPointerCapture(1));
  target.send("pointermove", 1, 5);
  target.send("pointermove", 2, 6);
  target.send("pointerup", 2);
  target.send("pointermove", 1, 7);
  target.send("pointerup");
  target.send("lostpointercapture");
  target.send("pointermove", 1, 8);
  assert.deepEqual(reports, [5, 7, "released"]);
});

test("a pointer is taken away by the browser", () => {
  for (const type of ["pointercancel", "lostpointercapture"]) {
    const { target, reports } = followed();
    target.send(type);
    assert.deepEqual(reports, ["taken away"]);
  }
});

test("after its element was removed, the release is seen by the document", () => {
  const { target, reports } = followed();
  const release = () => Object.assign(new Event("pointerup"), { pointerId: 1 });
  target.ownerDocument.dispatchEvent(release());
  target.ownerDocument.dispatchEvent(release());
  assert.deepEqual(reports, ["released"]);
});

test("a capture that was stopped reports nothing more", () => {
  const { target, reports, stop } = followed();
  stop();
  target.send("pointermove");
  target.send("pointerup");
  assert.deepEqual([reports, target.hasPointerCapture(1)], [[], false]);
});

test("arrow keys: ten steps with Shift, a tenth with Alt, none with Ctrl", () => {
  const pressed = (key, held = {}) => /** @type {any} */ ({ key, ...held });
  assert.deepEqual(arrowStep(pressed("ArrowUp")), [0, -1]);
  assert.deepEqual(arrowStep(pressed("ArrowRight", { shiftKey: true })), [10, 0]);
  assert.deepEqual(arrowStep(pressed("ArrowLeft", { altKey: true })), [-0.1, 0]);
  assert.deepEqual(arrowDirection(pressed("ArrowDown", { shiftKey: true })), [0, 1]);
  assert.equal(arrowStep(pressed("ArrowUp", { ctrlKey: true })), null);
  assert.equal(arrowDirection(pressed("ArrowUp", { metaKey: true })), null);
  assert.equal(arrowDirection(pressed("a")), null);
});
