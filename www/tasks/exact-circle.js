export const predict = {
  options: ["A polynomial Bézier curve of high degree", "A NURBS curve", "A B-spline curve without weights"],
  answer: 1,
  because:
    "On a circle x² + y² = 1. No polynomials x(t) and y(t) satisfy this except constants. With weights, x and y are fractions of polynomials, and they can.",
};
