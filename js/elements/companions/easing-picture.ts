import { html, svg } from "lit";
import { across, down, SQUARE } from "./timing.js";
import { translated } from "../../editor/translations.js";
import type { Handles, Heights } from "./timing.js";

/** The curve in the unit square, and what of it lies beyond. */
export function picture([x1, y1, x2, y2]: Handles, heights: Heights, name: string) {
  const at = (x: number, y: number) => [across(x), down(heights, y)];
  const [start, first, second, end] = [at(0, 0), at(x1, y1), at(x2, y2), at(1, 1)];
  const arm = (from: number[], to: number[]) =>
    svg`<line class="arm" x1=${from[0]} y1=${from[1]} x2=${to[0]} y2=${to[1]} />`;
  const { width, height } = SQUARE;
  return html`<svg part="plot" role="img" aria-label=${name} viewBox="0 0 ${width} ${height}">
    <rect class="beyond" width=${width} height=${end[1]} /><rect class="beyond" width=${width} y=${start[1]} height=${height - start[1]} />
    <rect class="square" x=${start[0]} y=${end[1]} width=${end[0] - start[0]} height=${start[1] - end[1]} />
    <text x=${start[0] - 6} y=${start[1] + 4} text-anchor="end">0</text><text x=${start[0] - 6} y=${end[1] + 4} text-anchor="end">1</text>
    <text x=${end[0]} y=${start[1] + 14} text-anchor="end">${translated("time")}</text><text transform="translate(${start[0] - 8},${(start[1] + end[1]) / 2}) rotate(-90)" text-anchor="middle">${translated("progress")}</text>
    ${arm(start, first)}${arm(end, second)}
    <path class="curve" d="M${start} C${first} ${second} ${end}" />
    <circle class="end" r="5" cx=${start[0]} cy=${start[1]} /><circle class="end" r="5" cx=${end[0]} cy=${end[1]} />
    <circle class="now" r="5" cx=${start[0]} cy=${start[1]} visibility="hidden" />
  </svg>`;
}
