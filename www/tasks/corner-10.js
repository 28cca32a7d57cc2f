import { formatNumber, verdict } from "./utils/surfaces.js";

export const predict = {
  options: ["P00, where row 0 begins", "P30, where row 0 ends", "P03, where row 3 begins", "P33, where row 3 ends"],
  answer: 1,
  because: "At u = 1 only the last point of each row has a weight, and at v = 0 only row 0 has. That leaves P30.",
};

/** @param {{ u: number, v: number }} figure */
export function check({ u, v }) {
  const done = u === 1 && v === 0;
  return verdict(
    done,
    done
      ? "S(1, 0) is the corner point P30."
      : `The mark is at u = ${formatNumber(u)}, v = ${formatNumber(v)}; move it to u = 1, v = 0.`,
  );
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { u: 1, v: 0 });
