// All layers.
import * as base from "./base.js";
import * as construction from "./construction.js";
import * as features from "./features.js";
import * as measures from "./measures.js";
import { hoveredName, names } from "./names.js";
import * as polylines from "./polylines.js";
import * as envelope from "./envelope.js";
import { continuityLabels } from "./continuity.js";
import * as ways from "./directions.js";
import { weights } from "./weights.js";
import type { Layer } from "./draw-figure.js";
import type { LayerName } from "../editor/state.js";

export { LEVELS, ROLES } from "./theme.js";

/** From the back to the front. */
export const ALL_LAYERS: readonly Layer[] = [
  construction.hull,
  envelope.envelope,
  weights,
  features.bounds,
  construction.polygon,
  base.waiting,
  ways.comb,
  measures.offset,
  envelope.extrapolation,
  base.curve,
  construction.halves,
  polylines.segments,
  polylines.tree,
  measures.ticks,
  base.joints,
  ways.normals,
  ways.tangents,
  base.handles,
  construction.construction,
  features.extrema,
  features.inflections,
  measures.nearest,
  names,
  hoveredName,
  continuityLabels,
  base.points,
  base.atT,
];

/** The layers that can be switched, from the back to the front. */
export const LAYERS = switchable(ALL_LAYERS);

export type SwitchableLayer = Layer & { name: LayerName; title: () => string };

export function switchable(layers: readonly Layer[]) {
  return layers.filter(({ name }) => name) as readonly SwitchableLayer[];
}
