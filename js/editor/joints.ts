// The continuity at the joints, in words.
import { jointFacts } from "./descriptions.js";
import { continuityOf } from "./figure.js";
import type { Figure } from "./figure.js";
import type { JointFacts } from "./descriptions.js";

/** Facts that are known already: the panel and the picture ask for the same. */
const known: WeakMap<Figure, JointFacts[]> = new WeakMap();

export function jointsOf(figure: Figure): JointFacts[] {
  const facts = known.get(figure) ?? continuityOf(figure).map((continuity, k) => jointFacts(figure, k + 1, continuity));
  known.set(figure, facts);
  return facts;
}

/** What is missing for more. */
export function shortWords({ verdict, angle, ratio }: JointFacts) {
  if (verdict === "C0") return `C0, ${angle}`;
  return verdict.startsWith("G") ? `${verdict}, ${ratio}` : verdict;
}
