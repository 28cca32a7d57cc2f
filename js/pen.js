import { take, trim } from "./transfer.js";

/**
 * Draws the steps that the core left: each a code and coordinates; the codes of lines and curves are their numbers of
 * points. All steps come in one call, so a target that calls back into the package does no harm.
 *
 * @internal
 * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D | Path2D} target
 * @param {number} length as the call to the core returned it
 */
export function draw(target, length) {
  const steps = take(0, length);
  trim();
  let at = 0;
  const next = () => steps[at++];
  while (at < length) {
    const code = next();
    if (code === 0) target.closePath();
    else if (code === 1) target.lineTo(next(), next());
    else if (code === 2) target.quadraticCurveTo(next(), next(), next(), next());
    else if (code === 3) target.bezierCurveTo(next(), next(), next(), next(), next(), next());
    else target.moveTo(next(), next());
  }
}
