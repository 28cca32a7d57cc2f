import { verdict } from "./utils/surfaces.js";

const [FIRST, LAST] = [16, 19];

/** @param {{ patch: number | null }} figure */
export function check({ patch }) {
  if (patch === null) return verdict(false, "That went past the pot.");
  const done = patch >= FIRST && patch <= LAST;
  return verdict(
    done,
    done
      ? `Patch ${patch}. The spout has the numbers ${FIRST} to ${LAST}.`
      : `That is patch ${patch}, and not of the spout.`,
  );
}

/** @param {any} element */
export const reveal = (element) => {
  element.patch = FIRST;
};
