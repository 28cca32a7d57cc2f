// What a button or a key does to a figure: each action once, with the text of its button, its key and what is announced.
import * as commands from "./commands.js";
import { roomiestAmong } from "./random.js";
import { allPointsToggled } from "./state.js";
import type { Editor } from "./editor.js";
import type { State } from "./state.js";

export interface Action {
  /** The text of its button */
  label: string;
  /** The letter that calls it */
  key?: string;
  /** The text in the list of keys, and what it calls the key */
  help?: readonly [key: string, text: string];
  /** What is announced afterwards */
  done: string | ((state: State) => string);
  /** Whether there is anything to do; always by default */
  enabled?: (editor: Editor<State>) => boolean;
  run: (editor: Editor<State>) => void;
}

/** A change by the user that is complete. */
const changeBy = (change: (state: State) => State) => (editor: Editor<State>) =>
  editor.dispatch(change, { origin: "user" });

export const ACTIONS = {
  undo: {
    label: "Undo",
    help: ["Ctrl Z", "undo (⌘ Z)"],
    done: "Undone",
    enabled: (editor) => editor.canUndo,
    run: (editor) => editor.undo("user"),
  },
  redo: {
    label: "Redo",
    help: ["Ctrl Y", "redo (⌘ Shift Z)"],
    done: "Done again",
    enabled: (editor) => editor.canRedo,
    run: (editor) => editor.redo("user"),
  },
  append: {
    label: "Add a point",
    done: "Point added",
    run: changeBy((state) => commands.appended(state, roomiestAmong(state.box, state.points))),
  },
  insert: {
    label: "Split at t",
    key: "i",
    help: ["i", "cut the segment at t"],
    done: "Split at t",
    enabled: (editor) => commands.canInsert(editor.state),
    run: changeBy((state) => commands.inserted(state)),
  },
  toggle: {
    label: "Fewer points",
    key: "m",
    help: ["m", "few points, all points"],
    done: ({ shown }) => `${shown} points shown`,
    run: changeBy(allPointsToggled),
  },
  randomize: {
    label: "Randomize",
    key: "r",
    help: ["r", "randomize"],
    done: "Points randomized",
    run: changeBy((state) => commands.randomized(state, Math.floor(Math.random() * 2 ** 32))),
  },
  reset: {
    label: "Reset",
    done: "As at first",
    run: (editor) => editor.dispatch(() => editor.origin, { origin: "user" }),
  },
} satisfies Record<string, Action>;

export type ActionName = keyof typeof ACTIONS;

/** The same table, with all members of an action. */
export const actionOf = (name: ActionName): Action => ACTIONS[name];

/** The action of a letter. */
export function actionOfKey(letter: string): ActionName | undefined {
  return (Object.keys(ACTIONS) as ActionName[]).find((name) => actionOf(name).key === letter);
}
