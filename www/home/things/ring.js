// The two shapes that are joined. The build draws the first picture with them.

/** Centre and the radii of the ring. */
export const RING = { centre: [126, 104], outer: 66, inner: 34 };
/** The leaf, about its middle. */
export const LEAF = "M-62 0C-30-58 30-58 62 0C30 58-30 58-62 0Z";
export const LEAF_AT = [206, 92];

/** @param {typeof import("casteljau").Path} Path the class */
export const ringOf = (Path) => {
  const { centre, outer, inner } = RING;
  return Path.circle(centre, outer).subtract(Path.circle(centre, inner));
};
