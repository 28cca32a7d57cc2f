// The page's laboratory: presets, previews beside another timing function, the curve with t and x told apart, code.
import { css as styles, html, svg } from "lit";
import { Curve, easing } from "casteljau";
import { codeBox } from "../figures/lib/code-box.js";
import { Figure } from "../figures/lib/figure.js";
import { diamond, disc, list, polyline, ring, slider, square } from "../figures/lib/parts.js";
import { decimal } from "../figures/lib/numbers.js";
import { css, parse, PRESETS, same } from "./value.js";

/** Marks of equal steps. */
const STEPS = 20;
const HOLD_MS = 500;

/** What the previews do with y: from 0 to 1, and beyond. @type {readonly (readonly [string, (y: number) => Record<string, string>])[]} */
const PREVIEWS = [
  ["move", (y) => ({ left: `calc(${y} * (100% - 2.4rem))` })],
  ["scale", (y) => ({ left: "calc(50% - 1.2rem)", transform: `scale(${Math.max(0, 0.25 + 0.75 * y)})` })],
  ["fade", (y) => ({ left: "calc(50% - 1.2rem)", opacity: String(Math.min(Math.max(y, 0), 1)) })],
  ["turn", (y) => ({ left: "calc(50% - 1.2rem)", transform: `rotate(${180 * y}deg)` })],
];

/** @param {readonly number[]} value */
export const curveOf = ([x1, y1, x2, y2]) =>
  new Curve([
    [0, 0],
    [x1, y1],
    [x2, y2],
    [1, 1],
  ]);

/** @param {readonly number[]} value */
const timing = ([x1, y1, x2, y2]) => easing(x1, y1, x2, y2);

/**
 * `<easing-lab>`: holds the value; a `<bezier-easing>` inside edits it. Tells "change" when the user is done.
 */
export class EasingLab extends Figure {
  static properties = {
    value: { attribute: false },
    against: { state: true },
    x: { state: true },
    duration: { state: true },
    problem: { state: true },
    even: { state: true },
    playing: { state: true },
  };
  static styles = [
    Figure.styles,
    styles`
    .lanes { display: grid; grid-template-columns: auto 1fr 1fr; gap: 0.5rem 0.9rem; align-items: center; padding: 0.7rem 0.9rem; background: var(--paper); }
    .lanes > b { font-weight: 600; font-size: 0.875rem; }
    .lane { position: relative; block-size: 2.8rem; border-radius: 8px; background: var(--panel); border: 1px solid var(--rim); overflow: clip; overflow-clip-margin: 1.5rem; }
    .lane span { position: absolute; inset-block-start: 0.15rem; inline-size: 2.4rem; block-size: 2.4rem; border-radius: 8px; border: 2px solid var(--curve); background: var(--curve); }
    .lane .other { border-color: var(--handle); background: var(--paper); }
    .lane span::after { content: ""; position: absolute; inset: 4px auto auto 50%; inline-size: 2px; block-size: 0.6rem; background: var(--paper); }
    .lane .other::after { background: var(--handle); }
    .text { flex: 1 1 20rem; }
    .text input { flex: 1; min-inline-size: 0; font-family: ui-monospace, Menlo, Consolas, monospace; }
    .editor { padding: 0.9rem; background: var(--paper); }
    @media (forced-colors: active) { .lane span { forced-color-adjust: none; background: CanvasText; } .lane .other { background: Canvas; } }
    @media (max-width: 480px) { .text { flex-wrap: wrap; } .text input { flex: 1 0 100%; font-size: 0.875rem; } .lanes { grid-template-columns: 1fr 1fr; } .lanes > b.name { grid-column: 1 / -1; margin-block-start: 0.3rem; } .lanes > .corner { display: none; } }
  `,
  ];

  constructor() {
    super();
    /** @type {readonly number[]} */
    this.value = PRESETS[1][1];
    this.against = "linear";
    this.x = 0.35;
    this.duration = 1200;
    this.problem = "";
    this.even = "t";
    this.playing = false;
    this.frame = 0;
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.stop();
  }

  get editor() {
    return /** @type {(HTMLElement & { value: string }) | null} */ (this.querySelector("bezier-easing"));
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    if (!changed.has("value") || !this.editor) return;
    if (!this.editor.value || !same(parse(this.editor.value), this.value)) this.editor.value = css(this.value);
  }

  /**
   * Takes what the user chose or wrote; what is no timing function is named and the last good one kept.
   *
   * @param {string} text
   * @param {boolean} [done]
   */
  take(text, done = true) {
    try {
      this.value = parse(text);
      this.problem = "";
    } catch (error) {
      this.problem = `Not taken: ${/** @type {Error} */ (error).message}. The last good curve is kept.`;
      return;
    }
    if (done) this.notifyChange();
  }

