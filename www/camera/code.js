// The page's path as a program.
import { tuple } from "../figures/lib/numbers.js";

/**
 * @param {import("./state.js").State} state
 * @param {number} progress
 * @param {import("./path.js").Vector} point where the camera is then
 */
export function cameraCode({ points, kind, closed, even, frames }, progress, point) {
  const list = points.map((p) => `  [${p.map((value) => Number(value.toFixed(2))).join(", ")}],`).join("\n");
  const options = `{ kind: "${kind}"${closed ? ", closed: true" : ""} }`;
  const time = even ? "path.timeAtLength(progress * length)" : "progress * path.segmentCount";
  const note =
    frames === "minimising"
      ? ""
      : `  // (the page shows ${frames === "frenet" ? "Frenet's" : "upright"} frames; these do not roll)\n`;
  return `import { Spline } from "casteljau";

const path = Spline.interpolate([
${list}
], ${options});
const length = path.length();

/** Where the camera is, 0 ≤ progress ≤ 1. */
function cameraAt(progress) {
  const t = ${time};
${note}  const { points, tangents, normals } = path.frames([0, t], { normal: [0, 0, 1] });
  return { position: points.slice(3), forward: tangents.slice(3), up: normals.slice(3) };
}

cameraAt(${Number(progress.toFixed(3))}).position; // ${tuple(point, 3)}`;
}
