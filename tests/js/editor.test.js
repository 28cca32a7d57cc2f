// The editor without DOM: who changes the state, what makes a step of undo, and who is told.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Editor } from "#js/editor/editor.js";

const user = /** @type {const} */ ({ by: "user" });
const drag = /** @type {const} */ ({ by: "user", merge: true });
const page = /** @type {const} */ ({ by: "page" });
const property = /** @type {const} */ ({ by: "page", initial: true });

/** @param {number} x */
const to = (x) => (/** @type {State} */ state) => ({ ...state, x });

/** @typedef {{ x: number, view: number }} State */
function observed() {
  const editor = new Editor(/** @type {State} */ ({ x: 0, view: 1 }), ["view"], ["view"]);
  /** @type {string[]} */
  const events = [];
  const end = editor.subscribe((event) => events.push(event === "state" ? `${editor.state.x}` : event));
  return { editor, events, end };
}

test("editor: a change by the user is one step and two events; by the page, a step and none", () => {
  const { editor, events } = observed();
  editor.dispatch(to(1), user);
  assert.deepEqual(events.splice(0), ["1", "input", "change"]);
  editor.dispatch(to(2), page);
  assert.deepEqual(events.splice(0), ["2"]);
  editor.undo();
  editor.undo();
  assert.deepEqual([editor.state.x, editor.canUndo, editor.canRedo], [0, false, true]);
  editor.redo();
  assert.equal(editor.state.x, 1);
});

test("editor: a drag is one step until it is committed; Escape takes it back", () => {
  const { editor, events } = observed();
  for (const x of [1, 2, 3]) editor.dispatch(to(x), drag);
  assert.ok(editor.isOpen && !editor.canUndo);
  editor.commit();
  assert.deepEqual(events.splice(0), ["1", "input", "2", "input", "3", "input", "change"]);
  editor.dispatch(to(9), drag);
  editor.revert();
  assert.deepEqual(events.splice(0), ["9", "input", "3", "input"]);
  editor.undo();
  assert.equal(editor.state.x, 0);
  editor.commit(); // nothing is open
  editor.revert();
  assert.deepEqual(events, ["0"]);
});

test("editor: Escape leaves the kept properties as they have become", () => {
  const { editor } = observed();
  editor.dispatch(to(1), drag);
  editor.replaceState({ ...editor.state, view: 4 });
  editor.revert();
  assert.deepEqual(editor.state, { x: 0, view: 4 });
});

test("editor: undo by the user tells of it, if there is something to undo", () => {
  const { editor, events } = observed();
  editor.undo("user");
  assert.deepEqual(events, []);
  editor.dispatch(to(1), page);
  editor.undo("user");
  editor.redo("user");
  assert.deepEqual(events, ["1", "0", "input", "change", "1", "input", "change"]);
});

test("editor: a change by the page, and undo, complete what the user was doing", () => {
  for (const act of [(editor) => editor.dispatch(to(5), page), (editor) => editor.undo(), (editor) => editor.reset()]) {
    const { editor, events } = observed();
    editor.dispatch(to(1), drag);
    act(editor);
    assert.deepEqual(events.slice(0, 3), ["1", "input", "change"]);
    assert.ok(!editor.isOpen);
  }
});

test("editor: what is set before the first action of the user makes no step, and reset returns to it", () => {
  const { editor } = observed();
  editor.dispatch(to(1), property);
  editor.dispatch(to(2), property);
  assert.ok(!editor.canUndo);
  editor.dispatch(to(3), user);
  editor.dispatch(to(4), property);
  editor.reset();
  assert.equal(editor.state.x, 2);
  editor.undo();
  editor.undo();
  assert.equal(editor.state.x, 3);
});

test("editor: without its history nothing can be undone, and the state stays", () => {
  const { editor, events } = observed();
  editor.dispatch(to(1), user);
  editor.dispatch(to(2), user);
  editor.undo();
  editor.dispatch(to(3), drag);
  events.splice(0);
  editor.clearHistory();
  editor.undo();
  editor.redo();
  assert.deepEqual([editor.state.x, editor.canUndo, editor.canRedo, editor.isOpen], [3, false, false, false]);
  assert.deepEqual(events, []);
});

test("editor: a change that throws changes nothing, and tells nobody", () => {
  const { editor, events } = observed();
  const refuse = () => {
    throw new RangeError("no");
  };
  for (const how of [user, drag, page, property]) assert.throws(() => editor.dispatch(refuse, how), RangeError);
  assert.deepEqual([events, editor.canUndo, editor.isOpen], [[], false, false]);
});

test("editor: transient properties make no step and stay; the same state tells nobody", () => {
  const { editor, events, end } = observed();
  editor.dispatch((state) => ({ ...state, view: 2 }), user);
  assert.ok(!editor.canUndo);
  editor.dispatch(to(1), user);
  editor.dispatch((state) => ({ ...state, view: 3 }), user);
  editor.undo();
  assert.deepEqual(editor.state, { x: 0, view: 3 });
  events.length = 0;
  editor.replaceState(editor.state);
  end();
  editor.dispatch(to(7), page);
  assert.deepEqual(events, []);
});
