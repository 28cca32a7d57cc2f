// <camera-path>: what a camera on a path sees, where it is, its speed and its frames.
import { arrowDirection } from "#js/ui/keys.js";
import { capture } from "#js/ui/capture.js";
import { css, html, svg } from "lit";
import { codeBox } from "../figures/lib/code-box.js";
import { Figure } from "../figures/lib/figure.js";
import { check, choice, handle, list, pathOf, playButton, slider } from "../figures/lib/parts.js";
import { decimal, short } from "../figures/lib/numbers.js";
import { PANES, toolStyle } from "../figures/lib/tool.js";
import { cameraCode } from "./code.js";
import { equalSteps, framesOf, lookingAt, pathThrough, timeAt } from "./path.js";
import { rolls, strip } from "./plots.js";
import { cameraIn, drawCamera, drawFrames, drawScene, line, orbiting, stroke, TEAPOT_MIDDLE } from "./scene.js";
import { added, BOX, FEWEST_POINTS, FIRST, moved, removed } from "./state.js";

const HALF_SIGHT = 0.7; // radians: 80° across
const DRAWN_FRAMES = 40;
const SECONDS = 14;
const DEGREES_PER_PIXEL = 0.4;
const DEGREES_PER_KEY = 5;
const COLOURS = /** @type {const} */ (["ink", "quiet", "grid", "curve", "handle", "level1", "level2", "paper"]);

/** `<camera-path>` */
export class CameraPath extends Figure {
  static properties = {
    state: { attribute: false },
    progress: { state: true },
    chosen: { state: true },
    playing: { state: true },
    orbit: { state: true },
  };
  static styles = [
    Figure.styles,
    toolStyle,
    css`
    .views { display: grid; gap: 4px; background: var(--ground); }
    .view { position: relative; background: var(--paper); min-inline-size: 0; }
    .view > b { position: absolute; inset: 0.5rem auto auto 0.8rem; font-size: 0.8125rem; font-weight: 400; color: var(--quiet); pointer-events: none; }
    canvas { display: block; inline-size: 100%; block-size: auto; aspect-ratio: 3 / 2; background: var(--paper); }
    .transport { background: var(--paper); }
    @container (min-width: ${PANES}px) {
      .views { grid-template-columns: minmax(0, 2fr) minmax(0, 1fr); grid-template-rows: auto auto auto; }
      .eye { grid-area: 1 / 1 / 3 / 2; }
      .outside { grid-area: 1 / 2; }
      .above { grid-area: 2 / 2; }
      .views > .transport { grid-area: 3 / 1 / 4 / 3; }
      #eye { position: absolute; inset: 0; block-size: 100%; aspect-ratio: auto; }
    }
    .frame + .say { margin-block-start: 1.5rem; }
    .key-line { display: inline-block; inline-size: 1.1rem; block-size: 0; border-block-start: 3px solid; vertical-align: middle; margin-inline: 0.6rem 0.3rem; }
  `,
  ];

  constructor() {
    super();
    this.state = FIRST;
    this.path = pathThrough(FIRST.points, FIRST);
    this.length = 0;
    /** @type {Float64Array} */
    this.line = new Float64Array();
    /** @type {Float64Array} */
    this.stops = this.line;
    /** @type {import("./path.js").Frame[]} */
    this.frames = [];
    this.progress = 0;
    this.chosen = 3;
    this.playing = false;
    this.orbit = { turn: -62, tilt: 30 };
    this.frame = 0;
    this.themes = [matchMedia("(prefers-color-scheme: dark)"), matchMedia("(forced-colors: active)")];
    this.repaint = () => this.requestUpdate();
    this.here = this.where();
  }

  connectedCallback() {
    super.connectedCallback();
    for (const theme of this.themes) theme.addEventListener("change", this.repaint);
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    for (const theme of this.themes) theme.removeEventListener("change", this.repaint);
    this.stop();
  }

  /** How many equal times are marked. */
  get steps() {
    return this.wide < 520 ? 24 : 48;
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (changed.has("state") || changed.has("wide")) this.follow();
    this.here = this.where();
  }

