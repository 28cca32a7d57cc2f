// What the tests of the layers share: states, figures, and a canvas that writes down what is drawn.
import { drawFigure } from "#js/layers/draw-figure.js";
import { ALL_LAYERS, LAYERS, ROLES } from "#js/layers/index.js";
import { figureOf } from "#js/editor/figure.js";
import { firstState, LAYER_NAMES } from "#js/editor/state.js";

/** A theme whose colours are the names of their roles. @type {any} */
export const theme = Object.fromEntries(ROLES.map((role) => [role, role]));

/**
 * The first state with changes.
 *
 * @param {Record<string, any>} [changes] `layers`: an array of names or "all"
 */
export function stateWith({ layers = [], ...changes } = {}) {
  const first = firstState();
  const points = changes.points ?? first.points;
  return { ...first, shown: points.length, ...changes, layers: new Set(layers === "all" ? LAYER_NAMES : layers) };
}

/** What a layer derives. */
export function derived(name, changes) {
  const state = stateWith({ layers: [name], ...changes });
  const figure = figureOf(state);
  const layer = LAYERS.find((each) => each.name === name);
  if (!layer) throw new RangeError(`expected the name of a layer, got ${name}`);
  const data = layer.derive(figure, state);
  return { data, figure, state, words: layer.describe?.(data, state) ?? "" };
}

/** Every call to a canvas, with the paints it had then. */
export class Tape {
  calls = [];
  constructor() {
    const paths = "beginPath moveTo lineTo bezierCurveTo quadraticCurveTo closePath arc rect";
    for (const name of `clearRect ${paths} setLineDash fill stroke strokeText fillText`.split(" ")) {
      this[name] = (...args) =>
        void this.calls.push(
          [name, ...args, this.strokeStyle, this.fillStyle, this.globalAlpha].slice(0, args.length + 4),
        );
    }
  }
  globalAlpha = 1;
  strokeStyle = "";
  fillStyle = "";
  lineWidth = 1;
  /** The calls of one name, without paints. */
  of(name) {
    return this.calls.filter(([each]) => each === name).map((call) => call.slice(1, -3));
  }
}

/** Draws a state on a tape. */
export function drawn(changes, px = 1) {
  const state = stateWith(changes);
  const ctx = new Tape();
  const told = drawFigure({ ctx: /** @type {any} */ (ctx), theme, px }, state, figureOf(state), ALL_LAYERS);
  return { ctx, told, state };
}
