export const answer = {
  values: [9248],
  hints: {
    8192: "A row of sixteen cells has more than sixteen vertices.",
    8257: "That many if patches shared the vertices of common sides. Here each patch has its own.",
    7200: "A row of sixteen cells has one vertex more than cells, not one less.",
    289: "That many for one patch.",
  },
  because:
    "A row of sixteen cells has seventeen vertices: 32 · 17² = 9248. If patches shared the vertices of common sides, there would be 8257: 32 · 16² + 4 · 16 + 1.",
};
