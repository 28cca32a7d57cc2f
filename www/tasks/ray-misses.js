export const predict = {
  options: [
    "It misses the patch: f is positive everywhere",
    "It may hit the patch: g has values of both signs",
    "It hits the patch: g has values of both signs",
  ],
  answer: 0,
  because:
    "Every value of f is a weighted mean of 3, 1, 2 and 5, so none is zero. One polynomial without a zero is enough: at a hit both are zero.",
};
