// Paths from SVG path data, compared with svg-path-properties and paper.js.
import { Path } from "casteljau";
import paper from "paper/dist/paper-core.js";
import { svgPathProperties } from "svg-path-properties";
import { assertSame } from "./harness.js";
import { random } from "./inputs.js";

/** The error of both: they integrate whole curves by a Gauss rule without an error estimate. */
const THEIR_TOLERANCE = 1e-4;

paper.setup(new paper.Size(100, 100));

/**
 * Path data as drawing programs write it: closed outlines of lines, cubics and quadratics, also smooth ones, with
 * relative coordinates and three decimals.
 *
 * @param {number} characters
 * @returns {string}
 */
export function outlines(characters) {
  const next = random(7);
  const n = (/** @type {number} */ size) => String(Math.round(1000 * size * (2 * next() - 1)) / 1000);
  const pieces = [];
  for (let length = 0; length < characters; ) {
    let piece = `M${n(500)} ${n(500)}`;
    for (let k = 0; k < 6; k++) {
      piece += `c${n(20)} ${n(20)} ${n(20)} ${n(20)} ${n(40)} ${n(40)}s${n(20)} ${n(20)} ${n(40)} ${n(40)}`;
      piece += `l${n(30)} ${n(30)}q${n(20)} ${n(20)} ${n(40)} ${n(40)}h${n(20)}v${n(20)}`;
    }
    pieces.push(`${piece}z`);
    length += piece.length + 1;
  }
  return pieces.join("");
}

const MEGABYTE = outlines(1e6);

/** @param {string} d */
export function measure(d) {
  const path = Path.fromSVG(d);
  const { min, max } = /** @type {NonNullable<ReturnType<Path["bounds"]>>} */ (path.bounds());
  return { box: [min.x, min.y, max.x, max.y], length: path.length() };
}

/** @param {string} d */
function measureByPaper(d) {
  const path = new paper.CompoundPath(d);
  const { left, top, right, bottom } = path.bounds;
  const result = { box: [left, top, right, bottom], length: path.length };
  path.remove();
  return result;
}

/** @param {string} d */
const lengthByProperties = (d) => new svgPathProperties(d).getTotalLength();

const row = { items: 1, ours: () => measure(MEGABYTE).length };

export const rows = [
  {
    ...row,
    id: "path-paper",
    work: "SVG path data of 1 MB: parse, bounds, length",
    peer: "paper.js CompoundPath",
    check: () => {
      const [their, our] = [measureByPaper(MEGABYTE), measure(MEGABYTE)];
      assertSame("bounds", their.box, our.box, 1e-6);
      assertSame("length", [their.length], [our.length], THEIR_TOLERANCE * our.length);
    },
    theirs: () => measureByPaper(MEGABYTE).length,
  },
  {
    ...row,
    id: "path-properties",
    work: "SVG path data of 1 MB: parse, bounds, length; the peer without bounds",
    peer: "svg-path-properties",
    check: () => {
      const our = measure(MEGABYTE).length;
      assertSame("length", [lengthByProperties(MEGABYTE)], [our], THEIR_TOLERANCE * our);
    },
    theirs: () => lengthByProperties(MEGABYTE),
  },
];
