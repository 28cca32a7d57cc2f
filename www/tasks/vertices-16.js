export const predict = {
  options: ["32 · 16² = 8192", "32 · 17² = 9248", "8257, since sides are shared"],
  answer: 1,
  because:
    "Sixteen cells in a row have seventeen corners. Were the vertices of shared sides joined, and the points at the poles, 8257 would be left: 32 · 16² + 4 · 16 + 1.",
};
