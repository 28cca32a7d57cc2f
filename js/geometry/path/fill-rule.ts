import * as check from "../check.js";

/** The rule that decides which winding numbers are inside: all except 0, or the odd ones. */
export type FillRule = "nonzero" | "evenodd";

/** How a path is filled. */
export interface RegionOptions {
  /**
   * Which points a path contains: those with a winding number other than 0 ("nonzero", the default), or with an odd
   * one ("evenodd")
   */
  fillRule?: FillRule;
}

const FILL_RULES: readonly FillRule[] = ["nonzero", "evenodd"];

/**
 * The checked fill rule of options.
 *
 * @internal
 * @returns whether the rule is "evenodd"
 */
export function isEvenOdd(options: RegionOptions | undefined): boolean {
  const { fillRule = "nonzero" } = check.options(options, ["fillRule"]);
  check.oneOf(fillRule, "fillRule", FILL_RULES);
  return fillRule === "evenodd";
}
