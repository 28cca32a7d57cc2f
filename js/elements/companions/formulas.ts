// Pieces of formulas, in MathML.
import { mathml, nothing } from "lit";
import { shown, shownFraction } from "../../ui/numbers.js";
import { binomial } from "./weights.js";

/** Binomial coefficients of higher degrees are not written out. */
const MAX_WRITTEN = 12;

export const number = (x: number, decimals = 3) => mathml`<mn>${shown(x, decimals)}</mn>`;
/** A factor: in brackets where it is negative. */
export const factor = (x: number) => (x < 0 ? mathml`<mrow><mo>(</mo>${number(x)}<mo>)</mo></mrow>` : number(x));
export const sign = (sign: string) => mathml`<mo>${sign}</mo>`;
export const point = (t: number) => mathml`<mrow><mi>B</mi><mo>(</mo>${number(t)}<mo>)</mo></mrow>`;
export const symbol = mathml`<mrow><mi>B</mi><mo>(</mo><mi>t</mi><mo>)</mo></mrow>`;

/** The name of a point: letters, and digits as an index; a difference in brackets. */
export function name(text: string): unknown {
  if (text.includes("−")) {
    const [to, from] = text.split("−");
    return mathml`<mrow><mo>(</mo>${name(to)}<mo>−</mo>${name(from)}<mo>)</mo></mrow>`;
  }
  const [, letters, digits] = text.match(/^(\D+)(\d+)$/) ?? [];
  return letters ? mathml`<msub><mi>${letters}</mi><mn>${digits}</mn></msub>` : mathml`<mi>${text}</mi>`;
}

function power(base: unknown, exponent: number) {
  if (exponent === 0) return nothing;
  return exponent === 1 ? base : mathml`<msup>${base}<mn>${exponent}</mn></msup>`;
}

/** C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ. */
export function bernsteinTerm(n: number, i: number) {
  const rest = mathml`<mrow><mo>(</mo><mn>1</mn><mo>−</mo><mi>t</mi><mo>)</mo></mrow>`;
  const written = mathml`<mn>${binomial(n, i)}</mn>`;
  const choose = mathml`<mrow><mo>(</mo><mfrac linethickness="0"><mn>${n}</mn><mn>${i}</mn></mfrac><mo>)</mo></mrow>`;
  const count = i === 0 || i === n ? nothing : n > MAX_WRITTEN ? choose : written;
  return mathml`<mrow>${count}${power(rest, n - i)}${power(mathml`<mi>t</mi>`, i)}</mrow>`;
}

/**
 * A polynomial of t, in brackets where it has several terms; a common divisor of 2, 3 or 6 stands before it.
 *
 * @param coefficients the highest power first
 */
export function polynomial(coefficients: number[]) {
  const divisor = [1, 2, 3, 6].find((d) => coefficients.every((c) => Math.abs(c * d - Math.round(c * d)) < 1e-12)) ?? 1;
  const terms = coefficients
    .map((c, k) => ({ factor: c * divisor, exponent: coefficients.length - 1 - k }))
    .filter(({ factor }) => factor !== 0);
  const written = terms.map(({ factor, exponent }, k) => {
    const size = Math.abs(factor);
    const before = k > 0 ? sign(factor < 0 ? "−" : "+") : factor < 0 ? mathml`<mo form="prefix">−</mo>` : nothing;
    return mathml`${before}${size === 1 && exponent > 0 ? nothing : number(size)}${power(mathml`<mi>t</mi>`, exponent)}`;
  });
  const fraction = divisor > 1 ? mathml`<mfrac><mn>1</mn><mn>${divisor}</mn></mfrac>` : nothing;
  const [open, close] = terms.length > 1 ? [sign("("), sign(")")] : [nothing, nothing];
  return mathml`<mrow>${fraction}${open}${terms.length ? written : number(0)}${close}</mrow>`;
}

/** Rows in square brackets, which are drawn by the style sheet: few fonts have brackets of every height. */
export function matrix(rows: unknown[][]) {
  const cells = (row: unknown[]) => mathml`<mtr>${row.map((cell) => mathml`<mtd>${cell}</mtd>`)}</mtr>`;
  return mathml`<mtable class="matrix">${rows.map(cells)}</mtable>`;
}

/**
 * A square matrix by its numbers.
 *
 * @param numbers row by row
 */
export function square(numbers: number[]) {
  const size = Math.sqrt(numbers.length);
  return matrix(
    Array.from({ length: size }, (_, row) =>
      numbers.slice(row * size, (row + 1) * size).map((x) => mathml`<mn>${shownFraction(x)}</mn>`),
    ),
  );
}

/** tⁿ … t 1. */
export function powers(degree: number) {
  return matrix([
    Array.from({ length: degree + 1 }, (_, k) =>
      k === degree ? mathml`<mn>1</mn>` : power(mathml`<mi>t</mi>`, degree - k),
    ),
  ]);
}

/** (x, y). */
export function pair(place: ArrayLike<number>) {
  return mathml`<mrow><mo>(</mo>${number(place[0])}<mo>,</mo>${number(place[1])}<mo>)</mo></mrow>`;
}
