// Writes the main rows of the latest results into the README, between its two markers: node benches/js/readme.js
import { readFileSync, writeFileSync } from "node:fs";
import { quantity } from "./table.js";

/** At most twelve rows, of the strong and of the weak sides. */
const ROWS = [
  "sample-reused",
  "eval",
  "easing",
  "intersect-paper",
  "length",
  "nearest",
  "offset",
  "path-paper",
  "teapot-16-fresh-three",
  "adaptive-verb-searched",
  "flatten-0.1-kurbo",
  "nearest-kurbo",
];

const readme = new URL("../../README.md", import.meta.url);
const { machine, date, versions, rows } = JSON.parse(readFileSync(new URL("../results.json", import.meta.url), "utf8"));

/** @param {{ work: string, peer: string | null, unit: string, theirs: number, ours: number, ratio: number }} row */
const line = ({ work, peer, unit, theirs, ours, ratio }) =>
  `| ${work} | ${peer ?? ""} | ${peer ? quantity(theirs, unit) : ""} | ${quantity(ours, unit)} | ${peer && ratio ? `${Number(ratio.toPrecision(2))}×` : ""} |`;

const head = "| work | peer | peer's | ours | ratio |\n|---|---|---|---|---|";
const versionList = Object.entries(versions).map(([name, version]) => `${name} ${version}`);
const source = `${date.slice(0, 10)}, ${machine.cpu}, ${machine.cores} cores; ${versionList.join(", ")}. All rows: \`benches/results.json\`.`;
const table = `\n${head}\n${ROWS.map((id) => line(rows.find((/** @type {{ id: string }} */ row) => row.id === id))).join("\n")}\n\n${source}\n\n`;
const text = readFileSync(readme, "utf8");
writeFileSync(
  readme,
  text.replace(/(<!-- bench:start -->)[\s\S]*(<!-- bench:end -->)/, (_, from, to) => from + table + to),
);
