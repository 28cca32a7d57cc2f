export const predict = {
  options: ["64, four times sixteen", "49, seven rows of seven", "25, five rows of five"],
  answer: 1,
  because:
    "Each row of four points becomes seven: two times four, of which one is shared. The same happens in the other direction.",
};
