export const predict = {
  options: ["2", "2.5", "30"],
  answer: 0,
  because: "(B − A) × (C − A) = (0, −9, 12) and d = 0. The left side is −18 + 48 = 30, and √(81 + 144) = 15.",
};
