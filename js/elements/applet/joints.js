// What is true at the joints, as it is told.
import { continuityOf } from "./report.js";
import { jointFacts } from "./words.js";

/** @typedef {import("./figure.js").Figure} Figure */
/** @typedef {import("./words.js").JointFacts} JointFacts */

/** The panel and the picture ask the same. @type {WeakMap<Figure, JointFacts[]>} */
const known = new WeakMap();

/**
 * @param {Figure} figure
 * @returns {JointFacts[]}
 */
export function jointsOf(figure) {
  const facts = known.get(figure) ?? continuityOf(figure).map((continuity, k) => jointFacts(figure, k + 1, continuity));
  known.set(figure, facts);
  return facts;
}

/**
 * What is missing for more.
 *
 * @param {JointFacts} facts
 */
export function shortWords({ verdict, angle, ratio }) {
  if (verdict === "C0") return `C0, ${angle}`;
  return verdict.startsWith("G") ? `${verdict}, ${ratio}` : verdict;
}
