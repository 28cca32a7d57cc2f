// The word at the top of the first page as it is before the script runs, without scripts, and with reduced motion: written,
// with de Casteljau's algorithm at one parameter and the lines that lead there.
import { VIEW } from "../home/letters.js";
import { polyline, round, trailBetween, WORD } from "../home/word.js";

/** Parameters between which the lines are drawn: they show the first curve of the l as an envelope. */
const [FROM, TO] = [18, 19.62];
const ROUNDS = ["polygon", "first", "second"];
/** Radii of the points of the given polygon, and of the others. */
const [GIVEN_RADIUS, ROUND_RADIUS] = [5, 4.4];

export function wordPicture() {
  const lines = trailBetween(WORD, FROM, TO);
  const trail = (/** @type {boolean} */ tangents) =>
    lines
      .filter(({ tangent }) => tangent === tangents)
      .map(({ line }) => polyline(line))
      .join("");
  const levels = WORD.construction(TO);
  const polygons = ROUNDS.map((name, level) => `<path class="${name}" d="${polyline(levels[level])}"/>`).join("");
  const circles = levels.slice(0, 3).flatMap((flat, level) =>
    Array.from({ length: flat.length / 2 }, (_, i) => {
      const [x, y] = [flat[2 * i], flat[2 * i + 1]].map(round);
      return `<circle class="round-${level}" cx="${x}" cy="${y}" r="${level ? ROUND_RADIUS : GIVEN_RADIUS}"/>`;
    }),
  );
  const [x, y] = [...levels[3]].map(round);
  return {
    view: VIEW.join(" "),
    still: `${FROM} ${TO}`,
    strokes: WORD.splines.map((spline) => spline.toSVG({ precision: 1 })),
    trail: `<path class="side" d="${trail(false)}"/><path class="tangent" d="${trail(true)}"/>`,
    polygons,
    circles: circles.join(""),
    pen: `translate(${x} ${y})`,
  };
}
