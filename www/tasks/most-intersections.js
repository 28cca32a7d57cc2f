export const answer = {
  values: [6],
  hints: {
    3: "That many for a line and a cubic: 1 · 3.",
    5: "The degrees are multiplied, not added.",
    9: "That many for two cubics: 3 · 3.",
  },
  because: "The degrees are 2 and 3, and 2 · 3 = 6.",
};
