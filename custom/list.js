// The names that the command takes.
import { similarName } from "#js/geometry/options.js";

/** @typedef {import("./module.js").PublicName} PublicName */

/**
 * All names that a list may have, such as "Curve", "Curve.length" and "easing".
 *
 * @param {Record<string, PublicName>} names
 */
export const allNames = (names) =>
  Object.entries(names).flatMap(([name, { members = {} }]) => [
    name,
    ...Object.keys(members).map((member) => `${name}.${member}`),
  ]);

/**
 * The names that words stand for, each once: "Curve.*" is all members of a class.
 *
 * @param {Record<string, PublicName>} names
 * @param {readonly string[]} words
 * @param {readonly string[]} nurbs the classes of casteljau/nurbs
 * @throws {RangeError} for an unknown name, with the nearest known one
 */
export function checkedList(names, words, nurbs) {
  const known = allNames(names);
  const list = words.flatMap((word) => {
    const members = word.endsWith(".*") ? names[word.slice(0, -2)]?.members : undefined;
    if (members) return Object.keys(members).map((member) => word.slice(0, -1) + member);
    if (known.includes(word)) return [word];
    const [name] = word.split(".");
    if (nurbs.includes(name))
      throw new RangeError(
        `${word}: expected a name of casteljau, got one of casteljau/nurbs; import ${name} from there`,
      );
    const similar = similarTo(names, word);
    const hint = similar ? `; did you mean ${similar}?` : "";
    throw new RangeError(`${word}: expected a class, a function or a method such as Curve.length${hint}`);
  });
  return [...new Set(list)];
}

/** The name that was probably meant. @param {Record<string, PublicName>} names @param {string} word */
function similarTo(names, word) {
  const [name, member] = word.split(".");
  const members = names[name]?.members;
  if (members && member) {
    const similar = similarName(member, Object.keys(members), 0.4);
    return similar && `${name}.${similar}`;
  }
  const known = allNames(names);
  return known.find((each) => each.endsWith(`.${word}`)) ?? similarName(word, known, 0.4);
}
