// The easing tool: the curve with its handles, presets, animations beside another timing function, code.
import { css as styles, html, svg } from "lit";
import { Curve, easing } from "casteljau";
import { codeTabs } from "../figures/lib/code-box.js";
import { Figure } from "../figures/lib/figure.js";
import {
  choice,
  diamond,
  disc,
  handle,
  list,
  playButton,
  polyline,
  ring,
  slider,
  square,
} from "../figures/lib/parts.js";
import { decimal } from "../figures/lib/numbers.js";
import { PANES, toolStyle } from "../figures/lib/tool.js";
import { css, parse, PRESETS, same } from "./value.js";

/** Marks of equal steps. */
const STEPS = 20;
const HOLD_MS = 500;
/** The heights that the picture always shows, and what it adds to handles beyond them. */
const HEIGHTS = { min: -0.12, max: 1.12 };
const HANDLE_MARGIN = 0.1;
/** The part of the window's height that the bar, the heading and the time slider need, in CSS pixels. */
const AROUND_PICTURE_PX = 272;
const MIN_SIDE_PX = 320;
const HANDLE_STEP = 0.01;
/** The distance between the curve and the linear() of the code. */
const LINEAR_TOLERANCE = 0.005;

/** What the previews do with y: from 0 to 1, and beyond. @type {readonly (readonly [string, (y: number) => Record<string, string>])[]} */
const PREVIEWS = [
  ["move", (y) => ({ left: `calc(${y} * (100% - 2.2rem))` })],
  ["scale", (y) => ({ left: "calc(50% - 1.1rem)", transform: `scale(${Math.max(0, 0.25 + 0.75 * y)})` })],
  ["fade", (y) => ({ left: "calc(50% - 1.1rem)", opacity: String(Math.min(Math.max(y, 0), 1)) })],
  ["turn", (y) => ({ left: "calc(50% - 1.1rem)", transform: `rotate(${180 * y}deg)` })],
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

/** @param {readonly number[]} value @returns {{ min: number, max: number }} the heights that the picture shows */
const heightsOf = ([, y1, , y2]) => ({
  min: Math.min(HEIGHTS.min, y1 - HANDLE_MARGIN, y2 - HANDLE_MARGIN),
  max: Math.max(HEIGHTS.max, y1 + HANDLE_MARGIN, y2 + HANDLE_MARGIN),
});

/** `<easing-lab>`: dispatches "change" at the end of each change. */
export class EasingLab extends Figure {
  static properties = {
    value: { attribute: false },
    against: { state: true },
    x: { state: true },
    duration: { state: true },
    problem: { state: true },
    even: { state: true },
    playing: { state: true },
    code: { state: true },
    heights: { state: true },
  };
  static styles = [
    Figure.styles,
    toolStyle,
    styles`
    :host { --side: minmax(0, 32rem); }
    .panes { gap: 0 1rem; }
    .stage { margin-inline: auto; max-inline-size: 100%; }
    .arm { fill: none; stroke: var(--handle); stroke-width: 1.5; }
    .unit { fill: var(--raised); stroke: none; }
    .side > .row { padding: 0.6rem 0.9rem 0; }
    .lanes { display: grid; grid-template-columns: auto 1fr 1fr; gap: 0.4rem 0.9rem; align-items: center; padding: 0.6rem 0.9rem; }
    .lanes > span { color: var(--quiet); font-size: 0.8125rem; }
    .lane { position: relative; block-size: 2.6rem; border-radius: 8px; background: var(--raised); overflow: clip; overflow-clip-margin: 1.5rem; }
    .lane span { position: absolute; inset-block-start: 0.2rem; inline-size: 2.2rem; block-size: 2.2rem; border-radius: 8px; border: 2px solid var(--curve); background: var(--curve); }
    .lane .other { border-color: var(--handle); background: var(--paper); }
    .lane span::after { content: ""; position: absolute; inset: 4px auto auto 50%; inline-size: 2px; block-size: 0.6rem; background: var(--paper); }
    .lane .other::after { background: var(--handle); }
    .text { flex: 1 1 20rem; }
    .text input { flex: 1; min-inline-size: 0; font-family: ui-monospace, Menlo, Consolas, monospace; }
    @media (forced-colors: active) { .lane span { forced-color-adjust: none; background: CanvasText; } .lane .other { background: Canvas; } }
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
    this.code = 0;
    this.frame = 0;
    /** What the picture shows; it stays as it is while a handle is dragged. */
    this.heights = heightsOf(this.value);
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.stop();
  }

  /** Takes four numbers, and shows all of their curve. @param {readonly number[]} value */
  set(value) {
    this.value = value;
    this.heights = heightsOf(value);
    this.problem = "";
  }

  /** Takes the text of a timing function; any other text is reported, and the last value is kept. @param {string} text */
  take(text) {
    try {
      this.set(parse(text));
    } catch (error) {
      this.problem = `Not taken: ${/** @type {Error} */ (error).message}. The last good curve is kept.`;
      return;
    }
    this.notifyChange();
  }

  play() {
    if (this.playing) return this.stop();
    const start = performance.now() - (this.x < 1 ? this.x * this.duration : 0);
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
      <div class="row" role="group" aria-label="Presets">
        ${PRESETS.map(([name, value]) => html`<button aria-pressed=${same(value, this.value)} @click=${() => this.take(css(value))}>${name}</button>`)}
      </div>
      <div class="controls">
        <label class="text"><span>Value</span>
          <input type="text" spellcheck="false" .value=${css(this.value)} @change=${(/** @type {Event} */ event) => this.take(/** @type {HTMLInputElement} */ (event.target).value)} /></label>
      </div>
      <p class="problem" role="alert">${this.problem}</p>
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
      <div class="lanes">
        <span></span><span>your curve</span><span>${this.against}</span>
        ${PREVIEWS.map(
          ([name, look]) => html`
          <span>${name}</span>
          <div class="lane"><span class="mine" data-preview=${name} .style=${style(look(mine))}></span></div>
          <div class="lane"><span class="other" .style=${style(look(theirs))}></span></div>`,
        )}
      </div>
      <div class="controls">
        ${slider({
          name: "Duration",
          value: this.duration,
          min: 200,
          max: 4000,
          step: 100,
          text: `${(this.duration / 1000).toFixed(1)} s`,
          change: (ms) => (this.duration = ms),
        })}
        ${list({
          name: "Compare with",
          options: PRESETS.map(([name]) => [name, name]),
          value: this.against,
          change: (name) => (this.against = name),
        })}
      </div>
    `;
  }

  /** How wide and high the picture is: it fits into its pane and into the window. */
  get side() {
    const pane = this.wide < PANES ? this.wide : Math.round(this.wide / 2);
    return Math.min(pane, Math.max(MIN_SIDE_PX, innerHeight - AROUND_PICTURE_PX));
  }

  /** The curve in the unit square, with its handles: the point at the time x, and marks at equal steps of t or of x. */
  picture() {
    const curve = curveOf(this.value);
    const { side } = this;
    const { min, max } = this.heights;
    const scale = side / (max - min);
    const left = (side - scale) / 2;
    const place = (/** @type {readonly number[]} */ [x, y]) =>
      /** @type {[number, number]} */ ([left + x * scale, (max - y) * scale]);
    const unplace = (/** @type {readonly number[]} */ [px, py]) =>
      /** @type {[number, number]} */ ([(px - left) / scale, max - py / scale]);
    const ease = timing(this.value);
    const marks = Array.from({ length: STEPS + 1 }, (_, i) => {
      const { x, y } = this.even === "t" ? curve.eval(i / STEPS) : { x: i / STEPS, y: ease(i / STEPS) };
      return { point: place([x, y]), foot: place([x, 0]) };
    });
    const [px, py] = place([this.x, ease(this.x)]);
    const [x1, y1, x2, y2] = this.value;
    const [start, first, second, end] = [
      [0, 0],
      [x1, y1],
      [x2, y2],
      [1, 1],
    ].map(place);
    const drawn = curve.transform([scale, 0, 0, -scale, left, max * scale]);
    return html`
      <div class="stage" .style=${`inline-size: ${side}px`}>
        <svg viewBox="0 0 ${side} ${side}" role="img" aria-label="The curve of ${css(this.value)}: at the time ${decimal(this.x)} it is at ${decimal(ease(this.x), 3)}">
          <rect class="unit" x=${left} y=${end[1]} width=${scale} height=${scale} />
          ${marks.map(({ foot: [x, y] }) => svg`<path class="axis" d="M${x} ${y}v-7" />`)}
          <path class="axis" d="M${left} ${end[1]}V${start[1]}H${end[0]}" />
          ${polyline("arm", [...start, ...first])}${polyline("arm", [...second, ...end])}
          <path class="curve" d=${drawn.toSVG({ precision: 2 })} />
          ${marks.map(({ point: [x, y] }) => ring(x, y, "var(--curve)", 3))}
          <path class="dropped" d="M${px} ${start[1]}V${py}H${left}" />
          ${disc(start[0], start[1])}${square(first[0], first[1], 7)}${square(second[0], second[1], 7)}${disc(end[0], end[1])}
          ${diamond(px, py)}
          <text class="quiet end" x=${left - 8} y=${start[1] + 4}>0</text><text class="quiet end" x=${left - 8} y=${end[1] + 4}>1</text>
          <text class="quiet end" x=${end[0]} y=${start[1] + 18}>time x</text>
          <text class="quiet middle" transform="translate(${left - 10},${(start[1] + end[1]) / 2}) rotate(-90)">progress y</text>
        </svg>
        ${[0, 1].map((k) =>
          handle({
            name: k ? "Second handle" : "First handle",
            kind: "off",
            at: [this.value[2 * k], this.value[2 * k + 1]],
            place,
            unplace,
            size: [side, side],
            box: { min: [0, min], max: [1, max] },
            step: HANDLE_STEP,
            say: (value) => decimal(value),
            move: (point) => (this.value = this.value.toSpliced(2 * k, 2, ...point.map((v) => Number(v.toFixed(2))))),
            done: () => {
              this.set(this.value);
              this.notifyChange();
            },
          }),
        )}
      </div>
    `;
  }

  time() {
    const curve = curveOf(this.value);
    const t = this.x <= 0 ? 0 : this.x >= 1 ? 1 : curve.timesAtCoordinate({ x: this.x })[0];
    return html`
      <div class="controls transport">
        ${playButton({ playing: this.playing, toggle: () => this.play() })}
        ${slider({
          name: html`Time <i>x</i>`,
          value: this.x,
          min: 0,
          max: 1,
          step: 0.005,
          text: decimal(this.x, 3),
          change: (x) => {
            this.stop();
            this.x = x;
          },
        })}
      </div>
      <p class="facts">
        At this time, <i>t</i> = <b class="t">${decimal(t ?? 0, 4)}</b> and <i>y</i> = <b class="y">${decimal(timing(this.value)(this.x), 4)}</b>.
        At <i>t</i> = ${decimal(this.x, 3)}, <i>y</i> would be ${decimal(curve.eval(this.x).y, 4)}.
      </p>
      <div class="controls">
        ${choice({
          name: "Marks at equal steps of",
          options: [
            ["x", html`<i>x</i>`],
            ["t", html`<i>t</i>`],
          ],
          value: this.even,
          change: (even) => (this.even = even),
        })}
      </div>
    `;
  }

  /** @returns {{ name: string, text: string }[]} */
  codes() {
    const seconds = `${this.duration / 1000}s`;
    const ease = timing(this.value);
    const x = Number(this.x.toFixed(3));
    const numbers = css(this.value).slice("cubic-bezier(".length, -1);
    return [
      {
        name: "CSS",
        text: `.box {\n  transition: transform ${seconds} ${css(this.value)};\n}\n.box:hover {\n  transform: translateX(10rem);\n}\n@media (prefers-reduced-motion: reduce) {\n  .box { transition: none; }\n}`,
      },
      { name: "linear()", text: `.box {\n  transition-timing-function: ${ease.toLinear(LINEAR_TOLERANCE)};\n}` },
      {
        name: "JavaScript",
        text: `import { easing } from "casteljau";\n\nconst ease = easing(${numbers});\nease(${x}); // ${ease(x)}`,
      },
    ];
  }

  render() {
    return html`
      <div class="frame panes">
        <div class="pane">${this.picture()}${this.time()}</div>
        <div class="pane side">
          ${this.presets()}${this.previews()}
          ${codeTabs({ tabs: this.codes(), selected: this.code, select: (index) => (this.code = index) })}
        </div>
      </div>
    `;
  }
}
