// The golden facts of the tests, for the build of the page: tests/data/README.md says where they come from.
import { readFileSync } from "node:fs";

/** @typedef {any} Input */
/**
 * @typedef {{ id: string, kind: string, source: string, input: Input, expect: any, tol: number, note?: string }} Fact
 *   kind: that of tests/data/curve-facts.json, or "rational " and that of tests/data/nurbs.json
 */

/** The names of the kinds, in the order of the page. @type {Record<string, string>} */
export const KINDS = {
  eval: "Points",
  derivative: "Derivatives",
  tangent: "Tangents",
  curvature: "Curvature",
  bbox: "Bounding boxes",
  extrema: "Extrema",
  inflection: "Inflections",
  classify: "Classification",
  split: "Splitting",
  subsegment: "Parts",
  elevate: "Degree elevation",
  reduce: "Degree reduction",
  length: "Arc length",
  inverse_length: "Parameter at a length",
  length_centroid: "Centroid of the length",
  nearest: "Nearest point",
  min_distance: "Distance of two curves",
  line_intersect: "Intersections with a line",
  intersect: "Intersections of two curves",
  selfintersect: "Self-intersections",
  solve_t: "Parameter at a coordinate",
  roots: "Roots of polynomials",
  area: "Area",
  offset: "Offset curves",
  flatten: "Flattening",
  circle: "Circle by cubics",
  svgpath: "SVG arcs",
  convert: "Conversion of bases",
  bspline: "B-splines",
  continuity: "Continuity",
  easing: "CSS easing",
  eval_rational: "Rational: points",
  "rational curvature": "Rational: curvature",
  "rational bounds": "Rational: bounding boxes",
  "rational extrema": "Rational: extrema",
  "rational inflections": "Rational: inflections",
  "rational split": "Rational: splitting",
  "rational standard_form": "Rational: standard form",
  "rational length": "Rational: arc length",
  "rational time_at_length": "Rational: parameter at a length",
  "rational nearest": "Rational: nearest point",
  "rational intersections": "Rational: intersections",
  "rational area": "Rational: area",
  "rational perimeter": "Rational: circumference of ellipses",
};

/** @param {string} name */
const read = (name) => JSON.parse(readFileSync(new URL(`../../tests/data/${name}`, import.meta.url), "utf8"));

/** All facts, in the order of the kinds. @returns {Fact[]} */
export function readFacts() {
  /** @type {Fact[]} */
  const rational = read("nurbs.json").facts;
  const all = [
    .../** @type {Fact[]} */ (read("curve-facts.json")),
    ...rational.map((fact) => ({ ...fact, kind: `rational ${fact.kind}` })),
  ];
  const order = Object.keys(KINDS);
  const unknown = all.find(({ kind }) => !order.includes(kind));
  if (unknown) throw new Error(`${unknown.id}: the kind ${unknown.kind} has no name in KINDS`);
  return all.sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind));
}

const ISSUE = /([A-Za-z][\w.-]*\/[\w.-]+)#(\d+)/;

/** The address of the issue that a source names, or null. @param {string} source */
export function issueOf(source) {
  const [, repository, number] = ISSUE.exec(source) ?? [];
  return repository ? `https://github.com/${repository}/issues/${number}` : null;
}
