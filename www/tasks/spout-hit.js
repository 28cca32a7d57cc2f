import { verdict } from "./utils/surfaces.js";

/** The numbers of the spout's patches. */
const [FIRST, LAST] = [16, 19];

/** @param {{ patch: number | null }} figure */
export function check({ patch }) {
  if (patch === null) return verdict(false, "The click missed the pot.");
  if (patch < FIRST || patch > LAST) return verdict(false, `Patch ${patch} does not belong to the spout.`);
  return verdict(
    patch === LAST,
    patch === LAST
      ? `Patch ${LAST}. The patches of the spout have the numbers ${FIRST} to ${LAST}.`
      : `Patch ${patch} belongs to the spout, but the spout has a patch with a larger number.`,
  );
}

/** @param {any} element */
export const reveal = (element) => void Object.assign(element, { patch: LAST });
