// Numbers as people write them.

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const SUBSCRIPTS = "₀₁₂₃₄₅₆₇₈₉";

/** @param {string} text */
const withMinus = (text) => text.replaceAll("-", "−");

/**
 * So many digits after the point; a true minus, and no minus before zero.
 *
 * @param {number} value
 * @param {number} [digits]
 * @returns {string}
 */
export function decimal(value, digits = 2) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : withMinus(text);
}

/**
 * The same without zeros at the end.
 *
 * @param {number} value
 * @param {number} [digits]
 */
export const short = (value, digits = 2) => withMinus(String(Number(value.toFixed(digits)) + 0));

/**
 * 1,234,567.
 *
 * @param {number} value
 */
export const grouped = (value) => String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, ",");

/**
 * 1.2 × 10⁻⁷.
 *
 * @param {number} value
 * @param {number} [digits]
 */
export function scientific(value, digits = 1) {
  if (value === 0) return "0";
  const [mantissa, exponent] = value.toExponential(digits).split("e");
  return `${withMinus(mantissa)} × 10${superscript(Number(exponent))}`;
}

/**
 * @param {number} whole
 */
export const superscript = (whole) =>
  (whole < 0 ? "⁻" : "") + [...String(Math.abs(whole))].map((digit) => SUPERSCRIPTS[Number(digit)]).join("");

/**
 * @param {number} whole
 */
export const subscript = (whole) => [...String(whole)].map((digit) => SUBSCRIPTS[Number(digit)]).join("");

/**
 * (1, 2, 3).
 *
 * @param {ArrayLike<number>} numbers
 * @param {number} [digits]
 */
export const tuple = (numbers, digits = 2) => `(${Array.from(numbers, (number) => short(number, digits)).join(", ")})`;
