export const answer = {
  values: [4, 11, 28],
  hints: {
    "4 7 10": "The first difference changes, too: it grows by the second difference.",
    "4 11 22": "The second difference changes, too: it grows by the third difference.",
    "8 21 44": "Add the first difference to the value before you change the first difference.",
    "4 8 14": "Add the first difference, not the second, to the value.",
  },
  because:
    "1 + 3 = 4. The first difference is now 3 + 4 = 7, so 4 + 7 = 11. The second difference is now 4 + 6 = 10, the first 7 + 10 = 17, and 11 + 17 = 28.",
};
