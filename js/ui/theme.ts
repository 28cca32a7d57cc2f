// The colours of the picture, as the style sheet has them now: light, dark or forced.

/** The roles of colour. Each has a custom property `--bz-<role>` in style.js. */
export const ROLES = ["ink", "quiet", "paper", "curve", "handle", "first", "second", "level1", "level2"] as const;

export type Role = (typeof ROLES)[number];
export type Theme = Record<Role, string>;

/**
 * Reads colours off a probe element, which resolves variables and system colours alike.
 *
 * @param roles each has a custom property `--bz-<role>`
 */
export function readTheme<R extends string = Role>(
  probe: HTMLElement,
  roles: readonly R[] = ROLES as readonly any[],
): Record<R, string> {
  const style = getComputedStyle(probe);
  const read = (role: R) => {
    probe.style.color = `var(--bz-${role})`;
    return [role, style.color];
  };
  return Object.fromEntries(roles.map(read));
}

/** When these change, so do the colours; paper is white. */
const COLOUR_QUERIES = ["(prefers-color-scheme: dark)", "(forced-colors: active)", "print"];

/**
 * @returns ends it
 */
export function followColours(changed: () => void): () => void {
  const queries = COLOUR_QUERIES.map((query) => matchMedia(query));
  for (const query of queries) query.addEventListener("change", changed);
  return () => queries.forEach((query) => query.removeEventListener("change", changed));
}

/**
 * @returns ends it
 */
export function followTheme<R extends string = Role>(
  probe: HTMLElement,
  changed: (theme: Record<R, string>) => void,
  roles?: readonly R[],
): () => void {
  return followColours(() => changed(readTheme(probe, roles)));
}
