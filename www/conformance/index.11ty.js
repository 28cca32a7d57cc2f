// /conformance/: the golden facts of the tests, asked in the reader's browser (main.js). The facts are written here; the answers are not.
import { escapeHtml } from "../build/highlight.js";
import { scrollable } from "../build/tables.js";
import { textOf } from "./answers.js";
import { issueOf, KINDS, readFacts } from "./facts.js";
import { CLOSE } from "./judge.js";
import { LIBRARIES } from "./libraries.js";
import { packageOf } from "./packages.js";

/** @typedef {import("./facts.js").Fact} Fact */

const GRADES = ["right", "close", "wrong", "not offered"];
/** An input is longer than an answer. */
const MAX_INPUT = 200;

export const data = {
  permalink: "/conformance/index.html",
  title: "Conformance: right and wrong answers of libraries for Bézier curves · casteljau",
  description:
    "Facts about Bézier curves with known answers, asked in your browser: casteljau, bezier-js, paper.js, svg-path-properties and verb side by side, with the issue in which each fact was found.",
  heading: "Conformance",
  lead: "Questions about curves whose answers are known, many of them from issues of other projects. Your browser asks casteljau now, and four other libraries when you want it.",
  bodyClass: "wide",
  styles: ["conformance.css"],
  script: "main.js",
};

export function render() {
  const facts = readFacts();
  const kinds = Object.keys(KINDS).filter((kind) => facts.some((fact) => fact.kind === kind));
  const own = facts.filter(({ kind }) => kind.includes("rational"));
  return `
<section id="results">
<h2>Results</h2>
${totals()}
<p id="status" role="status">The answers need JavaScript.</p>
</section>
<section id="judged">
<h2>How answers are judged</h2>
<p>There are ${facts.length} facts, ${own.length} of them about rational curves. They are the <em>golden data</em> with which casteljau is tested: closed forms, or numbers that were computed with 50 digits. None is an answer of one of these libraries. They were chosen for the tests of casteljau, which passes them; so they say where the others differ, and not how often.</p>
<ul>
<li><b>Right</b>: all numbers of the answer are within the tolerance of the fact, which stands beside it.</li>
<li><b>Close</b>: they are not, but each is right to ${textOf(CLOSE)} (relative, if it is greater than 1). For many programs that is enough.</li>
<li><b>Wrong</b>: a number is farther off, or there are too many or too few, or the call throws.</li>
<li><b>Not offered</b>: the library does not claim to answer this. That is no fault.</li>
</ul>
<p>Of an offset curve and of a polyline, the distance from the curve is measured, and not the points themselves. Where a library takes a tolerance, it gets a small one.</p>
<dl>
${LIBRARIES.map(({ name, claims }) => `<dt>${name}</dt><dd>${claims}</dd>`).join("\n")}
</dl>
<p>The page contains the other libraries with <a href="licenses.txt">their licences</a>.</p>
</section>
<section id="facts">
<h2>Facts</h2>
${kinds
  .map((kind) =>
    kindHtml(
      kind,
      facts.filter((fact) => fact.kind === kind),
    ),
  )
  .join("\n")}
</section>
<script type="application/json" id="facts-data">${JSON.stringify(facts).replaceAll("<", "\\u003c")}</script>`;
}

function totals() {
  const rows = LIBRARIES.map(({ name, packageName }) => {
    const { version } = packageOf(packageName);
    const cells = GRADES.map((grade) => `<td data-grade="${grade}"></td>`).join("");
    return `<tr data-library="${name}"><th scope="row">${name} <small>${version}</small></th>${cells}</tr>`;
  });
  const head = GRADES.map((grade) => `<th scope="col">${grade[0].toUpperCase()}${grade.slice(1)}</th>`).join("");
  const table = `<table class="numbers" id="totals"><thead><tr><th scope="col">Library</th>${head}</tr></thead><tbody>${rows.join("")}</tbody></table>`;
  return scrollable(table, "Numbers of right and wrong answers");
}

/** @param {string} kind @param {Fact[]} facts */
function kindHtml(kind, facts) {
  const head = ["Fact", "Answer", ...LIBRARIES.map(({ name }) => name)]
    .map((name) => `<th scope="col">${name}</th>`)
    .join("");
  const table = `<table class="facts"><thead><tr>${head}</tr></thead><tbody>${facts.map(factHtml).join("\n")}</tbody></table>`;
  const count = `${facts.length} ${facts.length === 1 ? "fact" : "facts"}`;
  return `<details data-kind="${kind}"><summary><b>${KINDS[kind]}</b> <small>${count}</small> <span class="counts"></span></summary>
${scrollable(table, KINDS[kind])}</details>`;
}

/** @param {Fact} fact */
function factHtml(fact) {
  const issue = issueOf(fact.source);
  const source = escapeHtml(fact.source);
  const note = fact.note ? `<br><small>${escapeHtml(fact.note)}</small>` : "";
  const cells = LIBRARIES.map(({ name }) => `<td data-library="${name}"></td>`).join("");
  return `<tr data-fact="${fact.id}"><th scope="row">${issue ? `<a href="${issue}">${source}</a>` : source}<br><small>${escapeHtml(textOf(fact.input, MAX_INPUT))}</small>${note}</th><td>${escapeHtml(expectedText(fact))}</td>${cells}</tr>`;
}

/** What is expected, with the tolerance. @param {Fact} fact */
function expectedText({ kind, expect, tol, input }) {
  const within = tol === 0 ? ", exactly" : ` ± ${textOf(Number(tol.toPrecision(2)))}`;
  if (kind === "flatten") return `at most ${input.tolerance} from the curve${within}`;
  if (kind === "offset" && !expect.ends) return `at most ${textOf(Math.abs(input.distance))} from the curve${within}`;
  if (kind === "intersect" && expect.count === undefined && !expect.overlap)
    return "no point, or one: the curves come closer than rounding";
  if (kind === "classify") return expect.class;
  if (expect.overlap) return "the curves share a piece";
  return `${textOf(expect, MAX_INPUT)}${within}`;
}
