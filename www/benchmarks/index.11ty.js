// /benchmarks/: the latest results of `npm run bench` (benches/results.json) and the sizes of the package that this build contains.
import { readFileSync } from "node:fs";
import { exponent, quantity, withUnit } from "../../benches/js/table.js";
import { IMPORTS, sizeOfImport } from "../../xtask/sizes.js";
import { tableHtml } from "../build/tables.js";
import { comparison } from "./comparison.js";

/**
 * @typedef {{ id: string, work: string, peer: string | null, unit: string, theirs: number, ours: number, ratio: number | null, spread: [number, number] }} Row
 * @typedef {{ work: string, costs: { size: number, ns: number }[], ours: number }} Growth
 * @typedef {{ machine: { cpu: string, cores: number, platform: string }, date: string, versions: Record<string, string>, rows: Row[], growth: Growth[] }} Results
 */

const KB = 1000;
const NATIVE = "native: ";
const GROWTH_TEXT =
  "<p>The exponent is that of the size in the time per item: 0 means that the whole time is in proportion to the number of items. The growth is the largest ratio of the time per item at one size to that at a smaller size.</p>";

/** @returns {Results} */
const results = () => JSON.parse(readFileSync(new URL("../../benches/results.json", import.meta.url), "utf8"));

export const data = {
  permalink: "/benchmarks/index.html",
  title: "Benchmarks and sizes: casteljau compared with other libraries",
  description:
    "Times of casteljau compared with bezier-js, paper.js, three.js, verb, kurbo and lyon, measured in one run, and the sizes of its entry points.",
  heading: "Benchmarks and sizes",
  lead: "casteljau compared with other libraries, measured in one run on one machine after checking that both sides give the same answer.",
  bodyClass: "wide",
  styles: ["benchmarks.css"],
  script: "main.js",
};

export async function render() {
  const { machine, date, versions, rows, growth } = results();
  const compared = rows.filter(({ peer }) => peer);
  const inJavaScript = compared.filter(({ work }) => !work.startsWith(NATIVE));
  const inRust = compared.filter(({ work }) => work.startsWith(NATIVE));
  const versionList = Object.entries(versions).map(([name, version]) => `${name} ${version}`);
  return `
<p>Times are medians for one call; ns, µs and ms are 10⁻⁹, 10⁻⁶ and 10⁻³ seconds. ± is half the distance of the quartiles. The ratio says how many times faster casteljau is, or slower where it says so; “equal” means within 5%. The bars are logarithmic: from one line to the next is a factor of ten.</p>
${section("javascript", "Compared with JavaScript libraries", comparison(inJavaScript, versions))}
${section("rust", "Compared with Rust libraries", comparison(inRust, versions))}
${section("alone", "Without a comparison", alone(rows.filter(({ peer, unit }) => !peer && unit !== "bytes")))}
${section("growth", "Time per item as the input grows", `${GROWTH_TEXT}\n${growthTable(growth)}`)}
${section("sizes", "Sizes", await sizes())}
${section("conditions", "Machine and versions", `<p>${date}, ${machine.cpu}, ${machine.cores} cores, ${machine.platform}. ${versionList.join(", ")}. To repeat the measurements, run <code>npm run bench</code> in a clone of the repository; all figures are in <code>benches/results.json</code>.</p>`)}`;
}

/** @param {string} id @param {string} title @param {string} content */
const section = (id, title, content) => `<section id="${id}">\n<h2>${title}</h2>\n${content}\n</section>`;

/** @param {string} work rows that belong to the one above are indented */
const nameOf = (work) => work.replace(NATIVE, "").replace(/^ +/, "– ");

/** @param {Row[]} rows */
const alone = (rows) =>
  tableHtml(
    "Times",
    ["Work", "Time"],
    rows.map(({ work, unit, ours, spread }) => [
      nameOf(work.replace(NATIVE, "Rust: ")),
      withUnit(ours, unit, spread[1]),
    ]),
  );

/** @param {Growth[]} growth */
const growthTable = (growth) =>
  tableHtml(
    "Time per item",
    ["Work", "Smallest size", "Largest size", "Exponent", "Growth"],
    growth.map(({ work, costs, ours }) => [
      work,
      costText(costs[0]),
      costText(costs.at(-1)),
      exponent(costs).toFixed(2).replace("-", "−"),
      `${Number(ours.toPrecision(3))}×`,
    ]),
  );

/** The time at one size, without a line break. @param {Growth["costs"][number] | undefined} cost */
const costText = (cost) =>
  cost ? `${cost.size.toLocaleString("en-US")}: ${quantity(cost.ns, "ns")}`.replaceAll(" ", "\u00a0") : "";

/** Bundles of one import each, made while the site is built. */
async function sizes() {
  const { version } = JSON.parse(readFileSync(new URL("../../package.json", import.meta.url), "utf8"));
  const rows = await Promise.all(IMPORTS.map(sizeOfImport));
  const kB = (/** @type {number} */ bytes) => `${(bytes / KB).toFixed(1)} kB`;
  const table = tableHtml(
    "Sizes of bundles",
    ["Import", "Minified", "gzip −9"],
    rows.map(({ name, raw, gzip }) => [name, kB(raw), kB(gzip)]),
  );
  return `<p>What an import of casteljau ${version} adds to a bundle by esbuild, WebAssembly included; 1 kB is 1,000 bytes.</p>\n${table}`;
}