  /** What depends on the path alone. */
  follow() {
    this.path = pathThrough(this.state.points, this.state);
    this.length = this.path.length();
    this.chosen = Math.min(this.chosen, this.state.points.length - 1);
    this.line = this.path.sample(24);
    this.stops = this.path.evalAt(equalSteps(this.path, this.steps, this.state.even));
    this.frames = framesOf(this.path, this.path.equidistantTimes(DRAWN_FRAMES), this.state.frames);
  }

  /** The camera now. */
  where() {
    const t = timeAt(this.path, this.progress, this.state.even);
    // Frenet's frame keeps its last answer where the path is straight, so it is asked all along the way.
    const ts = [...Array.from({ length: 60 }, (_, i) => (t * i) / 60), t];
    const frame = /** @type {import("./path.js").Frame} */ (framesOf(this.path, ts, this.state.frames).at(-1));
    return {
      t,
      frame,
      camera: cameraIn(this.state.look === "teapot" ? lookingAt(frame, TEAPOT_MIDDLE) : frame, HALF_SIGHT),
    };
  }

  play() {
    if (this.playing) return this.stop();
    this.playing = true;
    let before = performance.now();
    const step = (/** @type {number} */ now) => {
      // The time of the first frame may be earlier than the call of play().
      const next = this.progress + Math.max(now - before, 0) / 1000 / SECONDS;
      before = now;
      this.progress = next <= 1 ? next : 0;
      this.frame = requestAnimationFrame(step);
    };
    this.frame = requestAnimationFrame(step);
  }

  stop() {
    cancelAnimationFrame(this.frame);
    this.playing = false;
  }

  /** @param {import("./state.js").State} state */
  change(state) {
    this.state = state;
    this.notifyChange();
  }

