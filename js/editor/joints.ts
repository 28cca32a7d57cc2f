// The continuity at the joints, in words.
import { jointFacts } from "./descriptions.js";
import { continuityOf } from "./figure.js";
import { cached } from "./memo.js";
import type { Figure } from "./figure.js";
import type { JointFacts } from "./descriptions.js";

/** Made once for each figure: the panel and the picture ask for the same. */
export const jointsOf = cached((figure: Figure): JointFacts[] =>
  continuityOf(figure).map((continuity, k) => jointFacts(figure, k + 1, continuity)),
);

/** What is missing for more. */
export function shortWords({ verdict, angle, ratio }: JointFacts) {
  if (verdict === "C0") return `C0, ${angle}`;
  return verdict.startsWith("G") ? `${verdict}, ${ratio}` : verdict;
}
