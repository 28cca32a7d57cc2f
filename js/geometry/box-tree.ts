/** How many neighbours have a common box on the next level. */
const FANOUT = 8;

/**
 * A tree of boxes of neighbours, which finds items by their place. A box is its smallest and then its largest coordinates.
 *
 * @internal
 */
export class BoxTree {
  #dimension;
  #count;
  /** The numbers of the items in the order of the lowest level; without it they are in that order. */
  #order: Uint32Array | undefined;
  /** The boxes of each level, from those of the items up to one for all. */
  #levels: Float64Array[] = [];

  /**
   * @param boxes those of the items; neighbours in the list should be neighbours in space
   * @param order the number of each item; without it, its place in the list
   */
  constructor(dimension: 2 | 3, boxes: Float64Array, order?: Uint32Array) {
    const size = 2 * dimension;
    this.#dimension = dimension;
    this.#count = boxes.length / size;
    this.#order = order;
    this.#levels.push(boxes);
    while (boxes.length > size) {
      const count = Math.ceil(boxes.length / (size * FANOUT));
      const next = new Float64Array(size * count);
      for (let k = 0; k < count; k++) {
        const [from, to] = [size * FANOUT * k, Math.min(size * FANOUT * (k + 1), boxes.length)];
        writeBox(next, size * k, dimension, boxes, from, to);
      }
      this.#levels.push(next);
      boxes = next;
    }
  }

  /**
   * A tree of boxes in the plane that may be in any order: the centres are sorted by the interleaved bits of their ranks
   * on both axes, so that neither a far item nor a crowd of items spoils the order of the others.
   *
   * Source: Morton, "A computer oriented geodetic data base" (IBM, 1966), for the order.
   */
  static ofPlane(boxes: Float64Array): BoxTree {
    const count = boxes.length / 4;
    const [columns, rows] = [0, 1].map((axis) =>
      ranks(Float64Array.from({ length: count }, (_, k) => boxes[4 * k + axis] / 2 + boxes[4 * k + axis + 2] / 2)),
    );
    const cell = (rank: number) => spread(Math.floor((rank * 0x10000) / count));
    const keys = Float64Array.from({ length: count }, (_, k) => cell(columns[k]) + 2 * cell(rows[k]));
    const order = sorted(keys);
    const inOrder = new Float64Array(boxes.length);
    order.forEach((item, k) => inOrder.set(boxes.subarray(4 * item, 4 * item + 4), 4 * k));
    return new BoxTree(2, inOrder, order);
  }

  /**
   * Examines the items whose boxes are within a distance of a point, those with the nearest boxes first.
   *
   * @param examine gets an item and returns the distance from which on others are of no interest, at most the one so far
   */
  nearest(p: Float64Array, limit: number, examine: (item: number) => number): void {
    const search = (level: number, k: number) => {
      if (level === 0) {
        limit = examine(this.#order?.[k] ?? k);
        return;
      }
      const from = FANOUT * k;
      const to = Math.min(from + FANOUT, this.#levels[level - 1].length / (2 * this.#dimension));
      const distances: number[] = [];
      for (let child = from; child < to; child++) distances.push(this.#distance(level - 1, child, p));
      for (;;) {
        let next = 0;
        for (let i = 1; i < distances.length; i++) if (distances[i] < distances[next]) next = i;
        if (!(distances[next] <= limit) || distances[next] === Infinity) return;
        distances[next] = Infinity;
        search(level - 1, from + next);
      }
    };
    const top = this.#levels.length - 1;
    if (this.#count > 0 && this.#distance(top, 0, p) <= limit) search(top, 0);
  }

  /**
   * Walks down the tree.
   *
   * @param enter gets the boxes of a level, the index of one of them, and the range of the items in it; returns whether to
   *   go on with its parts
   */
  descend(enter: (boxes: Float64Array, at: number, from: number, to: number) => boolean): void {
    const visit = (level: number, k: number, items: number) => {
      const to = Math.min(items * (k + 1), this.#count);
      if (!enter(this.#levels[level], 2 * this.#dimension * k, items * k, to) || level === 0) return;
      const end = Math.ceil((to * FANOUT) / items);
      for (let child = FANOUT * k; child < end; child++) visit(level - 1, child, items / FANOUT);
    };
    const top = this.#levels.length - 1;
    if (this.#count > 0) visit(top, 0, FANOUT ** top);
  }

  /** Calls `act` for each item whose box contains a point of the plane, its border included. */
  around(x: number, y: number, act: (item: number) => void): void {
    this.overlapping(x, y, x, y, act);
  }

  /** Calls `act` for each item whose box has a point in common with a box of the plane. */
  overlapping(minX: number, minY: number, maxX: number, maxY: number, act: (item: number) => void): void {
    this.descend((boxes, at, from, to) => {
      if (boxes[at] > maxX || boxes[at + 2] < minX || boxes[at + 1] > maxY || boxes[at + 3] < minY) return false;
      if (to - from > 1) return true;
      act(this.#order?.[from] ?? from);
      return false;
    });
  }

  #distance(level: number, k: number, p: Float64Array) {
    const d = this.#dimension;
    const boxes = this.#levels[level];
    const outside = (axis: number) => {
      const at = 2 * d * k + axis;
      return Math.max(boxes[at] - p[axis], p[axis] - boxes[at + d], 0);
    };
    const [x, y, z] = [outside(0), outside(1), d === 3 ? outside(2) : 0];
    const square = x * x + y * y + z * z;
    // Math.hypot is slow, but its sum of squares neither overflows nor underflows.
    return square === 0 || (square > 1e-280 && square < 1e280) ? Math.sqrt(square) : Math.hypot(x, y, z);
  }
}

/**
 * Writes the box of some points.
 *
 * @internal
 *
 * @param at where the box begins
 * @param d the dimension
 * @param from the index of the first coordinate
 * @param to the index after the last one
 */
export function writeBox(
  boxes: Float64Array,
  at: number,
  d: number,
  points: Float64Array,
  from: number,
  to: number,
): void {
  for (let axis = 0; axis < d; axis++) {
    let [min, max] = [points[from + axis], points[from + axis]];
    for (let i = from + axis + d; i < to; i += d) {
      const x = points[i];
      if (x < min) min = x;
      else if (x > max) max = x;
    }
    boxes[at + axis] = min;
    boxes[at + axis + d] = max;
  }
}

/** The places of the values, in the order of their size. */
function sorted(values: Float64Array): Uint32Array {
  return Uint32Array.from(values, (_, k) => k).sort((a, b) => values[a] - values[b]);
}

/** For each value how many are smaller, or as large and before it. */
function ranks(values: Float64Array): Uint32Array {
  const result = new Uint32Array(values.length);
  sorted(values).forEach((k, rank) => {
    result[k] = rank;
  });
  return result;
}

/** The bits of a number from 0 to 2¹⁶ − 1, with a 0 before each. */
function spread(bits: number): number {
  for (const [shift, mask] of [
    [8, 0x00ff00ff],
    [4, 0x0f0f0f0f],
    [2, 0x33333333],
    [1, 0x55555555],
  ])
    bits = (bits | (bits << shift)) & mask;
  return bits;
}
