export const predict = {
  options: [
    "Sort the sum so that the small terms come first",
    "Use de Casteljau's algorithm or the weights",
    "Use smaller steps of t",
  ],
  answer: 1,
  because:
    "The powers lose their digits when large terms of opposite sign nearly cancel, whatever the order. De Casteljau's algorithm and the weights only compute means, where nothing cancels.",
};
