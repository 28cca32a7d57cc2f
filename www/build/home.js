// What the build writes into the first page: figures of the latest benchmarks, the comparison of the README, code, pictures.
import { readFileSync } from "node:fs";
import { quantity } from "../../benches/js/table.js";
import { IMPORTS, sizeOfImport } from "../../xtask/sizes.js";
import {
  cameraPicture,
  easingPicture,
  firstCurvePicture,
  glyphPicture,
  inkPicture,
  shapesPicture,
} from "./home-pictures.js";
import { escapeHtml } from "./highlight.js";
import { sampleParts } from "./samples.js";
import { drawTeapot } from "./teapot-picture.js";
import { wordPicture } from "./word-picture.js";

const KB = 1000;
const IMPORT = "everything of core";
/** The rows of benches/results.json that the page shows, and where others are faster. */
const [NEAREST, TEAPOT, INK, SIZE] = ["nearest", "adaptive-verb-searched", "ink", "size-curves"];
/** The rows of the README's table that the page shows. */
const COMPARED = [
  "curves",
  "surfaces",
  "rational curves",
  "intersections; tangencies and overlaps told apart",
  "offset curves within a tolerance",
  "joint modes while points move",
  "Boolean operations",
  "outlines of strokes",
  "drawing, events",
];

const read = (/** @type {string} */ path) => readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");

/** @typedef {{ id: string, unit: string, theirs: number, ours: number, ratio: number }} Row */

/** A figure with two significant digits: 10.5 is 10×. @param {number} ratio */
const times = (ratio) => `${Number(ratio.toPrecision(2))}×`;

/**
 * The measured numbers.
 *
 * @param {boolean} hasPackage whether dist/ is what the site is about; otherwise the size is that of the last benchmark
 */
async function numbers(hasPackage) {
  /** @type {{ machine: { cpu: string, cores: number }, date: string, versions: Record<string, string>, rows: Row[] }} */
  const { machine, date, versions, rows } = JSON.parse(read("benches/results.json"));
  const rowOf = (/** @type {string} */ id) => {
    const row = rows.find((each) => each.id === id);
    if (!row) throw new Error(`expected a row ${id} in benches/results.json`);
    return row;
  };
  const comparison = (/** @type {string} */ id) => {
    const { ratio, ours, theirs, unit } = rowOf(id);
    return {
      ratio: times(ratio),
      ours: quantity(ours, unit),
      theirs: quantity(theirs, unit),
      part: (ours / Math.max(ours, theirs)).toFixed(4),
    };
  };
  const row = IMPORTS.find(([name]) => name === IMPORT);
  if (!row) throw new Error(`expected the import ${IMPORT} in xtask/sizes.js`);
  const size = hasPackage ? (await sizeOfImport(row)).gzip : rowOf(SIZE).ours;
  const day = new Date(date).toLocaleDateString("en-GB", {
    day: "numeric",
    month: "long",
    year: "numeric",
    timeZone: "UTC",
  });
  return {
    nearest: comparison(NEAREST),
    teapot: comparison(TEAPOT),
    size: `${(size / KB).toFixed(1)} kB`,
    inkRatio: Math.round(1 / rowOf(INK).ratio),
    conditions: `${day} (${machine.cpu}, ${machine.cores} cores, Node ${versions.node})`,
  };
}

/** The cells of a line of a table in Markdown. @param {string} line */
const cellsOf = (line) =>
  line
    .split("|")
    .slice(1, -1)
    .map((cell) => cell.trim());

/** Rows of the README's comparison with other libraries, its head first; cells as HTML. */
function comparison() {
  const [, table] = /^## Compared with other libraries\n\n((?:\|.*\n)+)/m.exec(read("README.md")) ?? [];
  const [head, , ...lines] = (table ?? "").trim().split("\n").map(cellsOf);
  const rows = COMPARED.map((name) => {
    const row = lines.find(([first]) => first === name);
    if (!row) throw new Error(`expected a row “${name}” in the comparison of README.md`);
    return row;
  });
  const html = (/** @type {string} */ cell) => escapeHtml(cell).replace(/`([^`]+)`/g, "<code>$1</code>");
  return {
    head: head.slice(1),
    rows: rows.map(([name, ...cells]) => ({ name: capitalized(name), cells: cells.map(html) })),
  };
}

/** @param {string} text */
const capitalized = (text) => text[0].toUpperCase() + text.slice(1);

/**
 * @param {(code: string, language: string) => string} highlight
 * @param {boolean} hasPackage
 */
export async function homeData(highlight, hasPackage) {
  await drawTeapot();
  return {
    numbers: await numbers(hasPackage),
    comparison: comparison(),
    word: wordPicture(),
    ink: inkPicture(),
    easing: easingPicture(),
    glyph: glyphPicture(),
    shapes: shapesPicture(),
    camera: cameraPicture(),
    firstCurve: { ...sampleParts("home", highlight), picture: firstCurvePicture() },
  };
}
