import { Patch } from "casteljau";

export function sample(print) {
  // Four rows of four points: u runs along a row, v from row to row.
  const heights = [0, 1, 1, 0, 1, 3, 3, 1, 1, 3, 3, 1, 0, 1, 1, 0];
  const net = heights.map((z, k) => [k % 4, Math.floor(k / 4), z]);
  const patch = new Patch(net);
  for (const [u, v] of [
    [0, 0],
    [1, 0],
    [0, 1],
    [0.5, 0.5],
  ]) {
    const { x, y, z } = patch.eval(u, v);
    print(`S(${u}, ${v}) = (${x}, ${y}, ${z})`);
  }
}
