import { css, html, nothing, svg } from "lit";
import { capture } from "../../ui/capture.js";
import { shown } from "../../ui/numbers.js";
import { intervalOf, lookOf, PLOT, plotOf, tAt, xOf, yOf } from "./plot.js";
import { slider } from "./slider.js";
import { style } from "./style.js";
import { isVector, subjectOf } from "./subject.js";
import { BASES, MATRIX_DEGREE, MAX_DEGREE, weightsAt } from "./weights.js";
import { translated, translatedTable } from "../../editor/translations.js";
import type { Linked } from "./linked.js";
import type { PlotRange, Line } from "./plot.js";
import type { Subject } from "./subject.js";
import type { Basis } from "./weights.js";

const DEFAULTS = { degree: 3, t: 0.5, basis: "bezier" as Basis };
const TITLES: Record<string, string> = translatedTable({
  bezier: "Bernstein polynomials",
  rational: "Rational basis functions",
  hermite: "Hermite weights",
  "b-spline": "B-spline weights",
  "catmull-rom": "Catmull-Rom weights",
  matrix: "Weights of the matrix",
});
/** So many values are read out; of more, the greatest. */
const MAX_SPOKEN = 8;
/** A Hermite curve's weights stand in the order P0, P3, P1 − P0, P3 − P2. */
const HERMITE_SLOTS = [0, 2, 3, 1];

/** The element: its properties as they are given, good or not. */
type Host = Linked & { degree: number; t: number; basis: string };

/**
 * What `<bezier-bernstein>` shows.
 *
 * @csspart plot - the picture of the weights
 * @csspart values - the list of the weights at t
 * @csspart sum - the sum of the weights
 */
export class BernsteinView {
  static styles = [
    style,
    css`
    svg { display: block; inline-size: 100%; background: var(--bz-paper); touch-action: pan-y; cursor: ew-resize; user-select: none; -webkit-user-select: none; }
    text { font-size: 12.5px; fill: var(--bz-ink); paint-order: stroke; stroke: var(--bz-paper); stroke-width: 3px; stroke-linejoin: round; }
    @container (min-width: 560px) { text { font-size: 9.5px; } }
    .axis { stroke: var(--bz-field); } .grid { stroke: var(--bz-rim); } .axis, .grid { stroke-width: 1; }
    .tick { fill: var(--bz-quiet); }
    .line { fill: none; stroke-width: 2; }
    .c0 { stroke: var(--bz-curve); } .c1 { stroke: var(--bz-handle); } .c2 { stroke: var(--bz-level1); } .c3 { stroke: var(--bz-level2); } .c4 { stroke: var(--bz-quiet); }
    .dot { fill: var(--bz-paper); stroke-width: 2; }
    .marker { stroke: var(--bz-ink); stroke-width: 1.5; } .grip { fill: var(--bz-ink); }
    .marked .line:not(.selected) { opacity: 0.28; } .line.selected { stroke-width: 3.5; }
    ul { display: grid; grid-template-columns: repeat(auto-fill, minmax(7.2rem, 1fr)); gap: 0.2rem 0.3rem; margin: 0; padding: 0 0.7rem 0.5rem; list-style: none; max-block-size: 10rem; overflow: auto; }
    li button { display: flex; gap: 0.4rem; align-items: center; inline-size: 100%; min-block-size: 1.8rem; padding: 0 0.35rem; border-color: transparent; background: none; font-size: 0.875rem; }
    li button svg { flex: none; inline-size: 26px; background: none; cursor: inherit; } li .value { margin-inline-start: auto; }
    li button[aria-pressed="true"] { border-color: var(--bz-accent); background: var(--bz-paper); }
    .sum { padding: 0 0.8rem 0.6rem; }
    @media print { ul { max-block-size: none; } li button { display: flex; } }
  `,
  ];

  /** The polynomial that was selected here, and the one of the applet's focused point. */
  #selected: number | null = null;
  #focusedPoint: number | null = null;
  #dragging = false;
  /** The lines of the last picture, and what they depend on. */
  #plot: { key: string; range: PlotRange; lines: Line[] } = { key: "", range: { x: [0, 1], y: [0, 1] }, lines: [] };

  #host;

