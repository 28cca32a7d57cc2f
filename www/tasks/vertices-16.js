export const predict = {
  options: ["32 · 16² = 8192", "32 · 17² = 9248", "32 · 15² = 7200"],
  answer: 1,
  because:
    "A row of sixteen cells has seventeen vertices. If patches shared the vertices of common sides, there would be 8257: 32 · 16² + 4 · 16 + 1.",
};
