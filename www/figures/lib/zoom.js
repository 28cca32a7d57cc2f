// The view of an applet's picture, enlarged about a point.

/** The picture, in its own units. */
const [WIDTH, HEIGHT] = [670, 480];

/** The attribute `view`. @param {number} factor @param {{ x: number, y: number }} center */
export function viewAt(factor, { x, y }) {
  if (factor === 1) return `0 0 ${WIDTH} ${HEIGHT}`;
  const [width, height] = [WIDTH / factor, HEIGHT / factor];
  return [x - width / 2, y - height / 2, width, height].join(" ");
}
