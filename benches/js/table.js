// Formats results as a text table.

/** @param {number} number @param {number} [digits] */
const round = (number, digits = 3) =>
  Number(number.toPrecision(digits)).toLocaleString("en-US", { maximumFractionDigits: 3 });

/**
 * A number with its unit.
 *
 * @param {number | null} value
 * @param {string} unit
 * @param {number} [spread]
 */
export function withUnit(value, unit, spread = 0) {
  if (value === null) return "–";
  return `${quantity(value, unit)}${spread ? ` ±${Math.round(100 * spread)}%`.padStart(6) : ""}`;
}

/**
 * @param {number} value
 * @param {string} unit
 */
export function quantity(value, unit) {
  if (unit === "bytes") return `${round(value / 1000)} kB`;
  if (unit !== "ns") return `${value.toLocaleString("en-US")}`;
  if (value < 1000) return `${round(value)} ns`;
  if (value < 1e6) return `${round(value / 1000)} µs`;
  return value < 1e9 ? `${round(value / 1e6)} ms` : `${round(value / 1e9)} s`;
}

/** @param {number | null} ratio */
const times = (ratio) => (ratio === null ? "" : `${round(ratio)}×`);

/** @param {boolean | null} met */
const verdict = (met) => (met === null ? "" : met ? "yes" : "NO");

/**
 * A target as a bound of the ratio or of the value.
 *
 * @param {import("./targets.js").Target | null} target
 * @param {string} unit
 */
export function targetText(target, unit) {
  if (!target) return "";
  if (target.minRatio !== undefined) return `≥ ${target.minRatio}×`;
  return target.max === undefined ? "" : `≤ ${unit === "×" ? times(target.max) : quantity(target.max, unit)}`;
}

/**
 * The table of rows with and without a peer.
 *
 * @param {any[]} results
 */
export function comparisons(results) {
  const head = ["work", "peer", "peer's", "ours", "ratio", "target", "met?"];
  const lines = results.map(({ work, peer, unit, theirs, ours, ratio, spread, target, met }) => [
    work,
    peer ?? "",
    peer ? withUnit(theirs, unit, spread[0]) : "",
    withUnit(ours, unit, spread[1]),
    times(ratio),
    targetText(target, unit),
    verdict(met),
  ]);
  return aligned([head, ...lines], [false, false, true, true, true, true, false]);
}

/**
 * The exponent p of the cost per item as a power of the size, c·sizeᵖ, by least squares of the logarithms: 0 means that
 * the whole cost is in proportion to the number of items.
 *
 * @param {{ size: number, ns: number }[]} costs
 */
export function exponent(costs) {
  const mean = (/** @type {number[]} */ all) => all.reduce((sum, x) => sum + x, 0) / all.length;
  const [xs, ys] = [costs.map(({ size }) => Math.log(size)), costs.map(({ ns }) => Math.log(ns))];
  const [x0, y0] = [mean(xs), mean(ys)];
  return mean(xs.map((x, k) => (x - x0) * (ys[k] - y0))) / mean(xs.map((x) => (x - x0) ** 2));
}

/**
 * The table of costs per item at each size.
 *
 * @param {any[]} results
 */
export function growths(results) {
  const head = ["growth", "cost per item at each size", "exponent", "growth", "target", "met?"];
  const lines = results.map(({ work, costs, ours, target, met }) => [
    work,
    costs
      .map(
        (/** @type {{ size: number, ns: number }} */ { size, ns }) =>
          `${size.toLocaleString("en-US")}: ${quantity(ns, "ns")}`,
      )
      .join(", "),
    exponent(costs).toFixed(2),
    times(ours),
    targetText(target, "×"),
    verdict(met),
  ]);
  return aligned([head, ...lines], [false, false, true, true, true, false]);
}

/**
 * @param {string[][]} lines
 * @param {boolean[]} right whether a column is right-aligned
 */
function aligned(lines, right) {
  const widths = right.map((_, k) => Math.max(...lines.map((line) => line[k].length)));
  const cell = (/** @type {string} */ text, /** @type {number} */ k) =>
    right[k] ? text.padStart(widths[k]) : text.padEnd(widths[k]);
  return lines.map((line) => line.map(cell).join("  ").trimEnd()).join("\n");
}
