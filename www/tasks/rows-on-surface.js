export const predict = {
  options: ["all four", "two: the first and the last", "none"],
  answer: 1,
  because:
    "At v = 0 only row 0 has a weight, at v = 1 only row 3. For no v does row 1 or row 2 count alone: their greatest weight is 4/9, at a third of the way.",
};
