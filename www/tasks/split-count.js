export const answer = {
  values: [49],
  hints: {
    64: "That is four times sixteen, but neighbouring parts share points.",
    56: "The first split gives 7 points in each of four rows, 28. The second one works on columns of four points, and its two parts share a row.",
    25: "A row of four points becomes two rows of four points with one in common: that is more than five.",
    16: "Splitting adds points: each part has a net of its own.",
  },
  because:
    "Each row of four points becomes seven: two times four, of which one is shared. The same happens in the other direction, and 7 · 7 = 49.",
};