  constructor(host: Host) {
    this.#host = host;
  }

  #subject(): Subject | (Pick<Subject, "basis" | "degree" | "matrix" | "t" | "weights"> & { names: string[] }) {
    const host = this.#host;
    const linked = subjectOf(host.target?.figure);
    if (linked) return linked;
    const known = BASES.some((name) => name === host.basis);
    const basis = host.checked("basis", host.basis as Basis, known, `one of ${BASES.join(", ")}`, DEFAULTS.basis);
    const whole = Number.isInteger(host.degree) && host.degree >= 1 && host.degree <= MAX_DEGREE;
    const free = host.checked("degree", host.degree, whole, `a whole number from 1 to ${MAX_DEGREE}`, DEFAULTS.degree);
    const degree = basis === "bezier" || basis === "b-spline" ? free : MATRIX_DEGREE;
    const t = host.checked("t", host.t, Number.isFinite(host.t), "a number", DEFAULTS.t);
    const names =
      basis === "hermite" ? ["P0", "P3", "P1−P0", "P3−P2"] : Array.from({ length: degree + 1 }, (_, i) => `P${i}`);
    return { basis, degree, t, matrix: null, names };
  }

  content() {
    const subject = this.#subject();
    const { basis, degree, matrix, weights, t, names } = subject;
    const key = JSON.stringify([basis, degree, matrix, weights, intervalOf(t)]);
    if (key !== this.#plot.key) this.#plot = { key, ...plotOf(subject) };
    const { range, lines } = this.#plot;
    const values = weightsAt(subject, t);
    const marked = [this.#selected, this.#focusedPoint].find((i) => i !== null && i < values.length) ?? null;
    const hasDegree = basis === "bezier" || basis === "b-spline";
    const title = hasDegree
      ? translated("{0} of degree {1}", TITLES[weights ? "rational" : basis], degree)
      : TITLES[basis];
    return html`<div class="frame" part="frame" role="group" aria-label=${this.#host.label || title}>
      ${this.#picture({ range, lines, values, marked, t, names, title })}
      ${slider(t, range.x, (to, done) => this.#host.setT(to, done))}
      <ul part="values" aria-label=${translated("Values at t")}>${values.map((value, i) => this.#entry(names[i], value, i, marked))}</ul>
      <p class="sum quiet" part="sum">${sumWords(weights ? "rational" : basis, values)}</p>
    </div>`;
  }

  #picture({
    range,
    lines,
    values,
    marked,
    t,
    names,
    title,
  }: {
    range: PlotRange;
    lines: Line[];
    values: number[];
    marked: number | null;
    t: number;
    names: string[];
    title: string;
  }) {
    const x = xOf(range, t);
    const [top, bottom] = [PLOT.top, PLOT.height - PLOT.bottom];
    const inside = { width: PLOT.width, height: bottom + 4 };
    return html`<svg part="plot" role="img" aria-label=${`${title}. ${spoken(values, names, t)}`} viewBox="0 0 ${PLOT.width} ${PLOT.height}" class=${marked === null ? "" : "marked"}
      @pointerdown=${this.#grabbed}>
      ${axes(range)}
      <svg width=${inside.width} height=${inside.height}>
        ${lines.map((line, i) => svg`<polyline class="line ${lookOf(i).colour} ${i === marked ? "selected" : ""}" stroke-dasharray=${lookOf(i).dash || nothing} points=${line.points} />`)}
        <line class="marker" x1=${x} x2=${x} y1=${top - 8} y2=${bottom} />
        ${values.map((value, i) => svg`<circle class="dot ${lookOf(i).colour}" r=${i === marked ? 5 : 3.5} cx=${x} cy=${yOf(range, value)} />`)}
      </svg>
      <path class="grip" d="M${x - 7},${top - 20}h14v7l-7,7l-7,-7z" />
      ${lines.map(({ peak, labelled }, i) => (labelled || i === marked ? label(peak, names[i]) : nothing))}
    </svg>`;
  }

  #entry(name: string, value: number, i: number, marked: number | null) {
    const { colour, dash } = lookOf(i);
    return html`<li><button type="button" aria-pressed=${i === marked} @click=${() => this.#choose(i)}>
      <svg viewBox="0 0 26 8" aria-hidden="true"><line class="line ${colour}" stroke-dasharray=${dash || nothing} x2="26" y1="4" y2="4" /></svg>
      ${name} <span class="value">${shown(value, 4)}</span></button></li>`;
  }

  #choose(i: number) {
    this.#selected = this.#selected === i ? null : i;
    this.#host.requestUpdate();
  }

  handleFocus(event: Event) {
    const handle = event.composedPath().find((node) => node instanceof HTMLElement && node.dataset.index !== undefined);
    const subject = subjectOf(this.#host.target?.figure);
    const index = Number(handle instanceof HTMLElement && handle.dataset.index);
    const slot = handle && subject && event.type === "focusin" ? subject.indices.indexOf(index) : -1;
    this.#focusedPoint = slot < 0 ? null : subject?.basis === "hermite" ? HERMITE_SLOTS[slot] : slot;
    this.#host.requestUpdate();
  }

  #grabbed = (event: PointerEvent) => {
    if (event.button !== 0 || this.#dragging) return;
    const picture = event.currentTarget as SVGSVGElement;
    const before = this.#subject().t;
    const move = (now: PointerEvent) => this.#host.setT(this.#place(picture, now), false);
    this.#dragging = true;
    capture(event, {
      move,
      end: (last, released) => {
        this.#dragging = false;
        this.#host.setT(released ? this.#place(picture, last) : before, true);
      },
    });
    move(event);
  };

  #place(picture: SVGSVGElement, event: PointerEvent) {
    const { left, width } = picture.getBoundingClientRect();
    return tAt(this.#plot.range, ((event.clientX - left) / width) * PLOT.width);
  }
}

