// A flight along the path of the picture. Its ribs are the frames at equal lengths, so that the flight needs no library.
import { animate, find } from "../picture.js";

const LOOP_MS = 9000;
const DEGREES = 180 / Math.PI;

const box = find('[data-thing="camera"]');
const svg = find("svg", box);
const craft = find(".craft", svg);
const mast = find(".mast", svg);
/** @type {number[]} */
const numbers = find(".ribs", svg)
  .getAttribute("d")
  .match(/-?[\d.]+/g)
  .map(Number);
/** A point of the path and the end of its normal. */
const frames = Array.from({ length: numbers.length / 4 }, (_, i) => numbers.slice(4 * i, 4 * i + 4));

animate(svg, box, (ms) => {
  const at = ((ms / LOOP_MS) % 1) * frames.length;
  const [i, part] = [Math.floor(at), at % 1];
  const [from, to] = [frames[i], frames[(i + 1) % frames.length]];
  const [x, y, endX, endY] = from.map((value, k) => (value + part * (to[k] - value)).toFixed(1));
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]) * DEGREES;
  craft.setAttribute("transform", `translate(${x} ${y}) rotate(${angle.toFixed(1)})`);
  mast.setAttribute("d", `M${x} ${y}L${endX} ${endY}`);
});
