// Formulas as plain text, for the search: B(t) = (1 − t)² P₀.

/** Operators with a space on both sides. */
const SPACED = /^[=≠<>≤≥≈+−±·×∪∩⊕→∈]$/;
const SUBSCRIPTS = "₀₁₂₃₄₅₆₇₈₉";
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** A script as digits that are raised or lowered, or with a sign before it. @param {string} text @param {string} digits @param {string} sign */
const script = (text, digits, sign) =>
  /^\d+$/.test(text)
    ? text.replace(/\d/g, (digit) => digits[Number(digit)])
    : /^′+$/.test(text)
      ? text
      : sign + grouped(text);

/** More than one symbol is put into brackets. @param {string} text */
const grouped = (text) => (/^[\p{L}\p{N}₀-₉]*$/u.test(text) ? text : `(${text})`);

/** @type {Record<string, (children: string[]) => string>} */
const RULES = {
  msub: ([base, low]) => base + script(low, SUBSCRIPTS, "_"),
  msup: ([base, high]) => base + script(high, SUPERSCRIPTS, "^"),
  msubsup: ([base, low, high]) => base + script(low, SUBSCRIPTS, "_") + script(high, SUPERSCRIPTS, "^"),
  munderover: ([base, low, high]) => base + script(low, SUBSCRIPTS, "_") + script(high, SUPERSCRIPTS, "^"),
  mfrac: ([over, under]) => `${grouped(over)}/${grouped(under)}`,
  msqrt: (children) => `√${grouped(row(children))}`,
  mspace: () => " ",
};

/** @param {string[]} children */
const row = (children) => children.map((child, i) => (i > 0 && SPACED.test(child) ? ` ${child} ` : child)).join("");

/**
 * The text of a formula.
 *
 * @param {string} mathml
 */
export function mathText(mathml) {
  /** @type {{ name: string, children: string[] }[]} */
  const open = [{ name: "", children: [] }];
  for (const [, end, name, alone, text] of mathml.matchAll(/<(\/?)(\w+)[^>]*?(\/?)>|([^<]+)/g)) {
    if (text !== undefined) open.at(-1)?.children.push(text.trim());
    else if (!end) open.push({ name, children: [] });
    if (name && (end || alone)) {
      const { children, name } = /** @type {{ name: string, children: string[] }} */ (open.pop());
      open.at(-1)?.children.push((RULES[name] ?? row)(children));
    }
  }
  return row(open[0].children);
}
