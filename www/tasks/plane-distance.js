export const predict = {
  options: ["2", "2/√3 ≈ 1.155", "√3 ≈ 1.732"],
  answer: 1,
  because: "The left side of the equation is 1 + 1 + 1 − 1 = 2, and (a, b, c) = (1, 1, 1) has the length √3.",
};
