// /conformance/: asks casteljau all facts in this browser, and the other libraries when the reader wants it.
import "../parts/contents.js";
import { button } from "../parts/dom.js";
import { shortNumber } from "./answers.js";

/** @typedef {import("./worker.js").Reply} Reply */
/** @typedef {import("./judge.js").Grade} Grade */

/** @type {Record<Grade, string>} */
const MARKS = { right: "✓", close: "≈", wrong: "✗", "not offered": "" };
const OURS = "casteljau";

/** @type {import("./facts.js").Fact[]} */
const facts = JSON.parse(document.getElementById("facts-data")?.textContent ?? "[]");
const kindOf = new Map(facts.map(({ id, kind }) => [id, kind]));
const rows = /** @type {HTMLTableRowElement[]} */ ([...document.querySelectorAll("#totals tbody tr")]);
const libraries = rows.map(({ dataset }) => dataset.library ?? "");
const status = /** @type {HTMLElement} */ (document.getElementById("status"));

/** How often each library has which grade, in all and by kind. @type {Map<string, Map<string, Record<Grade, number>>>} */
const counts = new Map();

/** @param {string} library @param {string} kind "" for all @returns {Record<Grade, number>} */
function countOf(library, kind) {
  const byKind = counts.get(library) ?? new Map();
  counts.set(library, byKind);
  if (!byKind.has(kind)) byKind.set(kind, { right: 0, close: 0, wrong: 0, "not offered": 0 });
  return byKind.get(kind);
}

/** @param {string} library @param {Reply} reply */
function show(library, { id, grade, off, text }) {
  const kind = kindOf.get(id) ?? "";
  for (const each of ["", kind]) countOf(library, each)[grade] += 1;
  const cell = document.querySelector(`[data-fact="${CSS.escape(id)}"] [data-library="${library}"]`);
  if (!cell) return;
  const mark = Object.assign(document.createElement("b"), { textContent: `${MARKS[grade]} ${grade}`.trim() });
  cell.className = grade.replace(" ", "-");
  const difference = Number.isFinite(off) && off > 0 && grade !== "right" ? `, off by ${shortNumber(off)}` : "";
  cell.replaceChildren(mark, difference, document.createElement("br"), text);
}

/** Shows the numbers of a library in the table at the top, and in the headings of the kinds. @param {string} library */
function showCounts(library) {
  const row = rows.find(({ dataset }) => dataset.library === library);
  for (const [grade, count] of Object.entries(countOf(library, "")))
    for (const cell of row?.querySelectorAll(`[data-grade="${grade}"]`) ?? []) cell.textContent = String(count);
  for (const kind of new Set(kindOf.values())) {
    const place = document.querySelector(`[data-kind="${kind}"] .counts`);
    const texts = libraries
      .map((name) => ({ name, count: countOf(name, kind) }))
      .map(({ name, count: { right, close, wrong } }) => ({ name, right, asked: right + close + wrong }))
      .filter(({ asked }) => asked > 0)
      .map(({ name, right, asked }) => `${name} ${right} of ${asked}`);
    if (place) place.textContent = texts.length > 0 ? `right: ${texts.join(", ")}` : "";
  }
}

/** Asks a library. @param {string} library @returns {Promise<void>} */
function ask(library) {
  const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
  return new Promise((resolve, reject) => {
    worker.addEventListener("message", ({ data }) => {
      if (!("end" in data)) return show(library, data);
      worker.terminate();
      showCounts(library);
      if (data.end === null) resolve();
      else reject(new Error(data.end));
    });
    worker.addEventListener("error", (event) => reject(new Error(event.message || `${library} could not be loaded`)));
    worker.postMessage({ library, facts });
  });
}

/** @param {string[]} names */
async function askAll(names) {
  try {
    for (const name of names) {
      status.textContent = `Asking ${name} …`;
      await ask(name);
    }
    status.textContent = `Asked: ${names.join(", ")}.`;
    document.documentElement.dataset.asked = names.includes(OURS) ? OURS : "all";
  } catch (error) {
    status.textContent = error instanceof Error ? error.message : String(error);
  }
}

const others = button(
  "Ask the other libraries, too",
  async () => {
    others.disabled = true;
    await askAll(libraries.filter((name) => name !== OURS));
  },
  "button primary",
);
others.disabled = true;
status.before(others);
await askAll([OURS]);
others.disabled = false;
