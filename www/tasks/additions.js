export const predict = {
  options: ["3 · 3 · 64 = 576", "3 · 64 = 192", "64² = 4096"],
  answer: 0,
  because:
    "Three differences, three coordinates, sixty-four steps. By the weights each point takes twelve multiplications and nine additions, and the weights themselves.",
};
