import { verdict } from "./utils/curves.js";
import { movedPoints } from "./utils/moved.js";

/** The centres of the shapes of the site's figure. @type {[number, number][]} */
const CENTERS = [
  [45, 32],
  [74, 32],
  [60, 57],
];

export const predict = {
  options: ["three", "four", "seven"],
  answer: 1,
  because: "Three faces lie in exactly one shape, and the face in the middle lies in all three. Three is odd, too.",
};

/** @param {string} key 1 and 0 for inside and outside of each shape */
const isOdd = (key) => [...key].filter((each) => each === "1").length % 2 === 1;
/** @param {{ inside: boolean[] }[]} faces */
const keysOf = (faces) => faces.map(({ inside }) => inside.map(Number).join(""));

/** @param {unknown} _figure @param {{ centers: [number, number][], chosen: ReadonlySet<string>, faces: { inside: boolean[] }[] }} element the site's figure of the faces */
export function check(_figure, { centers, chosen, faces }) {
  const moved = movedPoints(centers, CENTERS, (element) => (element.centers = CENTERS));
  if (moved) return moved;
  const keys = keysOf(faces);
  const wrong = keys.filter((key) => chosen.has(key) && !isOdd(key)).length;
  const missing = keys.filter((key) => !chosen.has(key) && isOdd(key)).length;
  const selected = keys.filter((key) => chosen.has(key)).length;
  if (wrong + missing === 0) return verdict(true, `${selected} faces: this is A ⊕ B ⊕ C.`);
  const parts = [missing && `${missing} missing`, wrong && `${wrong} too many`].filter(Boolean);
  return verdict(false, `${selected} selected: ${parts.join(", ")}.`);
}

/** @param {{ centers: [number, number][], chosen: ReadonlySet<string>, faces: { inside: boolean[] }[] }} element */
export const reveal = (element) => {
  element.centers = CENTERS;
  element.chosen = new Set(keysOf(element.faces).filter(isOdd));
};