  /** The editor's own events are not the lab's. @param {Event} event */
  edited(event) {
    const target = /** @type {HTMLElement & { value?: unknown }} */ (event.target);
    if (target.localName !== "bezier-easing" || typeof target.value !== "string") return;
    event.stopPropagation();
    this.take(target.value, event.type === "change");
  }

  play() {
    if (this.playing) return this.stop();
    const start = performance.now();
    const step = (/** @type {number} */ now) => {
      const passed = now - start;
      this.x = Math.min(Math.max(passed / this.duration, 0), 1);
      if (passed > this.duration + HOLD_MS) this.stop();
      else this.frame = requestAnimationFrame(step);
    };
    this.playing = true;
    this.frame = requestAnimationFrame(step);
  }

  stop() {
    cancelAnimationFrame(this.frame);
    this.playing = false;
  }

  presets() {
    return html`
      <div class="frame">
        <div class="editor"><slot @input=${this.edited} @change=${this.edited}></slot></div>
        <div class="controls">
          <div class="row" role="group" aria-label="Presets">
            ${PRESETS.map(([name, value]) => html`<button aria-pressed=${same(value, this.value)} @click=${() => this.take(css(value))}>${name}</button>`)}
          </div>
          <label class="text"><span>Value</span>
            <input type="text" spellcheck="false" .value=${css(this.value)} @change=${(/** @type {Event} */ event) => this.take(/** @type {HTMLInputElement} */ (event.target).value)} /></label>
        </div>
        <p class="problem" role="alert">${this.problem}</p>
      </div>
    `;
  }

  previews() {
    const other = /** @type {readonly number[]} */ (PRESETS.find(([name]) => name === this.against)?.[1]);
    const [mine, theirs] = [timing(this.value)(this.x), timing(other)(this.x)];
    const style = (/** @type {Record<string, string>} */ rules) =>
      Object.entries(rules)
        .map(([name, text]) => `${name}: ${text}`)
        .join("; ");
    return html`
      <div class="frame">
        <div class="lanes">
          <b class="corner"></b><b>yours</b><b>${this.against}</b>
          ${PREVIEWS.map(
            ([name, look]) => html`
            <b class="name">${name}</b>
            <div class="lane"><span class="mine" data-preview=${name} .style=${style(look(mine))}></span></div>
            <div class="lane"><span class="other" .style=${style(look(theirs))}></span></div>`,
          )}
        </div>
        <div class="controls">
          <button @click=${this.play}>${this.playing ? "Stop" : "Play"}</button>
          ${slider({
            name: html`time <i>x</i>`,
            value: this.x,
            min: 0,
            max: 1,
            step: 0.005,
            text: decimal(this.x),
            change: (x) => {
              this.stop();
              this.x = x;
            },
          })}
          ${slider({
            name: "Duration",
            value: this.duration,
            min: 200,
            max: 4000,
            step: 100,
            text: `${(this.duration / 1000).toFixed(1)} s`,
            change: (ms) => {
              this.duration = ms;
              this.notifyChange();
            },
          })}
          ${list({
            name: "beside",
            options: PRESETS.map(([name]) => [name, name]),
            value: this.against,
            change: (name) => {
              this.against = name;
              this.notifyChange();
            },
          })}
        </div>
      </div>
    `;
  }

