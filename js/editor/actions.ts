// What a button or a key does to a figure: each action once, with the text of its button, its key and what is announced.
import * as commands from "./commands.js";
import { roomiestAmong } from "./random.js";
import { allPointsToggled } from "./state.js";
import { translated } from "./translations.js";
import type { Editor } from "./editor.js";
import type { State } from "./state.js";

export interface Action {
  /** The text of its button */
  label: () => string;
  /** The letter that calls it */
  key?: string;
  /** The text in the list of keys, and what it calls the key */
  help?: () => readonly [key: string, text: string];
  /** What is announced afterwards */
  done: (state: State) => string;
  /** Whether there is anything to do; always by default */
  enabled?: (editor: Editor<State>) => boolean;
  run: (editor: Editor<State>) => void;
}

/** A change by the user that is complete. */
const dispatch = (editor: Editor<State>, change: (state: State) => State) => editor.dispatch(change, { by: "user" });

export const undo: Action = {
  label: () => translated("Undo"),
  help: () => ["Ctrl Z", translated("undo (⌘ Z)")],
  done: () => translated("Undone"),
  enabled: (editor) => editor.canUndo,
  run: (editor) => editor.undo("user"),
};

export const redo: Action = {
  label: () => translated("Redo"),
  help: () => ["Ctrl Y", translated("redo (⌘ Shift Z)")],
  done: () => translated("Done again"),
  enabled: (editor) => editor.canRedo,
  run: (editor) => editor.redo("user"),
};

export const append: Action = {
  label: () => translated("Add a point"),
  done: () => translated("Point added"),
  run: (editor) => dispatch(editor, (state) => commands.appended(state, roomiestAmong(state.box, state.points))),
};

export const insert: Action = {
  label: () => translated("Split at t"),
  key: "i",
  help: () => ["i", translated("cut the segment at t")],
  done: () => translated("Split at t"),
  enabled: (editor) => commands.canInsert(editor.state),
  run: (editor) => dispatch(editor, (state) => commands.inserted(state)),
};

export const toggle: Action = {
  label: () => translated("Fewer points"),
  key: "m",
  help: () => ["m", translated("few points, all points")],
  done: ({ shown }) => translated("{0} points shown", shown),
  run: (editor) => dispatch(editor, allPointsToggled),
};

export const randomize: Action = {
  label: () => translated("Randomize"),
  key: "r",
  help: () => ["r", translated("randomize")],
  done: () => translated("Points randomized"),
  run: (editor) => dispatch(editor, (state) => commands.randomized(state, Math.floor(Math.random() * 2 ** 32))),
};

export const reset: Action = {
  label: () => translated("Reset"),
  done: () => translated("As at first"),
  run: (editor) => editor.dispatch(() => editor.initialState, { by: "user" }),
};

export const ACTIONS = { undo, redo, append, insert, toggle, randomize, reset } satisfies Record<string, Action>;

export type ActionName = keyof typeof ACTIONS;

/** The same table, with all members of an action. */
export const actionOf = (name: ActionName): Action => ACTIONS[name];

/** The action of a letter. */
export function actionOfKey(letter: string): ActionName | undefined {
  return (Object.keys(ACTIONS) as ActionName[]).find((name) => actionOf(name).key === letter);
}
