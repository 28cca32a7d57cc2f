import { verdict } from "./utils/curves.js";

const WANTED = 5;

/** @param {unknown} _figure @param {{ found: { kind: string }[] }} element the site's figure of two cubics */
export function check(_figure, { found }) {
  if (found.some(({ kind }) => kind === "overlap"))
    return verdict(false, "The curves share a piece. Move one of them.");
  return verdict(found.length >= WANTED, `${found.length} ${found.length === 1 ? "intersection" : "intersections"}.`);
}

/** x = T(y) and y = T(x) with the Chebyshev polynomial T of degree 3 have nine common points. @param {{ points: [number, number][] }} element */
export const reveal = (element) => {
  const [wave, even] = [
    [-1, 5, -5, 1],
    [-1, -1 / 3, 1 / 3, 1],
  ];
  const place = (/** @type {number} */ x, /** @type {number} */ y) =>
    /** @type {[number, number]} */ ([60 + 7 * x, 40 + 7 * y]);
  element.points = [...wave.map((x, i) => place(x, even[i])), ...wave.map((y, i) => place(even[i], y))];
};
