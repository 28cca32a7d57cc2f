// What is true at the joints, as it is told.
import { continuityOf } from "../elements/applet/report.js";
import { jointFacts } from "./descriptions.js";
import type { Figure } from "./figure.js";
import type { JointFacts } from "./descriptions.js";

/** The panel and the picture ask the same. */
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
