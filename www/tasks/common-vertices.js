export const predict = {
  options: ["6 segments", "7 segments", "12 segments"],
  answer: 0,
  because:
    "The vertices inside the side are at 1/4, 1/2 and 3/4 and at 1/3 and 2/3. That is five vertices, so there are six segments.",
};
