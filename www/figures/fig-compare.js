// Quadratic and cubic, side by side: one handle against two, and the shape that one handle cannot make.
import { html, svg } from "lit";
import { Curve } from "casteljau";
import { Figure } from "./lib/figure.js";
import { check, disc, handle, polyline, ring, square } from "./lib/parts.js";
import { decimal, short } from "./lib/numbers.js";

const [WIDTH, HEIGHT] = [100, 76];
const BOX = /** @type {const} */ ({ min: [1, -3], max: [99, 79] });
/** Fit into a half of the figure. */
const MAX_WIDTH = 460;

/** @typedef {[number, number]} Place */
/** @typedef {{ ends: [Place, Place], middle: Place, handles: [Place, Place] }} Shape */

/** @type {Shape} an S */
const S = {
  ends: [
    [10, 60],
    [90, 16],
  ],
  middle: [50, 4],
  handles: [
    [44, 0],
    [56, 76],
  ],
};
/** @type {Shape} an arch, where both are one curve */
const ARCH = {
  ends: [
    [12, 62],
    [88, 62],
  ],
  middle: [56, 6],
  handles: [
    [12 + (2 * 44) / 3, 62 - (2 * 56) / 3],
    [88 - (2 * 32) / 3, 62 - (2 * 56) / 3],
  ],
};

/** @param {Shape} shape */
export const quadraticOf = ({ ends, middle }) => new Curve([ends[0], middle, ends[1]]);

/** @param {Shape} shape */
export const cubicOf = ({ ends, handles }) => new Curve([ends[0], ...handles, ends[1]]);

/**
 * What a drag does to both curves: ends are shared; the quadratic's middle and a handle of the cubic move by the same step.
 *
 * @param {Shape} shape
 * @param {"start" | "end" | "middle" | "first" | "second"} part
 * @param {Place} to
 * @returns {Shape}
 */
export function moved({ ends, middle, handles }, part, to) {
  const by = (/** @type {Place} */ from, /** @type {Place} */ point) =>
    /** @type {Place} */ ([point[0] + to[0] - from[0], point[1] + to[1] - from[1]]);
  if (part === "start") return { ends: [to, ends[1]], middle, handles };
  if (part === "end") return { ends: [ends[0], to], middle, handles };
  if (part === "middle") return { ends, middle: to, handles: [by(middle, handles[0]), by(middle, handles[1])] };
  return {
    ends,
    middle: by(handles[part === "first" ? 0 : 1], middle),
    handles: part === "first" ? [to, handles[1]] : [handles[0], to],
  };
}

/** The places of names, in CSS pixels from their points: below those on the curve, beside the others. */
const [NAME_BELOW, NAME_BESIDE] = [
  [0, 23],
  [20, 5],
];

/** `<fig-compare>`, `<fig-compare shape="s">` */
export class FigCompare extends Figure {
  static properties = { shape: {}, fit: { type: Boolean }, points: { state: true } };

  constructor() {
    super();
    this.shape = "";
    this.fit = false;
    /** @type {Shape} */
    this.points = ARCH;
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (changed.has("shape") && this.shape === "s") this.show(S, true);
  }

  /** @param {Shape} points @param {boolean} fit */
  show(points, fit) {
    this.points = points;
    this.fit = fit;
  }

  /** The quadratic's control points, raised to a cubic. */
  elevate() {
    const flat = quadraticOf(this.points).elevate().controlPoints();
    this.show(
      {
        ...this.points,
        handles: [
          [flat[2], flat[3]],
          [flat[4], flat[5]],
        ],
      },
      this.fit,
    );
    this.notifyChange();
  }

  /** @returns {{ wide: number, height: number, scale: number, place: (p: readonly [number, number]) => Place, unplace: (p: readonly [number, number]) => Place }} */
  sheet() {
    const wide = this.wide >= 562 ? (this.wide - 1) / 2 : Math.min(this.wide, MAX_WIDTH);
    const scale = wide / (WIDTH + 4);
    const height = Math.round((HEIGHT + 18) * scale);
    const [left, top] = [2 * scale, 11 * scale];
    return {
      wide,
      height,
      scale,
      place: ([x, y]) => [left + x * scale, top + y * scale],
      unplace: ([x, y]) => [(x - left) / scale, (y - top) / scale],
    };
  }

