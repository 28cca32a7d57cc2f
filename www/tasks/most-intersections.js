export const predict = {
  options: ["5", "6", "9"],
  answer: 1,
  because: "The degrees are 2 and 3, and 2 · 3 = 6. For two cubics it is 3 · 3 = 9.",
};
