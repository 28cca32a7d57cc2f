export const predict = {
  options: ["128 − 8 = 120", "128 − 52 − 8 = 68", "128 − 2 · 52 − 8 = 16"],
  answer: 1,
  because: "Each of the 52 pairs is drawn once instead of twice, and a side that is one point is not drawn.",
};
