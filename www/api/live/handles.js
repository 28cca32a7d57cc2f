// The points of a figure that can be dragged.

/**
 * @typedef {{ input: string, index: number | undefined, label: string, point: number[] }} Handle
 *   index: the position in a list of points
 */

/**
 * @param {{ name: string, kind: string }[]} inputs
 * @param {Record<string, any>} values
 * @returns {Handle[]}
 */
export function handlesOf(inputs, values) {
  return inputs.flatMap(({ name, kind }) => {
    if (kind === "point") return [{ input: name, index: undefined, label: name, point: values[name] }];
    if (kind !== "points") return [];
    return values[name].map((/** @type {number[]} */ point, /** @type {number} */ index) => ({
      input: name,
      index,
      label: name === "points" ? `P${index}` : String(index),
      point,
    }));
  });
}
