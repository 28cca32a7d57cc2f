import { css, html, nothing } from "lit";
import { easing } from "../../easing.js";
import { Fields } from "../../ui/number-fields.js";
import { HandleDrag, handle } from "./easing-handles.js";
import { picture } from "./easing-picture.js";
import { Preview } from "./preview.js";
import { style } from "./style.js";
import { checkAbscissa, heightsOf, presetOf, PRESETS, PRESET_NAMES, readTiming, timingText } from "./timing.js";
import { translated } from "../../editor/translations.js";
import type { FormField } from "./form-field.js";
import type { Handles, Heights } from "./timing.js";

const COORDINATES = ["x1", "y1", "x2", "y2"];

/** The element. */
type Host = FormField & { value: string; handles: Handles; choose: (handles: Handles, done: boolean) => void };

/**
 * What `<bezier-easing>` shows.
 *
 * @csspart stage - the picture with its handles
 * @csspart plot - the picture
 * @csspart handle - each handle (its hit area)
 * @csspart preset - the choice of a common curve
 * @csspart field - each of the four numbers
 * @csspart track - the track of the ball
 * @csspart ball - the ball, which moves by the timing function
 * @csspart value - the text of the value
 */
export class EasingView {
  static styles = [
    style,
    css`
    .parts { display: grid; grid-template-columns: minmax(0, 17rem) minmax(0, 1fr); }
    @container (max-width: 420px) { .parts { grid-template-columns: minmax(0, 1fr); } }
    .stage { position: relative; background: var(--bz-paper); touch-action: pan-y; }
    .stage > svg { display: block; inline-size: 100%; }
    .square { fill: none; stroke: var(--bz-rim); } .axis { stroke: var(--bz-field); } .beyond { fill: var(--bz-panel); }
    .curve { fill: none; stroke: var(--bz-curve); stroke-width: 3; stroke-linecap: round; } .arm { stroke: var(--bz-handle); stroke-width: 1.5; }
    .end { fill: var(--bz-curve); } .now { fill: var(--bz-paper); stroke: var(--bz-ink); stroke-width: 2; } text { font-size: 11px; fill: var(--bz-quiet); }
    .unset .curve { stroke-dasharray: 5 5; }
    .handle { position: absolute; inline-size: var(--bz-hit); block-size: var(--bz-hit); margin: calc(var(--bz-hit) / -2) 0 0 calc(var(--bz-hit) / -2); touch-action: none; cursor: grab; }
    .handle:active { cursor: grabbing; }
    .handle::before { content: ""; position: absolute; inset: 0; margin: auto; inline-size: 14px; block-size: 14px; border-radius: 3px; background: var(--bz-handle); border: 2px solid var(--bz-paper); }
    .handle:hover::before { scale: 1.2; } .handle:focus-within { z-index: 1; outline: 2px solid var(--bz-accent); outline-offset: -1px; border-radius: 50%; }
    .handle input { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; margin: 0; opacity: 0; pointer-events: none; }
    .side { display: grid; gap: 0.7rem; align-content: center; padding: 0.8rem; }
    .numbers { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 0.4rem 0.8rem; align-items: start; }
    .numbers label { display: grid; grid-template-columns: 1.4rem minmax(0, 1fr); align-items: center; } .numbers input { inline-size: 100%; min-inline-size: 0; } .numbers .error { grid-column: 1 / -1; }
    .numbers sub { font-size: 0.7em; }
    .preset { display: flex; } .preset select { flex: 1; min-inline-size: 0; }
    .play { display: flex; gap: 0.7rem; align-items: center; }
    .track { position: relative; flex: 1; block-size: 28px; border-block-end: 1px solid var(--bz-field); }
    .ball { position: absolute; inset-block-start: 3px; inset-inline-start: 20%; inline-size: 22px; block-size: 22px; margin-inline-start: -11px; border-radius: 50%; background: var(--bz-curve); border: 1px solid var(--bz-paper); }
    .track::before, .track::after { content: ""; position: absolute; inset-block: 16px 0; border-inline-start: 1px solid var(--bz-field); inset-inline-start: 20%; } .track::after { inset-inline-start: 80%; }
    output { font: 0.8125rem/1.5 ui-monospace, "SF Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; user-select: all; }
    @media (forced-colors: active) { .ball, .handle::before { forced-color-adjust: none; } }
  `,
  ];

