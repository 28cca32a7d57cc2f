// Measures one row, or all rows of one file, in this process: run.js starts it once for each row, so that no row
// depends on what ran before it. Prints the results as JSON.
//
//   node benches/js/rows.js curve --list          the ids of the rows of curve.js
//   node benches/js/rows.js curve --id split      one row
//   node benches/js/rows.js curve --quick         all rows, each once
import { parseArgs } from "node:util";
import { growthRow } from "./growth.js";
import { compare, FULL, QUICK } from "./harness.js";

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { list: { type: "boolean" }, id: { type: "string", multiple: true }, quick: { type: "boolean" } },
});
const effort = values.quick ? QUICK : FULL;
const { rows, results } = await import(`./${positionals[0]}.js`);

/** @type {{ id: string }[]} */
const chosen = (rows ?? []).filter((/** @type {{ id: string }} */ { id }) => values.id?.includes(id) ?? true);

/** @param {any} row */
const measured = (row) => (row.steps ? growthRow(row, effort) : compare(row, effort));

const output = values.list ? chosen.map(({ id }) => id) : rows ? chosen.map(measured) : await results(effort);
process.stdout.write(JSON.stringify(output));
