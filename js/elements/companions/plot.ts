// The plot of the weights: numbers in, numbers and words out; what draws them is bernstein.js.
import { weightsAt } from "./weights.js";
import type { Subject } from "./subject.js";

/** The picture in its own units: as wide and high, and where the axes lie. */
export const PLOT = { width: 400, height: 232, left: 34, right: 10, top: 24, bottom: 26 };
/** Of a polynomial: even those of degree 64 are smooth. */
const SAMPLES = 160;
/** Labels nearer than this to another one are left out; those of two digits need more. */
const [LABEL_ROOM, WIDE_LABEL_ROOM] = [17, 30];
const COLOURS = 5;
const DASHES = ["", "8 4", "2 4", "11 4 2 4"];
/** Beyond 0 and 1 polynomials leave every picture: so much of them is shown, at most. */
const MARGIN = 0.5;

/** The intervals of t and of the weights that are shown */
export type PlotRange = { x: [number, number]; y: [number, number] };
export type Line = { points: string; peak: { x: number; y: number; above: boolean }; labelled: boolean };

/** The lines of a basis over [0, 1], and farther where t is. */
export function plotOf(subject: Pick<Subject, "basis" | "degree" | "matrix" | "t" | "weights">): {
  range: PlotRange;
  lines: Line[];
} {
  const [from, to] = intervalOf(subject.t);
  const ts = Array.from({ length: SAMPLES + 1 }, (_, k) => from + ((to - from) * k) / SAMPLES);
  const rows = ts.map((t) => weightsAt(subject, t));
  const inside = rows.filter((_, k) => ts[k] >= 0 && ts[k] <= 1).flat();
  const beyond = to - from > 1 ? MARGIN : 0;
  const range = {
    x: [from, to],
    y: [Math.min(0, ...inside) - beyond, Math.max(1, ...inside) + beyond],
  } as PlotRange;
  const lines = rows[0].map((_, i) =>
    lineOf(
      range,
      ts,
      rows.map((row) => row[i]),
    ),
  );
  chooseLabels(lines);
  return { range, lines };
}

/** [0, 1] and t, to the next quarter. */
export function intervalOf(t: number) {
  return [Math.min(0, Math.floor(4 * t) / 4), Math.max(1, Math.ceil(4 * t) / 4)];
}

function lineOf(range: PlotRange, ts: number[], values: number[]): Line {
  const points = ts.map((t, k) => `${xOf(range, t).toFixed(1)},${yOf(range, values[k]).toFixed(1)}`).join(" ");
  let max = -1;
  values.forEach((value, k) => {
    if (ts[k] >= 0 && ts[k] <= 1 && (max < 0 || Math.abs(value) > Math.abs(values[max]) + 1e-9)) max = k;
  });
  return {
    points,
    peak: { x: xOf(range, ts[max]), y: yOf(range, values[max]), above: values[max] >= 0 },
    labelled: false,
  };
}

/** Labels from both ends inwards, where there is room. */
function chooseLabels(lines: Line[]) {
  const room = lines.length > 10 ? WIDE_LABEL_ROOM : LABEL_ROOM;
  const placed = [] as Line[];
  const order = lines.map((_, k) => (k % 2 ? lines.length - (k + 1) / 2 : k / 2));
  for (const k of order) {
    const { peak } = lines[k];
    lines[k].labelled = placed.every((other) => Math.hypot(other.peak.x - peak.x, other.peak.y - peak.y) >= room);
    if (lines[k].labelled) placed.push(lines[k]);
  }
}

export function xOf({ x: [from, to] }: PlotRange, t: number) {
  return PLOT.left + ((t - from) / (to - from)) * (PLOT.width - PLOT.left - PLOT.right);
}

/** Far outside of the picture it does not matter where: no number is too large to be written. */
export function yOf({ y: [low, high] }: PlotRange, value: number) {
  const part = Math.min(Math.max((value - low) / (high - low), -9), 9);
  return PLOT.height - PLOT.bottom - part * (PLOT.height - PLOT.top - PLOT.bottom);
}

/** The t of a place in the picture, within what is shown. */
export function tAt({ x: [from, to] }: PlotRange, x: number) {
  const t = from + ((x - PLOT.left) / (PLOT.width - PLOT.left - PLOT.right)) * (to - from);
  return Math.min(Math.max(Math.round(1000 * t) / 1000, from), to);
}

/** How a polynomial looks: a colour and a line, of which twenty pairs differ. */
export function lookOf(i: number) {
  return { colour: `c${i % COLOURS}`, dash: DASHES[i % DASHES.length] };
}
