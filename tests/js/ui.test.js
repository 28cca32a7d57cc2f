// What all pictures with controls share: a pointer from press to release, points that are dragged, the arrow keys.
import assert from "node:assert/strict";
import { test } from "node:test";
import { arrowDirection, arrowStep } from "#js/ui/keys.js";
import { capture } from "#js/ui/capture.js";
import { Drags } from "#js/ui/drag.js";

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

/** Handles of 24 pixels about their points, which follow their pointers; each call is noted. */
function draggable(/** @type {[number, number][]} */ ...points) {
  /** @type {any} */
  const overlay = new EventTarget();
  const boxes = points.map((_, i) =>
    Object.assign(new Target(), {
      getBoundingClientRect: () => ({ left: points[i][0] - 12, top: points[i][1] - 12, width: 24, height: 24 }),
    }),
  );
  /** @type {any[]} */
  const calls = [];
  const note =
    (/** @type {string} */ name) =>
    (/** @type {unknown[]} */ ...rest) =>
      void calls.push([name, ...rest]);
  const drags = new Drags(overlay, {
    placeOf: (index) => points[index],
    toViewBox: ({ clientX, clientY }) => [clientX, clientY],
    elementOf: (index) => /** @type {any} */ (boxes[index]),
    count: () => points.length,
    move: (index, to) => void calls.push(["move", index, ...to]),
    ...{
      grabbed: note("grabbed"),
      schedule() {},
      started: note("started"),
      cancelled: note("cancelled"),
      ended: note("ended"),
    },
  });
  const event = (type, pointerId, clientX, clientY) =>
    Object.assign(new Event(type), { pointerId, clientX, clientY, button: 0 });
  const press = (id, x, y) => overlay.dispatchEvent(event("pointerdown", id, x, y));
  const send = (index, type, id, x = 0, y = 0) => boxes[index].dispatchEvent(event(type, id, x, y));
  return { drags, calls, press, send };
}

test("drags: many moves of a pointer are one move a frame, and the grip stays", () => {
  const { drags, calls, press, send } = draggable([50, 50], [200, 50]);
  press(1, 57, 44);
  for (let x = 0; x < 20; x++) send(0, "pointermove", 1, 60 + x, 54);
  assert.deepEqual([drags.apply(), drags.apply()], [true, false]);
  send(0, "pointermove", 1, 90, 64);
  send(0, "pointerup", 1);
  assert.deepEqual(calls, [["started"], ["grabbed", 0], ["move", 0, 72, 60], ["move", 0, 83, 70], ["ended", [0]]]);
});

test("drags: a change of the pressure alone moves nothing, but a return to the start does", () => {
  const { drags, calls, press, send } = draggable([50, 50]);
  press(1, 57, 44);
  send(0, "pointermove", 1, 57, 44);
  assert.equal(drags.apply(), false);
  send(0, "pointermove", 1, 60, 44);
  send(0, "pointermove", 1, 57, 44);
  assert.equal(drags.apply(), true);
  assert.deepEqual(calls.at(-1), ["move", 0, 50, 50]);
  drags.release();
  assert.deepEqual([drags.active, calls.at(-1)[0]], [false, "move"], "without a report");
});

test("drags: of two overlapping handles the nearer is taken, by a second press the other", () => {
  const { calls, press, send } = draggable([50, 50], [58, 56]);
  const taken = (x, y) => {
    press(1, x, y);
    const [, index] = calls.findLast(([name]) => name === "grabbed");
    send(index, "pointerup", 1, x, y);
    return index;
  };
  assert.deepEqual([taken(52, 51), taken(52, 51), taken(52, 51), taken(58, 56)], [0, 1, 0, 1]);
});

test("drags: a pointer that is taken away gives its point back; the last one restores all", () => {
  const { drags, calls, press, send } = draggable([50, 50], [200, 50]);
  press(1, 50, 50);
  press(2, 200, 50);
  send(0, "pointermove", 1, 70, 50);
  drags.apply();
  send(0, "pointercancel", 1);
  assert.deepEqual(calls.slice(-2), [
    ["move", 0, 70, 50],
    ["move", 0, 50, 50],
  ]);
  send(1, "pointercancel", 2);
  assert.deepEqual([calls.at(-1), drags.active], [["cancelled"], false]);
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
