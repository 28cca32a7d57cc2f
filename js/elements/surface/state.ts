// What the editor of `<bezier-surface>` keeps, and changes of it.
import type { Surface } from "../../surfaces.js";
import type { Attributes } from "./settings.js";

/** Never modified. The values of the attributes are those that were given, also invalid ones. */
export interface State extends Attributes {
  /** The surface that the page or a file has given; null: the attribute `model` names it */
  given: Surface | null;
  /** The control points that were moved, by vertex */
  moves: ReadonlyMap<number, number[]>;
  /** The model whose points were moved; see `Subject.modelKey` */
  movedModel: string;
}

const NO_MOVES = { moves: new Map(), movedModel: "" } as const;

/** The attributes are undefined until the constructor of the element sets them. */
export const firstState = (): State => ({ given: null, ...NO_MOVES }) as unknown as State;

/** The properties whose changes make no undo step, and which undo leaves as they are. */
export const TRANSIENT = ["u", "v", "step", "swept", "probe"] as const;

/** @param model the model that is shown; see `Subject.modelKey` */
export function withPointAt(state: State, model: string, vertex: number, to: number[]): State {
  return { ...state, moves: new Map(state.moves).set(vertex, to), movedModel: model };
}

export const withoutMoves = (state: State): State => (state.moves.size ? { ...state, ...NO_MOVES } : state);

/** Shows another surface; null shows the model. */
export const withSurface = (state: State, given: Surface | null): State => ({ ...state, given, ...NO_MOVES });
