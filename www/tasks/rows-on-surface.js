export const predict = {
  options: ["all four", "two: the first and the last", "none"],
  answer: 1,
  because:
    "At v = 0 only row 0 has a weight, at v = 1 only row 3. Rows 1 and 2 never have all the weight: their largest weight is 4/9, at v = 1/3 and v = 2/3.",
};
