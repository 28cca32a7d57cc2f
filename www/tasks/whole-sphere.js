export const predict = {
  options: ["25", "45", "54"],
  answer: 1,
  because:
    "The profile of a whole sphere is half a circle: two quarters, which share a point, so 5 points. A full turn has four quarters with 9 points. 5 · 9 = 45. Two rows lie at the poles: their 9 points are one point each.",
};
