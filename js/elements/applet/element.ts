import { css, html, LitElement } from "lit";
import { adoptProperties } from "../adopt.js";
import { acceptAttributeText, CONTROLS, writeAttribute } from "../attribute-text.js";
import { defineProperties, FIELD_NAMES } from "./attributes.js";
import { AppletModel } from "./model.js";
import * as commands from "../../editor/commands.js";
import { figureOf } from "../../editor/figure.js";
import { FIELDS, jsonOf, stateOf } from "../../editor/schema.js";
import { allPointsToggled, firstState, weightsOf } from "../../editor/state.js";
import { missing } from "../loading.js";
import { whenIdle } from "../start-queue.js";
import { loadDrawing, loadRational } from "./loading.js";
import { publicFigure } from "./report.js";
import type { PropertyDeclaration } from "lit";
import type { AppletController } from "./controller.js";
import type { Language } from "../../editor/code.js";
import type { Point2, State } from "../../editor/state.js";
import type { AppletProperties } from "../types.js";
import type { frame } from "./frame.js";

/** Root margin for lazy loading. */
const NEAR = "300px";

/** Defaults are not reflected. */
const text = (first: string) => ({
  converter: {
    fromAttribute: (value: string | null) => value ?? first,
    toAttribute: (value: unknown) => (value === first ? null : String(value)),
  },
  reflect: true,
});

/** `<bezier-applet>`; what can be set from outside is documented in ../types.js. */
export class BezierApplet extends LitElement {
  declare controls: string | boolean | null;
  declare readonly: boolean;
  declare hotkeys: string;
  declare theme: string;
  declare label: string;

  static properties = {
    controls: CONTROLS,
    readonly: { type: Boolean, reflect: true },
    hotkeys: text("on"),
    theme: text("auto"),
    label: text(""),
  };

  static getPropertyDescriptor(name: PropertyKey, key: string | symbol, options: PropertyDeclaration) {
    // biome-ignore lint/complexity/noThisInStatic: Lit's method reads the prototype of the class it is called on
    return acceptAttributeText(super.getPropertyDescriptor(name, key, options), name, options);
  }

  static get observedAttributes() {
    // biome-ignore lint/complexity/noThisInStatic: Lit's getter reads the properties of the class it is called on
    return [...super.observedAttributes, ...FIELD_NAMES.keys()];
  }

  /** Until the rest has come: as large as it will be, with what the page put into it. */
  static styles = css`
    :host { display: block; box-sizing: border-box; inline-size: 670px; max-inline-size: 100%; }
    :host([hidden]) { display: none; }
    .poster { aspect-ratio: 670 / 480; }
    .poster ::slotted(*) { inline-size: 100%; block-size: 100%; }
  `;

  /**
   * What is shown: the state of the editor and the messages.
   *
   * @internal
   */
  model = new AppletModel(this);
  #watch: IntersectionObserver | null = null;
  /** What the user can do, and everything in the shadow root; null before they are loaded. */
  #view: { controller: AppletController; frame: typeof frame } | null = null;
  /** Whether it is near now. */
  #visible = false;
  /** Whether it is near, or was since it came into the page. */
  #near = false;
  /** The state of the last event `update`. */
  #updatedState: State | null = null;

  constructor() {
    super();
    this.controls = null;
    this.readonly = false;
    this.hotkeys = "on";
    this.theme = "auto";
    this.label = "";
  }

  /** All points, also the hidden ones; a copy. */
  get points(): Point2[] {
    return this.model.state.points.map(([x, y]) => [x, y]);
  }

  set points(points) {
    if (writeAttribute(this, "points", points)) return;
    this.#assign((state) => FIELDS.points.put(state, points));
  }

  /** The mode of each inner joint. */
  get joints() {
    return commands.modesOf(this.model.state);
  }

  set joints(joints) {
    if (writeAttribute(this, "joints", joints)) return;
    this.#assign((state) => commands.withJoints(state, FIELDS.joints.put(state, joints).joints));
  }

  get t() {
    return this.model.state.t;
  }

  set t(t) {
    if (!writeAttribute(this, "t", t)) this.model.editor.replaceState(FIELDS.t.put(this.model.state, t));
  }

  /** Everything that is shown, as plain data. */
  get state(): Record<string, unknown> {
    return jsonOf(this.model.state);
  }

  set state(json) {
    const state = json === undefined ? firstState() : stateOf(json);
    this.#assign(() => state);
  }

  toJSON() {
    return this.state;
  }

  /** What is shown, as companions read it. */
  get figure() {
    return publicFigure(this.model.state, this.model.figure);
  }

  undo() {
    this.model.editor.undo();
  }

  redo() {
    this.model.editor.redo();
  }

  /** Everything as it was when the user came. */
  reset() {
    this.model.editor.reset();
  }

  randomize(seed: number = Math.floor(Math.random() * 2 ** 32)) {
    this.#change((state) => commands.randomized(state, seed));
  }

  /**
   * Shows the two halves at t.
   *
   * @returns of the selected segment
   */
  split(t: number = this.t): ReturnType<AppletProperties["split"]> {
    const { state, rational } = this.model;
    const next = FIELDS.show.put(FIELDS.t.put(state, t), [...new Set([...state.layers, "halves"])]);
    const figure = figureOf(next, rational?.RationalCurve);
    const pieces = figure.rational.length ? figure.rational : figure.pieces;
    if (!pieces.length) throw new RangeError("split: expected a curve, got too few points for one");
    this.#change(() => next);
    return pieces[Math.min(next.segment, pieces.length - 1)].curve.split(t);
  }