  #host;
  /** What is shown; it stands still while a handle is dragged. */
  #heights: Heights = heightsOf(PRESETS.ease);
  #fields = new Fields({
    read: (key) => this.#host.handles[Number(key)],
    write: (key, value, done) => this.#set(Number(key), value, done),
    changed: () => this.#host.requestUpdate(),
    paste: (_, text) => this.#pasted(text),
  });
  #drag = new HandleDrag({
    handles: () => this.#host.handles,
    heights: () => this.#heights,
    move: (handles, done) => this.#host.choose(handles, done),
  });
  #preview = new Preview(() => this.#host.renderRoot as ShadowRoot);

  constructor(host: Host) {
    this.#host = host;
  }

  stop() {
    this.#preview.stop();
  }

  onChange(done: boolean) {
    if (done && !matchMedia("(prefers-reduced-motion: reduce)").matches) this.#play();
  }

  #set(k: number, value: number, done: boolean) {
    if (k % 2 === 0) checkAbscissa(COORDINATES[k], value);
    this.#host.choose(this.#host.handles.map((x, i) => (i === k ? value : x)) as Handles, done);
  }

  #pasted(text: string) {
    try {
      this.#host.choose(readTiming(text), true);
    } catch {
      return false;
    }
    this.#fields.leave();
    return true;
  }

  #play() {
    this.#preview.play(easing(...(this.#host.handles as Handles)), this.#heights);
  }

  content() {
    const name = this.#host.nameFor(translated("Easing"));
    if (!this.#drag.busy) this.#heights = heightsOf(this.#host.handles);
    const [handles, heights, off] = [this.#host.handles, this.#heights, this.#host.off];
    return html`<div class="frame parts ${this.#host.value ? "" : "unset"}" part="frame" role="group" aria-label=${name}>
      <div class="stage" part="stage">${picture(handles, heights, `${name}: ${timingText(handles)}`)}
        ${off ? nothing : [0, 1].map((which) => handle(which, handles, heights, this.#drag))}</div>
      <div class="side">
        <label class="preset" part="preset">${translated("Preset")} <select ?disabled=${off} @change=${(event: Event) => this.#preset((event.target as HTMLSelectElement).value)}>${this.#options()}</select></label>
        <div class="numbers">${COORDINATES.map((each, k) => html`<label><i>${each[0]}<sub>${each[1]}</sub></i>${this.#fields.field(String(k), each, { step: "0.01", decimals: 4, disabled: off })}</label>`)}</div>
        <div class="play"><button type="button" @click=${() => this.#play()}>${translated("Play")}</button><div class="track" part="track" aria-hidden="true"><div class="ball" part="ball"></div></div></div>
        <output part="value" aria-live="off">${this.#host.value || translated("nothing chosen")}</output>
      </div>
    </div>`;
  }

  #options() {
    const selected = this.#host.value ? presetOf(this.#host.handles) : "none";
    const option = (word: string, text: string) =>
      html`<option value=${word} .selected=${word === selected}>${text}</option>`;
    const first =
      selected === "none"
        ? option("none", translated("choose one"))
        : selected === ""
          ? option("", translated("your own"))
          : nothing;
    return [first, ...Object.keys(PRESETS).map((word) => option(word, PRESET_NAMES[word] ?? word))];
  }

  #preset(word: string) {
    if (!PRESETS[word]) return;
    this.#fields.clear();
    this.#host.choose([...PRESETS[word]], true);
  }
}
