export const answer = {
  values: [68],
  hints: {
    128: "That is the number of all sides. A pair of shared sides is drawn once, and a collapsed side is not drawn.",
    120: "Without the collapsed sides, that is right. But a pair of shared sides is drawn once.",
    76: "A collapsed side is a point, so there is no wire.",
    52: "Sides that only one patch has are drawn as well.",
    16: "Shared sides are drawn as well, once for each pair.",
  },
  because:
    "128 − 52 − 8 = 68: each of the 52 pairs is drawn once instead of twice, and the 8 sides that are one point are not drawn.",
};