  updated() {
    const style = getComputedStyle(this);
    const colours = Object.fromEntries(COLOURS.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
    const { camera, frame } = this.here;
    this.paint("eye", camera, (drawContext) => {
      drawScene(drawContext, /** @type {any} */ (colours));
      stroke(drawContext, colours.handle, 1.5, () => line(drawContext, this.line));
    });
    this.paint("outside", orbiting(this.orbit.turn, this.orbit.tilt, 38), (drawContext) => {
      drawScene(drawContext, /** @type {any} */ (colours));
      stroke(drawContext, colours.quiet, 1.5, () => line(drawContext, this.line));
      drawFrames(drawContext, this.frames, 0.9, /** @type {any} */ (colours));
      drawFrames(drawContext, [frame], 1.6, /** @type {any} */ (colours));
      drawCamera(drawContext, { ...camera, angle: 0.5 }, 1.3, colours.ink);
    });
  }

  /** @param {string} name @param {import("./scene.js").Camera} camera @param {(drawContext: import("./scene.js").DrawContext) => void} draw */
  paint(name, camera, draw) {
    const canvas = /** @type {HTMLCanvasElement} */ (this.renderRoot.querySelector(`#${name}`));
    const width = canvas.clientWidth;
    if (!width) return;
    const height = canvas.clientHeight;
    const sharp = devicePixelRatio;
    const size = [width, height].map((side) => Math.round(side * sharp));
    if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
    const ctx = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    ctx.setTransform(sharp, 0, 0, sharp, 0, 0);
    ctx.clearRect(0, 0, width, height);
    draw({ ctx, width, height, camera });
  }

  /** @param {PointerEvent} start */
  drag(start) {
    if (start.button !== 0) return;
    const { turn, tilt } = this.orbit;
    capture(start, {
      move: (event) =>
        this.orbitTo(
          turn - (event.clientX - start.clientX) * DEGREES_PER_PIXEL,
          tilt + (event.clientY - start.clientY) * DEGREES_PER_PIXEL,
        ),
    });
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const arrow = arrowDirection(event);
    if (!arrow || event.altKey) return;
    event.preventDefault();
    this.orbitTo(this.orbit.turn - arrow[0] * DEGREES_PER_KEY, this.orbit.tilt + arrow[1] * DEGREES_PER_KEY);
  }

  /** @param {number} turn @param {number} tilt */
  orbitTo(turn, tilt) {
    this.orbit = { turn, tilt: Math.min(Math.max(tilt, 2), 88) };
  }

  /** Seen from above, with handles. */
  top() {
    const wide = this.wide >= PANES ? Math.round(this.wide / 3) : this.wide;
    const height = Math.round((wide * 2) / 3);
    const scale = Math.min(wide / (BOX.max[0] - BOX.min[0]), height / (BOX.max[1] - BOX.min[1])) * 0.9;
    const [cx, cy] = [0, 1].map((k) => (BOX.min[k] + BOX.max[k]) / 2);
    const place = (/** @type {readonly number[]} */ [x, y]) =>
      /** @type {[number, number]} */ ([wide / 2 + (x - cx) * scale, height / 2 - (y - cy) * scale]);
    const unplace = (/** @type {readonly number[]} */ [px, py]) =>
      /** @type {[number, number]} */ ([cx + (px - wide / 2) / scale, cy - (py - height / 2) / scale]);
    const flat = (/** @type {ArrayLike<number>} */ points) =>
      Array.from({ length: points.length / 3 }, (_, i) => place([points[3 * i], points[3 * i + 1]])).flat();
    const stops = flat(this.stops);
    const { frame } = this.here;
    const [ex, ey] = place(frame.point);
    const [tx, ty] = [frame.tangent[0], -frame.tangent[1]];
    return html`
      <svg viewBox="0 0 ${wide} ${height}" role="img" aria-label="The path from above, with marks at equal times; ${this.state.points.length} points to drag">
        <circle class="ghost" cx=${place([0, 0])[0]} cy=${place([0, 0])[1]} r=${2 * scale} /><path class="ghost" d=${pathOf([...place([2, 0]), ...place([3.4, 0])])} />
        <path class="curve" d=${pathOf(flat(this.line))} />
        ${Array.from({ length: stops.length / 2 }, (_, i) => svg`<circle class="stop" cx=${stops[2 * i]} cy=${stops[2 * i + 1]} r="3" fill="var(--paper)" stroke="var(--handle)" stroke-width="1.5" />`)}
        ${this.state.points.map((point, k) => {
          const [x, y] = place(point);
          return svg`<circle class="on" cx=${x} cy=${y} r=${k === this.chosen ? 8 : 6} /><text class="haloed middle ${k === this.chosen ? "strong" : ""}" x=${x} y=${y - 13}>${k + 1}</text>`;
        })}
        <path class="at" d="M${ex + 11 * tx} ${ey + 11 * ty}L${ex - 7 * tx - 7 * ty} ${ey - 7 * ty + 7 * tx}L${ex - 7 * tx + 7 * ty} ${ey - 7 * ty - 7 * tx}Z" />
      </svg>
      ${this.state.points.map((point, k) =>
        handle({
          name: `Point ${k + 1}`,
          at: [point[0], point[1]],
          place,
          unplace,
          size: [wide, height],
          box: { min: [BOX.min[0], BOX.min[1]], max: [BOX.max[0], BOX.max[1]] },
          step: 0.1,
          say: (value) => short(value, 2),
          move: ([x, y]) => (this.state = moved(this.state, k, [x, y, point[2]])),
          done: () => this.notifyChange(),
          focus: () => (this.chosen = k),
        }),
      )}
    `;
  }

  transport() {
    return html`
      <div class="controls transport">
        ${playButton({ playing: this.playing, toggle: () => this.play() })}
        ${slider({
          name: "Time",
          value: this.progress,
          min: 0,
          max: 1,
          step: 0.001,
          text: decimal(this.progress),
          change: (progress) => {
            this.stop();
            this.progress = progress;
          },
        })}
      </div>
    `;
  }

  controls() {
    const { state } = this;
    const set = (/** @type {Partial<import("./state.js").State>} */ part) => this.change({ ...state, ...part });
    return html`
      <div class="controls">
        ${choice({
          name: "Speed",
          options: [
            [true, "even"],
            [false, html`raw <i>t</i>`],
          ],
          value: state.even,
          change: (even) => set({ even }),
        })}
        ${choice({
          name: "Frame",
          options: [
            ["minimising", "rotation-minimizing"],
            ["frenet", "Frenet"],
            ["upright", "upright"],
          ],
          value: state.frames,
          change: (frames) => set({ frames: /** @type {import("./path.js").FrameKind} */ (frames) }),
        })}
        ${choice({
          name: "Look",
          options: [
            ["ahead", "ahead"],
            ["teapot", "at the teapot"],
          ],
          value: state.look,
          change: (look) => set({ look: /** @type {"ahead" | "teapot"} */ (look) }),
        })}
      </div>
      <div class="controls">
        ${slider({
          name: `Height of point ${this.chosen + 1}`,
          value: state.points[this.chosen][2],
          min: BOX.min[2],
          max: BOX.max[2],
          step: 0.1,
          text: decimal(state.points[this.chosen][2], 1),
          change: (z) =>
            this.change(moved(state, this.chosen, [state.points[this.chosen][0], state.points[this.chosen][1], z])),
        })}
        <div class="row">
          <button @click=${() =>
            this.change(
              added(state, this.chosen, (t) => {
                const { x, y, z } = /** @type {any} */ (this.path.eval(t));
                return [x, y, z];
              }),
            )}>Add a point after ${this.chosen + 1}</button>
          <button ?disabled=${state.points.length <= FEWEST_POINTS} @click=${() => this.change(removed(state, this.chosen))}>Delete point ${this.chosen + 1}</button>
          <button @click=${() => this.change(FIRST)}>Reset</button>
        </div>
        ${list({
          name: "Path",
          options: [
            ["natural", "natural spline"],
            ["catmull-rom", "centripetal Catmull-Rom"],
          ],
          value: state.kind,
          change: (kind) => set({ kind: /** @type {"natural"} */ (kind) }),
        })}
        ${check({ name: "closed", value: state.closed, change: (closed) => set({ closed }) })}
      </div>
    `;
  }

  render() {
    const { frame, t } = this.here;
    const where = frame.point.map((value) => short(value, 1)).join(", ");
    return html`
      <div class="frame">
        <div class="views">
          <div class="view eye"><canvas id="eye" role="img" aria-label="What the camera sees from (${where})"></canvas><b>What the camera sees</b></div>
          ${this.transport()}
          <div class="view outside"><canvas id="outside" class="orbit" role="img" tabindex="0" aria-label="The scene from outside: path, frames and camera; arrow keys turn it" @pointerdown=${this.drag} @keydown=${this.key}></canvas><b>From outside</b></div>
          <div class="view stage above">${this.top()}<b>From above: drag the points</b></div>
        </div>
        <p class="facts">At <i>t</i> = <b class="t">${decimal(t, 3)}</b> of ${this.path.segmentCount}, the camera is at (${where}); the path is ${decimal(this.length, 2)} long.</p>
        ${this.controls()}
      </div>
      <p class="say">Drag the points in the view from above, and set the height of the selected one with the slider. The address of this page contains your path, so you can share it.</p>
      <h2>Constant speed</h2>
      <p class="say">
        The parameter <i>t</i> of a spline increases by 1 between two neighbouring points, whatever their distance. A camera that follows <i>t</i> is slow where points are close and fast where they are far apart. For constant speed,
        compute the length that the camera has to have travelled, and ask for the <i>t</i> at that arc length.
      </p>
      <div class="frame"><div class="stage">${strip(this)}</div></div>
      <h2>Which way is up?</h2>
      <p class="say">
        The path determines the direction of view, but not which way is up. The Frenet frame uses the direction in which the path bends: where the bend changes sides, the camera turns over. A rotation-minimizing frame does not
        rotate about the path at all.
      </p>
      <div class="frame"><div class="stage">${rolls(this)}</div></div>
      <h2>Code</h2>
      <div class="frame">${codeBox({ name: "JavaScript", text: cameraCode(this.state, this.progress, frame.point) })}</div>
    `;
  }
}
