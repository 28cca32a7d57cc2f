// How fast a point runs along the pieces of an applet when t runs evenly, or how sharply it turns: at a joint both may jump.
import { html, svg } from "lit";
import { Figure } from "./lib/figure.js";
import { choice, polyline } from "./lib/parts.js";
import { along, jumps } from "./lib/along.js";

const [LEFT, RIGHT, TOP, BOTTOM] = [72, 14, 16, 30];
const HEIGHT = 210;

/** @typedef {import("./lib/along.js").Piece} Piece */

/** `<fig-speed for="id of an applet" durations="1 2">`: without `durations` each piece takes one second. */
export class FigSpeed extends Figure {
  static properties = { for: {}, what: {}, durations: {} };

  constructor() {
    super();
    this.for = "";
    /** @type {"speed" | "curvature"} */
    this.what = "speed";
    this.durations = "";
    this.update_ = () => this.requestUpdate();
  }

  get target() {
    return /** @type {(HTMLElement & { figure: { pieces: { curve: Piece }[] } }) | null} */ (
      document.getElementById(this.for)
    );
  }

  connectedCallback() {
    super.connectedCallback();
    this.target?.addEventListener("update", this.update_);
    if (this.target) void customElements.whenDefined(this.target.localName).then(this.update_);
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.target?.removeEventListener("update", this.update_);
  }

  /** @param {ReturnType<typeof along>} plot */
  picture({ lines, joints, starts }) {
    const values = lines
      .flat()
      .map(([, y]) => y)
      .filter(Number.isFinite);
    const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)];
    const range = high - low || 1;
    const x = (/** @type {number} */ t) => LEFT + (t / starts[lines.length]) * (this.wide - LEFT - RIGHT);
    const y = (/** @type {number} */ value) => TOP + ((high - value) / range) * (HEIGHT - TOP - BOTTOM);
    const line = (/** @type {[number, number][]} */ places) =>
      polyline(
        "curve",
        places.filter(([, v]) => Number.isFinite(v)).flatMap(([t, v]) => [x(t), y(v)]),
      );
    return html`
      <svg viewBox="0 0 ${this.wide} ${HEIGHT}" role="img" aria-label="${this.what === "speed" ? "Speed" : "Curvature"} over time. ${this.words(joints, range)}">
        <path class="axis" d="M${LEFT} ${TOP}V${HEIGHT - BOTTOM}M${LEFT} ${y(0)}H${this.wide - RIGHT}" />
        ${lines.length > 0 ? starts.map((at) => svg`<text class="quiet middle" x=${x(at)} y=${HEIGHT - 10}>${at}</text>`) : ""}
        ${high > 0 ? svg`<text class="quiet end" x=${LEFT - 8} y=${TOP + 5}>${short(high)}</text>` : ""}
        ${low < 0 ? svg`<text class="quiet end" x=${LEFT - 8} y=${HEIGHT - BOTTOM + 2}>${short(low)}</text>` : ""}
        <text class="quiet end" x=${LEFT - 8} y=${y(0) + 4}>0</text>
        ${lines.map(line)}
        ${joints.filter((joint) => jumps(joint, range)).map(({ at, before, after }) => svg`<path d="M${x(at)} ${y(before)}V${y(after)}" stroke="var(--handle)" stroke-width="3" />`)}
      </svg>
    `;
  }

  /** @param {ReturnType<typeof along>["joints"]} joints @param {number} range */
  words(joints, range) {
    const told = joints.map((joint) =>
      jumps(joint, range)
        ? `It jumps from ${short(joint.before)} to ${short(joint.after)} at the joint.`
        : `No jump at the joint.`,
    );
    return told.join(" ") || "There is one piece only.";
  }

  render() {
    const durations = this.durations.split(" ").map((part) => Number(part) || 1);
    const plot = along(this.target?.figure?.pieces.map(({ curve }) => curve) ?? [], this.what, durations);
    const values = plot.lines
      .flat()
      .map(([, y]) => y)
      .filter(Number.isFinite);
    const range = Math.max(0, ...values) - Math.min(0, ...values) || 1;
    return html`
      <div class="frame">
        <div class="controls first">
          ${choice({
            name: "Over time:",
            options: [
              ["speed", "speed"],
              ["curvature", "curvature"],
            ],
            value: this.what,
            change: (what) => {
              this.what = /** @type {"speed" | "curvature"} */ (what);
              this.notifyChange();
            },
          })}
        </div>
        <div class="stage">${this.picture(plot)}</div>
        <p class="facts">${this.words(plot.joints, range)}</p>
      </div>
    `;
  }
}

/** Three digits are enough to read. @param {number} value */
const short = (value) => String(Number(value.toPrecision(3))).replace("-", "−");

customElements.define("fig-speed", FigSpeed);