  insertJoint(t?: number) {
    this.#change((state) => commands.inserted(state, t));
  }

  removePoint(index: number) {
    this.#change((state) => commands.removed(state, index));
  }

  appendPoint(point: Point2) {
    this.#change((state) => commands.appended(state, point));
  }

  /** Few points, or all. */
  toggleAllPoints() {
    this.#change(allPointsToggled);
  }

  /**
   * As if the user did it in the figure: a point moved, or values written as in the state's JSON.
   *
   * @param done whether the undo step is complete
   */
  edit(
    {
      index,
      point,
      ...values
    }: {
      index?: number;
      point?: Point2;
      t?: number;
      points?: Point2[];
      weights?: number[];
      basis?: string;
      matrix?: number[];
    },
    done = true,
  ) {
    if (this.readonly && (index !== undefined || values.points || values.weights)) return;
    const given = values as Record<string, unknown>;
    const change = (state: State) => {
      const next = Object.entries(FIELDS).reduce(
        (at, [name, { put }]) => (given[name] === undefined ? at : put(at, given[name])),
        state,
      );
      return index === undefined ? next : commands.withPointAt(next, index, point);
    };
    this.model.editor.dispatch(change, { by: "user", merge: true });
    if (done) this.model.editor.commit();
  }

  /** The picture with all its layers. */
  async toSVG(): Promise<string> {
    return (await this.#loaded()).toSVG();
  }

  /** The picture as a PNG; null before it has been near. */
  async toBlob(): Promise<Blob | null> {
    return (await this.#loaded()).toBlob();
  }

  /** A program that makes the same curve. */
  async toCode(language: Language): Promise<string> {
    return (await this.#loaded()).toCode(language);
  }

  /** The page sets a property. Before the first action of the user, this is what `reset` restores, and no undo step. */
  #assign(change: (state: State) => State) {
    this.model.editor.dispatch(change, { by: "page", initial: true });
  }

  /** A method of the page: an undo step, but no events. What is refused changes nothing. */
  #change(change: (state: State) => State) {
    this.model.editor.dispatch(change, { by: "page" });
  }

  attributeChangedCallback(name: string, before: string | null, value: string | null) {
    const field = FIELD_NAMES.get(name);
    if (field) this.model.attributeChanged(field);
    else super.attributeChangedCallback(name, before, value);
  }

  connectedCallback() {
    super.connectedCallback();
    adoptProperties(this, ["state", "points", "joints", ...Object.keys(FIELDS)]);
    this.#watch ??= new IntersectionObserver((entries) => this.#seen(entries[entries.length - 1].isIntersecting), {
      rootMargin: NEAR,
    });
    this.#watch.observe(this);
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#watch?.disconnect();
    this.#near = false;
    this.#view?.controller.end();
    this.model.editor.commit();
  }

  async #seen(near: boolean) {
    this.#visible = near;
    if (!near || this.#near || !this.isConnected) return;
    this.#near = true;
    try {
      await loadDrawing();
      await whenIdle();
      this.#near &&= this.#visible; // it may have been scrolled past
      if (!this.#near) return;
      await this.#loaded();
      if (this.model.message === missing()) this.model.say("");
    } catch {
      this.#near = false;
      this.model.say(missing());
    }
    this.requestUpdate();
  }

  /** The controller, with what curves with weights need, where there are any. */
  async #loaded() {
    const controller = await this.#controlled();
    await this.#weighted();
    return controller;
  }

  async #weighted() {
    if (this.model.rational || !weightsOf(this.model.state)) return;
    const rational = await loadRational();
    this.model.rational ??= rational; // another call may have set it meanwhile
    if (this.model.message === missing()) this.model.say("");
  }

  async #controlled() {
    if (this.#view) return this.#view.controller;
    const { AppletController, frame, style } = await loadDrawing();
    if (this.#view) return (this.#view as { controller: AppletController }).controller; // another call has set it meanwhile
    const self = this as { renderRoot: HTMLElement | DocumentFragment };
    self.renderRoot ??= this.createRenderRoot();
    const root = this.renderRoot as ShadowRoot;
    root.adoptedStyleSheets = [...root.adoptedStyleSheets, style.styleSheet as CSSStyleSheet];
    const controller = new AppletController(this);
    controller.listen();
    this.#view = { controller, frame };
    this.requestUpdate();
    if (this.isConnected) await this.updateComplete; // updates begin when it is connected for the first time
    return controller;
  }

  /** @internal Controls and picture are rendered together in the next frame; where there are no frames, the controls are rendered at once. */
  scheduleUpdate() {
    if (!this.isUpdatePending) return; // rendered meanwhile
    const { controller } = this.#view ?? {};
    if (controller?.isRunning && !this.ownerDocument.hidden) return controller.schedule();
    return super.scheduleUpdate();
  }

  /** @internal Renders the controls at once if they are to be rendered. */
  renderControls() {
    if (this.isUpdatePending) this.performUpdate();
  }

  updated() {
    const { controller } = this.#view ?? {};
    if (this.#near && this.isConnected) controller?.start();
    if (controller && this.#near) this.#weighted().catch(() => this.model.say(missing()));
    if (this.#updatedState === this.model.state) return;
    this.#updatedState = this.model.state;
    controller?.announcer?.say();
    this.dispatchEvent(new Event("update"));
  }

  render() {
    if (this.#view) return this.#view.frame(this.#view.controller);
    return html`<slot name="label"></slot><div class="poster"><slot name="poster"><slot></slot></slot></div>${this.model.message}<slot name="caption"></slot>`;
  }
}

defineProperties(BezierApplet.prototype, (element) => element.model.state);
