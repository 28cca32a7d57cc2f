// Which point was there before?

/** 2³² over the golden ratio, odd: a multiplier that spreads neighbours (Knuth, TAOCP 3, §6.4). */
const SPREAD = 0x9e3779b1;

/**
 * A hash table of points with open addressing, at most half full. The seed differs from run to run, so that no text can
 * be made to collide.
 *
 * @internal
 * @param {number[]} vertices the numbers of the distinct points so far
 * @returns {() => number} takes the point that was pushed last: its number if it is new, else it is taken away again
 *   and the number is that of its equal
 */
export function vertexTable(vertices) {
  const numbers = new Float64Array(3);
  const words = new Uint32Array(numbers.buffer);
  const seed = Math.floor(Math.random() * 2 ** 32);
  let slots = new Int32Array(1 << 10).fill(-1);

  /** The slot of a point that is in the table, or the free one where it belongs. */
  const find = (/** @type {number} */ at) => {
    const [x, y, z] = [vertices[at], vertices[at + 1], vertices[at + 2]];
    // −0 + 0 is 0: the same place.
    numbers[0] = x + 0;
    numbers[1] = y + 0;
    numbers[2] = z + 0;
    let hash = seed;
    for (let i = 0; i < 6; i++) {
      hash = Math.imul(hash ^ words[i], SPREAD);
      hash ^= hash >>> 15;
    }
    for (let slot = hash & (slots.length - 1); ; slot = (slot + 1) & (slots.length - 1)) {
      const other = 3 * slots[slot];
      if (other < 0 || (vertices[other] === x && vertices[other + 1] === y && vertices[other + 2] === z)) return slot;
    }
  };

  const grow = (/** @type {number} */ count) => {
    slots = new Int32Array(2 * slots.length).fill(-1);
    for (let k = 0; k < count; k++) slots[find(3 * k)] = k;
  };

  return () => {
    const index = vertices.length / 3 - 1;
    const slot = find(3 * index);
    if (slots[slot] >= 0) {
      vertices.length -= 3;
      return slots[slot];
    }
    slots[slot] = index;
    if (2 * index >= slots.length) grow(index + 1);
    return index;
  };
}