  /** The curve in the unit square: where x leads, and marks at equal steps of t or of x. */
  square() {
    const curve = curveOf(this.value);
    const { min, max } = curve.controlBounds();
    const [low, high] = [Math.min(min.y, 0) - 0.06, Math.max(max.y, 1) + 0.06];
    const wide = Math.min(this.wide, 560);
    const scale = Math.min(wide - 76, 380);
    const [left, height] = [(this.wide - scale) / 2, scale * (high - low) + 34];
    const place = (/** @type {number} */ x, /** @type {number} */ y) => [left + x * scale, (high - y) * scale];
    const drawn = curve.transform([scale, 0, 0, -scale, left, high * scale]);
    const ease = timing(this.value);
    const marks = Array.from({ length: STEPS + 1 }, (_, i) => {
      const { x, y } = this.even === "t" ? curve.eval(i / STEPS) : { x: i / STEPS, y: ease(i / STEPS) };
      return [...place(x, y), ...place(x, low)];
    });
    const [px, py] = place(this.x, ease(this.x));
    const points = Array.from({ length: 4 }, (_, i) => drawn.controlPoints().slice(2 * i, 2 * i + 2));
    return html`
      <svg viewBox="0 0 ${this.wide} ${height}" role="img" aria-label="The curve of ${css(this.value)}: at the time ${decimal(this.x)} it is at ${decimal(ease(this.x), 3)}">
        <path class="gridline" d="M${place(0, 0)}H${left + scale}V${place(1, 1)[1]}H${left}Z" />
        ${marks.map(([, , bx, by]) => svg`<path class="axis" d="M${bx} ${by}v-7" />`)}
        ${polyline("polygon", [...points[0], ...points[1]])}${polyline("polygon", [...points[2], ...points[3]])}
        <path class="curve" d=${drawn.toSVG({ precision: 2 })} />
        ${marks.map(([x, y]) => ring(x, y, "var(--handle)", 3))}
        <path class="dropped" d="M${px} ${place(0, low)[1]}V${py}H${left}" />
        ${disc(points[0][0], points[0][1])}${square(points[1][0], points[1][1])}${square(points[2][0], points[2][1])}${disc(points[3][0], points[3][1])}
        ${diamond(px, py)}
        <text class="middle math" x=${px} y=${height - 14}>x</text><text class="end math" x=${left - 9} y=${py + 4}>y</text>
        <text class="quiet middle" x=${left} y=${height - 14}>${this.x > 0.06 ? 0 : ""}</text><text class="quiet middle" x=${left + scale} y=${height - 14}>${this.x < 0.94 ? 1 : ""}</text>
      </svg>
    `;
  }

  time() {
    const curve = curveOf(this.value);
    const t = this.x <= 0 ? 0 : this.x >= 1 ? 1 : curve.timesAtCoordinate({ x: this.x })[0];
    const wrong = curve.eval(this.x);
    return html`
      <div class="frame">
        <div class="stage">${this.square()}</div>
        <p class="facts">
          At the time <i>x</i> = ${decimal(this.x, 3)} the curve stands at <i>t</i> = <b class="t">${decimal(t ?? 0, 4)}</b>, for there <i>x</i>(<i>t</i>) = ${decimal(this.x, 3)}; the
          answer is <i>y</i>(<i>t</i>) = <b class="y">${decimal(timing(this.value)(this.x), 4)}</b>. Taking the time for <i>t</i> would give ${decimal(wrong.y, 4)}, and the point
          (${decimal(wrong.x, 3)}, ${decimal(wrong.y, 3)}), which belongs to another moment.
        </p>
        <div class="controls">
          <fieldset><legend>Marks at equal steps of</legend>
            ${[
              ["t", html`<i>t</i>`],
              ["x", html`time`],
            ].map(
              ([key, words]) =>
                html`<label><input type="radio" name="even" .checked=${this.even === key} @change=${() => (this.even = String(key))} />${words}</label>`,
            )}
          </fieldset>
          ${slider({
            name: html`time <i>x</i>`,
            value: this.x,
            min: 0,
            max: 1,
            step: 0.005,
            text: decimal(this.x),
            change: (x) => {
              this.stop();
              this.x = x;
            },
          })}
        </div>
      </div>
    `;
  }

  code() {
    const seconds = `${this.duration / 1000}s`;
    const numbers = css(this.value).slice("cubic-bezier(".length, -1);
    return html`
      <div class="frame">
        ${codeBox({ name: "CSS", text: `.box {\n  transition: transform ${seconds} ${css(this.value)};\n}\n.box:hover {\n  transform: translateX(10rem);\n}\n@media (prefers-reduced-motion: reduce) {\n  .box { transition: none; }\n}` })}
        ${codeBox({ name: "JavaScript", text: `import { easing } from "casteljau";\n\nconst ease = easing(${numbers});\nease(${Number(this.x.toFixed(3))}); // ${timing(this.value)(Number(this.x.toFixed(3)))}` })}
      </div>
    `;
  }

  render() {
    return html`
      ${this.presets()}
      <h2>Animation</h2>
      <p class="say">The left animation uses your curve, the right one another curve, over the same time. Drag the time slider to compare them at one moment.</p>
      ${this.previews()}
      <h2>The time is x, not t</h2>
      <p class="say">
        A timing function is a Bézier curve from (0, 0) to (1, 1). The time is <i>x</i> and the progress is <i>y</i>; the parameter <i>t</i> is neither. For a time <i>x</i>, the browser finds the
        <i>t</i> at which the curve has this <i>x</i>, and returns the <i>y</i> of that point. Because the handles stay within 0 ≤ <i>x</i> ≤ 1, there is exactly one such <i>t</i>.
        If <i>y</i> leaves the range from 0 to 1, the animation overshoots.
      </p>
      ${this.time()}
      <h2>Code</h2>
      ${this.code()}
    `;
  }
}
