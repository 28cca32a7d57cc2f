// Nearest points, compared with bezier-js.
import { Bezier } from "bezier-js";
import { Curve } from "casteljau";
import { cubics, random } from "./inputs.js";

const CALLS = 1000;
/** Coordinates are up to 200. */
const SIZE = 200;

const inputs = cubics(64);
const theirs = inputs.map((numbers) => new Bezier(numbers));
const ours = inputs.map((numbers) => new Curve(numbers));
const next = random(4);
const queries = Array.from({ length: CALLS }, () => ({ x: SIZE * next(), y: SIZE * next() }));

/** bezier-js searches near the best of 100 samples: its point may be a little farther away, never nearer. */
function check() {
  queries.forEach((q, i) => {
    const { x, y } = theirs[i & 63].project(q);
    const [their, our] = [Math.hypot(x - q.x, y - q.y), ours[i & 63].nearest(q).distance];
    if (!(our <= their + 1e-11 && our > their - 1e-3 * SIZE)) throw new Error(`nearest: ${our}, bezier-js ${their}`);
  });
}

function theirNearest() {
  let sum = 0;
  for (let i = 0; i < CALLS; i++) sum += theirs[i & 63].project(queries[i]).x;
  return sum;
}

function ourNearest() {
  let sum = 0;
  for (let i = 0; i < CALLS; i++) sum += ours[i & 63].nearest(queries[i]).point.x;
  return sum;
}

/** @type {import("./harness.js").Row[]} */
export const rows = [
  {
    id: "nearest",
    work: "nearest point of a cubic",
    peer: "bezier-js project",
    items: CALLS,
    check,
    theirs: theirNearest,
    ours: ourNearest,
  },
];
