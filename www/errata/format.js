// Numbers in the sentences of the proofs.

/** @param {number} x @param {number} [digits] */
export const rounded = (x, digits = 3) => String(Number(x.toFixed(digits)) || 0).replace("-", "−");

/** @param {Iterable<number>} xs @param {number} [digits] */
export const listed = (xs, digits = 3) => Array.from(xs, (x) => rounded(x, digits)).join(", ");
