export function sample(print) {
  const cubic = (t) => 3 * t * (1 - t) ** 2 + 6 * t ** 2 * (1 - t); // heights 0, 1, 2, 0
  const n = 8;
  // The first four values give the first value and its differences.
  let [f, d1, d2, d3] = differences([0, 1, 2, 3].map((i) => cubic(i / n)));
  for (let i = 0; i <= n; i++) {
    print(`${i}: ${f.toFixed(6)} ${cubic(i / n).toFixed(6)}`);
    [f, d1, d2] = [f + d1, d1 + d2, d2 + d3]; // three additions a step
  }
}

function differences([a, b, c, d]) {
  return [a, b - a, c - 2 * b + a, d - 3 * c + 3 * b - a];
}
