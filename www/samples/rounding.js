/** A number with 32 bits, as in a shader. */
const f32 = Math.fround;

/** De Casteljau's algorithm, each operation rounded to 32 bits. */
const byMeans = (values, t) => {
  const s = f32(1 - t);
  let row = values;
  while (row.length > 1) row = row.slice(1).map((b, i) => f32(f32(s * row[i]) + f32(t * b)));
  return row[0];
};

/** The coefficients of the powers of t: repeated differences times binomial coefficients. */
const powers = (values) => {
  const degree = values.length - 1;
  let row = values;
  let binomial = 1;
  return values.map((_, i) => {
    const coefficient = f32(f32(binomial) * row[0]);
    row = row.slice(1).map((b, k) => f32(b - row[k]));
    binomial = (binomial * (degree - i)) / (i + 1);
    return coefficient;
  });
};

const byPowers = (values, t) => powers(values).reduceRight((sum, c) => f32(f32(sum * t) + c));

export function sample(print) {
  // All control values lie between 0 and 1, so the result must, too.
  for (const degree of [3, 8, 16]) {
    const values = Array.from({ length: degree + 1 }, (_, i) => i % 2);
    const t = f32(0.9);
    const [a, b] = [byMeans(values, t), byPowers(values, t)];
    print(`degree ${degree}: means ${a.toFixed(5)}, powers ${b.toFixed(5)}`);
  }
}
