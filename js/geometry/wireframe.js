// A surface as isoparametric curves, and as a mesh of tubes or ribbons along them.
import * as check from "./check.js";
import { Curve } from "./curve.js";
import { Mesh, takeMesh } from "./mesh.js";
import { core, done, take, trim } from "../wasm/surfaces-transfer.js";
import { Checked } from "../wasm/transfer.js";

/**
 * The body of each line: tubes around it with a radius and a number of sides (8 by default, at least 3), or flat
 * ribbons of a width that lie in the surface; `lines`: strips per patch each way, 4 by default; `into`: an earlier
 * mesh, whose arrays are reused where they are large enough.
 *
 * @typedef {{ lines?: number, radius: number, sides?: number, into?: Mesh }
 *   | { lines?: number, width: number, into?: Mesh }} WireframeOptions
 */

/** Strips per patch each way where nothing else is asked for. */
const LINES = 4;
const SIDES = 8;
/** The largest count that goes to the core, which refuses by its own limit. */
const MOST_SIDES = 0xffffffff;

/**
 * @internal
 * @param {() => unknown} load writes the surface to the arena
 * @param {{ lines?: number }} [options]
 * @returns {Curve[]}
 */
export function isocurves(load, options) {
  const lines = check.segmentCount(check.options(options).lines ?? LINES, "lines");
  load();
  const numbers = take(0, core().surface_isocurves(lines));
  trim();
  const curves = [];
  for (let at = 0; at < numbers.length; ) {
    const end = at + 1 + 3 * numbers[at];
    curves.push(new Curve(/** @type {any} */ (new Checked(numbers.slice(at + 1, end), 3))));
    at = end;
  }
  return curves;
}

/**
 * @internal
 * @param {() => unknown} load
 * @param {WireframeOptions} options
 * @returns {Mesh}
 */
export function wireframe(load, options) {
  const given = /** @type {Record<string, any>} */ (check.options(options));
  const { lines = LINES, radius, sides = SIDES, width, into } = given;
  if ((radius === undefined) === (width === undefined)) {
    const got = radius === undefined ? "none of them" : "both";
    throw new TypeError(`options: expected either radius (tubes) or width (ribbons), got ${got}`);
  }
  check.segmentCount(lines, "lines");
  check.whole(sides, "sides", 3, MOST_SIDES);
  const size = width === undefined ? check.positive(radius, "radius") : check.positive(width, "width");
  const reused = into === undefined ? into : check.instanceOf(into, "into", Mesh);
  load();
  done(core().surface_wireframe(lines, size, width === undefined ? sides : 0));
  return takeMesh(reused, { own: false });
}
