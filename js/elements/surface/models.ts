// The surfaces that the element knows by name.
import { Surface } from "../../surfaces.js";
import { isRational } from "./settings.js";
import type { Rational } from "./loading.js";
import type { Settings } from "./settings.js";

/** A hilly patch: sixteen points over a square, x and y from −3 to 3. */
const HILL_HEIGHTS = [0, 1, -1.5, 0.5, 1, 4, 1, -1, -1.5, 1, -3, 0.5, 0.5, -1, 0.5, 2];
const SIDE = 4;

/**
 * The surface of a name.
 *
 * @param rational what makes surfaces with weights, once it is loaded; before, these have no patches
 */
export function surfaceNamed(
  { model, parts, height, up }: Pick<Settings, "model" | "parts" | "height" | "up">,
  rational: Rational | null = null,
): Surface {
  if (isRational(model)) return rational?.rationalModel(model, up) ?? new Surface({ vertices: [], patches: [] });
  if (model === "patch") return hill(up);
  if (model === "teacup") return Surface.teacup({ up });
  if (model === "teaspoon") return Surface.teaspoon({ up });
  const options = Object.fromEntries(
    ["rim", "body", "handle", "spout", "lid", "bottom"].map((part) => [part, parts.has(part as any)]),
  );
  return Surface.teapot({ ...options, height, up });
}

/** The points that frame the picture: those of the whole model, so that nothing jumps when a part goes. */
export function framingPoints(
  settings: Pick<Settings, "model" | "parts" | "height" | "up">,
  rational: Rational | null = null,
) {
  const all = { ...settings, parts: new Set(["lid", "rim", "body", "handle", "spout", "bottom"] as const) };
  const { vertices } = surfaceNamed(all, rational);
  return vertices.length ? vertices : Float64Array.of(-1, -1, -1, 1, 1, 1);
}

function hill(up: "z" | "y") {
  const vertices = HILL_HEIGHTS.flatMap((height, k) => {
    const [x, y] = [2 * (k % SIDE) - 3, 2 * Math.floor(k / SIDE) - 3];
    return up === "z" ? [x, y, height] : [x, height, -y];
  });
  return new Surface({ vertices, patches: [HILL_HEIGHTS.map((_, k) => k)] });
}
