import { LitElement, html } from "lit";
import { Surface } from "../../index.js";
import { HOME, frameOf } from "./camera.js";
import { Gestures, ZOOM_STEP } from "./gestures.js";
import { Handles } from "./handles.js";
import { Memo } from "./memo.js";
import { framingPoints, surfaceNamed } from "./models.js";
import { panel } from "./panel.js";
import { settingsOf } from "./settings.js";
import { Stage } from "./stage.js";
import { style } from "./style.js";
import { tools } from "./tools.js";
import { figures, INSTRUCTIONS, MODEL_NAMES, STATES } from "./words.js";

/**
 * @import { View } from "./camera.js"
 * @import { Facts, Scene } from "./geometry.js"
 */

/** The element begins its work when it is so near to what is seen of the page. */
const NEAR = "300px";
/** Where the sliders begin: in radii of the surface, and in pixels. */
const [FIRST_TOLERANCE, FIRST_PIXELS] = [0.005, 1];
const REDUCED_MOTION = "(prefers-reduced-motion: reduce)";

const text = { type: String, reflect: true };
const number = { type: Number, reflect: true };
const flag = { type: Boolean, reflect: true };

/** `<bezier-surface>`; what can be set from outside is documented in ../types.js. */
export class BezierSurface extends LitElement {
  static styles = style;
  static properties = {
    model: text, parts: text, height: text, up: text, shading: text, show: text, evaluation: text, label: text,
    segments: number, tolerance: number, pixels: number, u: number, v: number, step: number, patch: number,
    controls: flag, turn: flag,
  };

  #memo = new Memo();
  /** @type {Surface | null} */
  #given = null;
  /** What was dragged: vertex and place. @type {Map<number, number[]>} */
  #moves = new Map();
  /** @type {Stage | null} */
  #stage = null;
  /** @type {Handles | null} */
  #handles = null;
  /** @type {IntersectionObserver | null} */
  #watch = null;
  /** @type {(() => void) | null} */
  #deafen = null;
  /** @type {View} */
  #camera = HOME;
  /** @type {"webgl" | "flat" | "lost"} */
  #state = "webgl";
  /** @type {Facts | null} */
  #facts = null;
  #wished = false;
  #stopped = false;

  constructor() {
    super();
    this.model = "teapot";
    /** @type {string | null} */
    this.parts = null;
    this.height = "squashed";
    this.up = "z";
    this.shading = "smooth";
    this.show = "surface";
    this.evaluation = "cpu";
    this.label = "";
    this.segments = 12;
    /** @type {number | null} */
    this.tolerance = null;
    /** @type {number | null} */
    this.pixels = null;
    this.u = 0.5;
    this.v = 0.5;
    this.step = 4;
    /** @type {number | null} */
    this.patch = null;
    this.controls = false;
    this.turn = false;
  }

  /** The surface that is shown, moved points and all. */
  get surface() {
    const settings = this.#settings();
    const { model, parts, height, up } = settings;
    const base = this.#memo.get("base", [this.#given, model, [...parts].join(), height, up], () => this.#given ?? surfaceNamed(settings));
    const edit = (/** @type {Surface} */ surface) => [...this.#moves].reduce((moved, [vertex, to]) => moved.movePoint(vertex, to), surface);
    return this.#memo.get("surface", [base, ...this.#moves.values()], () => edit(base));
  }

  set surface(surface) {
    if (surface !== null && !(surface instanceof Surface)) throw new TypeError(`surface: expected a Surface or null, got ${typeof surface}`);
    this.#given = surface;
    this.#moves.clear();
    this.patch = null;
    this.requestUpdate();
  }

  /** Where the eye is: degrees, enlargement, shift in radii. */
  get view() {
    return { ...(this.#stage?.camera ?? this.#camera) };
  }

  set view(view) {
    this.#move(view);
  }

  /**
   * The picture as it is now, a PNG.
   *
   * @returns {Promise<Blob | null>}
   */
  async toBlob() {
    await this.updateComplete;
    return this.#stage?.toBlob() ?? null;
  }

  connectedCallback() {
    super.connectedCallback();
    const observer = new IntersectionObserver((entries) => entries.some((entry) => entry.isIntersecting) && this.#start(), { rootMargin: NEAR });
    observer.observe(this);
    this.#watch = observer;
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#watch?.disconnect();
    this.#deafen?.();
    this.#camera = this.view;
    this.#stage?.end();
    this.#stage = null;
  }

  #start() {
    this.#watch?.disconnect();
    if (this.#stage || !this.isConnected) return;
    const find = (/** @type {string} */ selector) => /** @type {any} */ (this.renderRoot.querySelector(selector));
    const canvas = find("canvas");
    this.#stage = new Stage(canvas, find(".probe"), this.#camera, {
      drawn: (sight, width, height) => {
        this.#handles?.place(sight, width, height);
        this.#tell();
      },
      stateChanged: (state) => {
        this.#state = state;
        this.requestUpdate();
      },
      turning: () => this.#turns(),
    });
    this.#handles ??= new Handles(find(".overlay"), { moved: (...args) => this.#pulled(...args), sight: () => this.#stage?.sight() ?? null });
    const gestures = new Gestures(canvas, {
      view: () => this.view,
      move: (changes, done) => this.#moveByHand(changes, done),
      home: () => this.#moveByHand(HOME, true),
      pick: () => {},
    });
    this.#deafen = gestures.listen();
    this.requestUpdate();
  }

  #settings() {
    const { model, parts, height, up, segments, tolerance, pixels, shading, show, evaluation, u, v, step } = this;
    const given = { model, parts, height, up, segments, tolerance, pixels, shading, show, evaluation, u, v, step };
    return this.#memo.get("settings", Object.values(given), () => settingsOf(given));
  }

  /** @returns {Scene} */
  #scene() {
    const settings = this.#settings();
    const { model, height, up } = settings;
    const surface = this.surface;
    const frame = this.#memo.get("frame", [this.#given, model, height, up], () => frameOf(this.#given?.vertices ?? framingPoints(settings), up));
    const picked = surface.patchCount === 1 ? 0 : this.patch !== null && this.patch >= 0 && this.patch < surface.patchCount ? Math.floor(this.patch) : null;
    return this.#memo.get("scene", [settings, surface, frame, picked], () => ({ settings, surface, frame, picked }));
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (!this.hasUpdated) return;
    if (["model", "height", "up"].some((name) => changed.has(name))) {
      this.#moves.clear();
      if (!changed.has("patch")) this.patch = null;
    }
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    if (changed.has("turn")) this.#stopped = false;
    if (!this.#stage) return;
    const scene = this.#scene();
    this.#handles?.update(scene);
    this.#stage.show(scene);
  }

  #turns() {
    return this.turn && !this.#stopped && (this.#wished || !matchMedia(REDUCED_MOTION).matches);
  }