  /**
   * @param {"quadratic" | "cubic"} kind
   * @param {Curve} curve
   * @param {{ curve: Curve, words: string } | null} ghost
   * @param {{ part: Parameters<typeof moved>[1], at: Place, name: string, kind: "on" | "off" }[]} parts
   */
  side(kind, curve, ghost, parts) {
    const { wide, height, place, unplace } = this.sheet();
    const [ox, oy] = place([0, 0]);
    const scale = this.sheet().scale;
    const onPaper = (/** @type {Curve} */ c) => c.transform([scale, 0, 0, scale, ox, oy]);
    const drawn = onPaper(curve);
    const behind = ghost && onPaper(ghost.curve);
    const hollow = behind && kind === "cubic" ? Array.from(behind.controlPoints()) : [];
    const move = (/** @type {Parameters<typeof moved>[1]} */ part) => (/** @type {Place} */ to) =>
      (this.points = moved(this.points, part, to));
    return html`
      <div class="stage ${kind}">
        <svg viewBox="0 0 ${wide} ${height}" role="img" aria-label="${kind}${ghost ? `, and ${ghost.words}` : ""}">
          <text class="strong" x="12" y="22">${kind === "quadratic" ? "Quadratic: one handle" : "Cubic: two handles"}</text>
          ${polyline("polygon", drawn.controlPoints())}
          ${behind ? svg`<path class="ghost" d=${behind.toSVG({ precision: 2 })} />` : ""}
          ${hollow.length === 8 ? [ring(hollow[2], hollow[3], "var(--quiet)"), ring(hollow[4], hollow[5], "var(--quiet)")] : ""}
          <path class="curve" d=${drawn.toSVG({ precision: 2 })} />
          ${parts.map(({ at, name, kind: mark }) => {
            const [x, y] = place(at);
            const [dx, dy] = mark === "on" ? NAME_BELOW : NAME_BESIDE;
            return svg`${(mark === "on" ? disc : square)(x, y)}<text class="strong haloed middle" x=${x + dx} y=${y + dy}>${name}</text>`;
          })}
        </svg>
        ${parts.map(({ part, at, name, kind: mark }) => handle({ name: `${kind} ${name}`, kind: mark, at, place, unplace, size: [wide, height], box: BOX, step: 1, say: (v) => short(v, 1), move: move(part), done: () => this.notifyChange() }))}
      </div>
    `;
  }

  render() {
    const { ends, middle, handles } = this.points;
    const [quadratic, cubic] = [quadraticOf(this.points), cubicOf(this.points)];
    const best = cubic.reduce();
    const raised = quadratic.elevate();
    const turns = cubic.inflections().length;
    const same = raised.equals(cubic, 1e-9);
    const outer = /** @type {const} */ ([
      { part: "start", at: ends[0], name: "P0", kind: "on" },
      { part: "end", at: ends[1], kind: "on" },
    ]);
    const last = (/** @type {string} */ name) => ({ ...outer[1], name });
    return html`
      <div class="frame">
        <div class="sides">
          ${this.side(
            "quadratic",
            this.fit ? best.curve : quadratic,
            this.fit ? { curve: cubic, words: "the cubic, dashed" } : null,
            this.fit ? [] : [outer[0], { part: "middle", at: middle, name: "P1", kind: "off" }, last("P2")],
          )}
          ${this.side(
            "cubic",
            cubic,
            this.fit ? null : { curve: raised, words: "the quadratic raised to a cubic, dashed" },
            [
              outer[0],
              { part: "first", at: handles[0], name: "P1", kind: "off" },
              { part: "second", at: handles[1], name: "P2", kind: "off" },
              last("P3"),
            ],
          )}
        </div>
        <p class="facts">
          ${
            this.fit
              ? html`The first picture shows the quadratic that is nearest to the cubic. At equal <i>t</i>, its greatest distance is <b class="error" data-error=${best.error}>${decimal(best.error)}</b> (the picture is ${WIDTH} wide).`
              : same
                ? html`Both are the same curve. Every quadratic is also a cubic: its handles are two thirds of the way to P1 (the rings).`
                : html`The two curves differ by <b>${decimal(raised.hausdorff(cubic))}</b>. The rings show the handles with which the cubic is equal to the quadratic.`
          }
        </p>
        <p class="facts">
          Inflections of the cubic: <b class="turns">${turns === 0 ? "none" : turns === 1 ? "one" : "two"}</b>. A quadratic has none, because it is part of a parabola.
        </p>
        <div class="controls">
          <div class="row">
            <button @click=${() => {
              this.show(ARCH, false);
              this.notifyChange();
            }}>Arch</button>
            <button @click=${() => {
              this.show(S, this.fit);
              this.notifyChange();
            }}>S-shape</button>
            <button @click=${this.elevate}>Make the cubic equal</button>
          </div>
          ${check({
            name: "best quadratic for the cubic",
            value: this.fit,
            change: (fit) => {
              this.fit = fit;
              this.notifyChange();
            },
          })}
        </div>
      </div>
    `;
  }
}

customElements.define("fig-compare", FigCompare);
