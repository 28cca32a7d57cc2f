export const answer = {
  values: [2],
  hints: {
    30: "That is the value of the left side. Divide it by the length of (a, b, c).",
    66: "Check the sign of b: (B − A) × (C − A) = (0, −9, 12).",
    3.6: "Check the length of (a, b, c): it is √(81 + 144).",
    2.5: "Compute (B − A) × (C − A) again: it is (0, −9, 12).",
    4: "That is only the height of the point. The plane is inclined.",
  },
  because: "(B − A) × (C − A) = (0, −9, 12) and d = 0. The left side is −18 + 48 = 30, and 30 / √(81 + 144) = 2.",
};