  /** The read-out follows the mesh. */
  #tell() {
    const facts = this.#stage?.geometry.facts(this.#scene()) ?? null;
    if (JSON.stringify(facts) === JSON.stringify(this.#facts)) return;
    this.#facts = facts;
    this.requestUpdate();
  }

  /** @param {Partial<View>} changes */
  #move(changes) {
    if (this.#stage) this.#stage.move(changes);
    else this.#camera = { ...this.#camera, ...changes };
  }

  /**
   * @param {Partial<View>} changes
   * @param {boolean} done
   */
  #moveByHand(changes, done) {
    if ("turn" in changes && this.#turns()) {
      this.#stopped = true;
      this.requestUpdate();
    }
    this.#move(changes);
    this.#fire(done ? "change" : "input");
  }

  /**
   * @param {number} vertex
   * @param {number[]} to
   * @param {boolean} done
   */
  #pulled(vertex, to, done) {
    this.#moves.set(vertex, to);
    this.requestUpdate();
    this.#fire(done ? "change" : "input");
  }

  /** @param {"input" | "change"} type */
  #fire(type) {
    this.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  }

  /**
   * @param {string} name
   * @param {unknown} value
   * @param {"input" | "change"} type
   */
  #set(name, value, type) {
    Object.assign(this, { [name]: value });
    this.#fire(type);
  }

  #toggleTurning() {
    const turning = !this.#turns();
    [this.#wished, this.#stopped] = [turning, !turning];
    this.turn = turning;
    this.requestUpdate();
    this.#fire("change");
  }

  async #savePicture() {
    const blob = await this.toBlob();
    if (!blob) return;
    const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: `${this.model}.png` });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href));
  }

  render() {
    const settings = this.#settings();
    const name = this.label || `${this.#given ? "A surface of Bézier patches" : MODEL_NAMES[settings.model]}, in three dimensions`;
    const zoomed = (/** @type {number} */ factor) => () => this.#moveByHand({ zoom: this.view.zoom * factor }, true);
    return html`<div class="frame" part="frame" @input=${stopInner} @change=${stopInner}>
      <div class="stage" part="stage" role="group" aria-label=${name}>
        <canvas part="canvas" tabindex="0" role="img" aria-label=${name} aria-describedby="help" width="1" height="1"></canvas>
        <div class="overlay" part="overlay"></div>
        ${tools({ turning: this.#turns(), toggle: () => this.#toggleTurning(), nearer: zoomed(ZOOM_STEP), farther: zoomed(1 / ZOOM_STEP), home: () => this.#moveByHand(HOME, true) })}
        <p class="message" role="status">${STATES[this.#state]}</p>
      </div>
      <p class="away" id="help">${INSTRUCTIONS}</p>
      ${this.#readOut()}
      ${this.controls ? panel(this.#panelPort()) : ""}
      <span class="probe" hidden></span>
    </div>`;
  }

  /** @returns {import("./panel.js").PanelPort} */
  #panelPort() {
    return {
      settings: this.#settings(),
      size: this.#scene().frame.radius,
      named: !this.#given,
      edited: this.#moves.size > 0,
      set: (...args) => this.#set(...args),
      setFineness: (kind) => this.#setFineness(kind),
      restore: () => this.#restore(),
      savePicture: () => this.#savePicture(),
    };
  }

  /** @param {"segments" | "tolerance" | "pixels"} kind */
  #setFineness(kind) {
    const tolerance = Number((this.#scene().frame.radius * FIRST_TOLERANCE).toPrecision(1));
    Object.assign(this, { tolerance: kind === "tolerance" ? tolerance : null, pixels: kind === "pixels" ? FIRST_PIXELS : null });
    this.#fire("change");
  }

  #restore() {
    this.#moves.clear();
    this.requestUpdate();
    this.#fire("change");
  }

  #readOut() {
    const facts = this.#facts;
    if (!facts) return html`<p class="facts" part="facts">&nbsp;</p>`;
    const many = (/** @type {number} */ count) => count.toLocaleString("en").replaceAll(",", "\u2009");
    return html`<p class="facts" part="facts">
      <span><b>${many(facts.triangles)}</b> triangles</span>
      <span><b>${many(facts.vertices)}</b> vertices</span>
      <span>error ≤ <b>${figures(facts.error)}</b> ${facts.unit}</span>
      <span>${facts.ms === null ? "by the graphics card" : html`<b>${facts.ms.toFixed(1)}</b> ms`}</span>
    </p>`;
  }
}

/**
 * Events of the controls inside stay inside: the element fires its own.
 *
 * @param {Event} event
 */
function stopInner(event) {
  event.stopPropagation();
}
