export const predict = {
  options: ["4, 8, 14", "4, 11, 28", "4, 7, 10"],
  answer: 1,
  because:
    "1 + 3 = 4. The first difference becomes 3 + 4 = 7, so 4 + 7 = 11. The second difference has become 4 + 6 = 10, the first 7 + 10 = 17, and 11 + 17 = 28.",
};
