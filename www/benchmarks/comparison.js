// The comparison of /benchmarks/: a table for each library, its rows from benches/results.json.
import { quantity } from "../../benches/js/table.js";
import { escapeHtml } from "../build/highlight.js";

/** @import { Row } from "./index.11ty.js" */

/**
 * The libraries in the order of the page: the name, the beginning of `peer` in the rows, and the package in `versions`.
 *
 * @type {readonly { name: string, peer: string, version?: string, about?: string }[]}
 */
const LIBRARIES = [
  { name: "bezier-js", peer: "bezier-js", version: "bezier-js" },
  { name: "paper.js", peer: "paper.js", version: "paper" },
  { name: "PathKit", peer: "PathKit", version: "pathkit-wasm", about: "Skia's paths as WebAssembly." },
  { name: "svg-path-properties", peer: "svg-path-properties", version: "svg-path-properties" },
  { name: "perfect-freehand", peer: "perfect-freehand", version: "perfect-freehand" },
  { name: "bezier-easing", peer: "bezier-easing", version: "bezier-easing" },
  { name: "three.js", peer: "three", version: "three" },
  { name: "verb", peer: "verb-nurbs", version: "verb-nurbs" },
  { name: "A loop by hand", peer: "loop by hand", about: "Plain JavaScript for this one mesh." },
  { name: "kurbo", peer: "kurbo", version: "kurbo" },
  { name: "lyon_geom", peer: "lyon_geom", version: "lyon_geom" },
  { name: "linesweeper", peer: "linesweeper", version: "linesweeper" },
  { name: "i_curve", peer: "i_curve", version: "i_curve" },
];

/** What most programs need comes first: the beginnings of the rows' ids. Questions asked again come last. */
const COMMON = ["eval", "split", "halve", "length", "bounds", "nearest", "intersect", "path-", "union-icons"];
const ASKED_AGAIN = "again-";

/** The position of a row's group in its table. @param {Row} row */
function rank({ id }) {
  const common = COMMON.findIndex((start) => id.startsWith(start));
  if (id.startsWith(ASKED_AGAIN)) return COMMON.length + 1;
  return common < 0 ? COMMON.length : common;
}

/** Two significant digits: 10.5 is 10×. @param {number} ratio */
const times = (ratio) => `${Number(ratio.toPrecision(2)).toLocaleString("en-US")}×`;

/** Whether both sides are equal within 5 %. @param {number} ratio */
const isEqual = (ratio) => times(Math.max(ratio, 1 / ratio)) === "1×";

/** The ratio; in words where the other library leads. @param {Row} row */
function verdict({ ratio, unit }) {
  if (ratio === null) return "";
  if (isEqual(ratio)) return "equal";
  return ratio > 1 ? times(ratio) : `${times(1 / ratio)} ${unit === "ns" ? "slower" : "more"}`;
}

/** The scale of the bars, in decades: to the left, where the other library is faster, and to the right. */
const [LEFT, RIGHT] = [1.5, 4];
const DECADE = 100;
const TICKS = Array.from({ length: RIGHT + 2 }, (_, k) => `M${(k - 1) * DECADE} 0V16`).join("");

/** A bar from 1×: to the right if casteljau is faster, to the left if the other library is. @param {number} ratio */
function bar(ratio) {
  const end = DECADE * Math.log10(ratio);
  const [x, width] = [Math.min(0, end), Math.abs(end)].map((value) => value.toFixed(1));
  return `<svg viewBox="${-LEFT * DECADE} 0 ${(LEFT + RIGHT) * DECADE} 16" preserveAspectRatio="none" aria-hidden="true"><path d="${TICKS}"/><path class="one" d="M0 0V16"/><rect class="${ratio < 1 ? "theirs" : "ours"}" x="${x}" y="3" width="${width}" height="10"/></svg>`;
}

/** A time with its spread. @param {number} value @param {string} unit @param {number} spread */
function measured(value, unit, spread) {
  const percent = Math.round(100 * spread);
  return `${escapeHtml(quantity(value, unit))}${percent > 0 ? ` <small>±${percent}%</small>` : ""}`.replaceAll(
    / (?!<)/g,
    "\u00a0",
  );
}

/** @param {Row} row @param {string} peer the beginning of `row.peer` that is the library */
function rowHtml(row, peer) {
  const { unit, theirs, ours, ratio, spread } = row;
  const [work, call] = [row.work.replace("native: ", "").replace(/^ +/, "– "), row.peer?.slice(peer.length) ?? ""];
  const name = call.replace(/^[ ,]+/, "");
  const behind = ratio !== null && ratio < 1 && !isEqual(ratio);
  return `<tr${behind ? ' class="behind"' : ""}><th scope="row">${escapeHtml(work)}${name ? ` <small>${escapeHtml(name)}</small>` : ""}</th><td>${measured(theirs, unit, spread[0])}</td><td>${measured(ours, unit, spread[1])}</td><td><div>${ratio === null ? "" : bar(ratio)}<span>${verdict(row)}</span></div></td></tr>`;
}

/** How many rows each side leads; a single row says it itself. @param {Row[]} rows @param {string} library */
function summary(rows, library) {
  const ratios = rows.flatMap(({ ratio }) => (ratio === null ? [] : [ratio]));
  if (ratios.length === 1) return "";
  const equal = ratios.filter(isEqual).length;
  const ours = ratios.filter((ratio) => ratio > 1 && !isEqual(ratio)).length;
  const parts = [
    `casteljau leads in ${ours} of ${ratios.length} rows`,
    ...(ours + equal < ratios.length ? [`${library} in ${ratios.length - ours - equal}`] : []),
    ...(equal > 0 ? [`${equal === 1 ? "one is" : `${equal} are`} equal`] : []),
  ];
  return `${parts.join(", ")}.`;
}

/**
 * The tables of the libraries that some rows name.
 *
 * @param {Row[]} rows
 * @param {Record<string, string>} versions
 */
export function comparison(rows, versions) {
  const all = LIBRARIES.map((library) => ({ ...library, rows: rows.filter((row) => isOf(row, library)) }));
  const found = all.flatMap((library) => library.rows);
  const lost = rows.find((row) => !found.includes(row));
  if (lost) throw new Error(`expected the library of “${lost.peer}” in www/benchmarks/comparison.js`);
  return all
    .filter((library) => library.rows.length > 0)
    .map(({ name, peer, version, about, rows }) => {
      const text = [about ?? "", summary(rows, name === "A loop by hand" ? "the loop" : name)].join(" ").trim();
      const id = name.toLowerCase().replace(/[^a-z0-9_]+/g, "-");
      const lines = rows.toSorted((a, b) => rank(a) - rank(b)).map((row) => rowHtml(row, peer));
      return `<h3 id="${id}">${name}${version ? ` <small>${versions[version]}</small>` : ""}</h3>
${text ? `<p>${text}</p>` : ""}
<table class="compared" aria-labelledby="${id}"><thead><tr><th scope="col">Work</th><th scope="col">${name}</th><th scope="col">casteljau</th><th scope="col">Ratio</th></tr></thead><tbody>
${lines.join("\n")}
</tbody></table>`;
    })
    .join("\n");
}

/** @param {Row} row @param {{ peer: string }} library */
const isOf = (row, { peer }) => row.peer?.startsWith(peer) && /^(?:[ ,]|$)/.test(row.peer.slice(peer.length));