function axes(range: PlotRange) {
  const {
    x: [from, to],
    y: [low, high],
  } = range;
  const ts = [from, 0, 0.5, 1, to].filter((t, k, all) => all.indexOf(t) === k);
  const levels = [0, 0.5, 1].filter((y) => y >= low && y <= high);
  return svg`${levels.map(
    (
      y,
    ) => svg`<line class=${y ? "grid" : "axis"} x1=${PLOT.left} x2=${PLOT.width - PLOT.right} y1=${yOf(range, y)} y2=${yOf(range, y)} />
      <text class="tick" x=${PLOT.left - 6} y=${yOf(range, y) + 4} text-anchor="end">${y}</text>`,
  )}
    ${ts.map(
      (
        t,
      ) => svg`<line class=${t ? "grid" : "axis"} x1=${xOf(range, t)} x2=${xOf(range, t)} y1=${PLOT.top} y2=${PLOT.height - PLOT.bottom} />
      <text class="tick" x=${xOf(range, t)} y=${PLOT.height - 9} text-anchor=${t > 1 ? "end" : "middle"}>${shown(t, 2)}</text>`,
    )}`;
}

function label({ x, y, above }: Line["peak"], name: string) {
  const anchor = x < PLOT.left + 12 ? "start" : x > PLOT.width - PLOT.right - 12 ? "end" : "middle";
  const shift = { start: 6, middle: 0, end: -6 }[anchor];
  return svg`<text class="name" x=${x + shift} y=${y + (above ? -6 : 16)} text-anchor=${anchor}>${name}</text>`;
}

function spoken(values: number[], names: string[], t: number) {
  const spoken = values.map((value, i) => ({ name: names[i], value }));
  if (spoken.length > MAX_SPOKEN) spoken.sort((a, b) => b.value - a.value).splice(3);
  const list = spoken.map(({ name, value }) => `${name} ${shown(value)}`).join(", ");
  return values.length > MAX_SPOKEN
    ? translated("At t = {0}: the greatest are {1}.", shown(t), list)
    : translated("At t = {0}: {1}.", shown(t), list);
}

/** What the weights of points sum to; vectors do not count. */
function sumWords(basis: string, values: number[]) {
  const sum = values.reduce((all, value, i) => (isVector(basis, i) ? all : all + value), 0);
  const words = shown(sum, 9);
  if (basis === "rational") return translated("Sum of the functions: {0}", words);
  return basis === "hermite"
    ? translated("Sum of the weights of the two points: {0}", words)
    : translated("Sum of the weights: {0}", words);
}
