import { adoptProperties } from "../surface/attributes.js";
import { AppletEditing } from "./editing.js";
import * as edits from "./edits.js";
import { FIELDS } from "./fields.js";
import { frame } from "./frame.js";
import { listenToKeys } from "./keys.js";
import { MISSING } from "../loading.js";
import { loadDrawing } from "./loading.js";
import { Player } from "./player.js";
import { jointsOf } from "./report.js";
import { snapped, turnedBy15 } from "./snap.js";
import * as states from "./state.js";
import { style } from "./style.js";
import { roomiestAmong } from "../../applet/random.js";
import { Speaker, setText } from "../../applet/voice.js";
import { BASIS_NAMES, description, MODE_NAMES, placeWords } from "./words.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./state.js").Place} Place */

/** @typedef {import("./stage.js").Stage} Stage */

/** The element begins its work when it is so near to what is seen of the page. */
const NEAR = "300px";

/** `<bezier-applet>`; what can be set from outside is documented in ../types.js. */
export class BezierApplet extends AppletEditing {
  static styles = style;
  /** @type {Stage | null} */
  #stage = null;
  /** @type {IntersectionObserver | null} */
  #watch = null;
  /** @type {Speaker | null} */
  #speaker = null;
  /** Null until it is fetched. @type {import("./loading.js").Drawing | null} */
  #drawing = null;
  /** Being fetched, for this stay in the document. @type {Promise<void> | null} */
  #coming = null;
  /** @type {State | null} */
  #told = null;
  /** @type {{ name: string, words: string }[]} */
  #tells = [];
  #player = new Player((by) => this.#advance(by));

  constructor() {
    super();
    listenToKeys(this, this.#keyPort());
  }

  connectedCallback() {
    super.connectedCallback();
    adoptProperties(this, ["state", "points", "joints", ...Object.keys(FIELDS)]);
    this.#watch = new IntersectionObserver((entries) => this.#seen(entries[entries.length - 1].isIntersecting), { rootMargin: NEAR });
    this.#watch.observe(this);
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#watch?.disconnect();
    this.#coming = null;
    this.#player.stop();
    this.#stage?.end();
    this.#speaker?.end();
    this.settle();
  }

  /** @param {boolean} near */
  #seen(near) {
    if (!near || !this.isConnected) return;
    this.#stage?.start();
    if (!this.#drawing) this.#coming ??= this.#start();
  }

  /** Fetches what draws. Whoever was taken out meanwhile, and perhaps put in again, has another watch. */
  async #start() {
    const watch = this.#watch;
    const drawing = await loadDrawing().catch(() => null);
    if (watch !== this.#watch || !this.isConnected) return;
    this.#coming = null;
    this.#drawing = drawing;
    this.say(drawing ? "" : MISSING);
    this.requestUpdate();
  }

  updated() {
    if (this.#drawing && this.isConnected) this.#begin(this.#drawing);
    this.#stage?.recolour();
    if (!this.history.open) this.reflectState();
    if (this.#told === this.now()) return;
    this.#told = this.now();
    this.#speaker?.say();
    this.dispatchEvent(new Event("update"));
  }

  /** @param {import("./loading.js").Drawing} drawing */
  #begin({ Stage }) {
    if (!this.#stage) {
      const find = (/** @type {string} */ selector) => /** @type {any} */ (this.renderRoot.querySelector(selector));
      this.#stage = new Stage({ canvas: find("canvas"), overlay: find(".overlay"), probe: find(".probe") }, this.#stagePort());
      this.#speaker = new Speaker(find("[role=status]"), () => this.#describe());
      this.#describe();
    }
    this.#stage.start();
  }

  /** The picture in words, brought up to date. */
  #describe() {
    const figure = this.made();
    const words = description(this.now(), figure, jointsOf(figure), this.#tells.map(({ words }) => words));
    setText(/** @type {HTMLElement} */ (this.renderRoot.querySelector("#description")), words);
    return "";
  }

  /**
   * Something the user does at once, and what is announced of it.
   *
   * @param {(state: State) => State} change
   * @param {string} words
   */
  #do(change, words) {
    this.#stage?.release();
    this.#speaker?.say(this.byUser(change) ? words : this.message);
  }

  /** @param {number} by */
  #advance(by) {
    const state = this.now();
    const [least, most] = states.rangeOfT(state);
    const t = Math.min(Math.max(state.t + by, least), most);
    this.show({ ...state, t });
    this.fire("input");
    return t === (by > 0 ? most : least);
  }

  /**
   * @param {number} index
   * @param {Place} to
   * @param {{ from: Place, event?: PointerEvent }} drag
   */
  #pull(index, to, { from, event }) {
    const { shiftKey = false, altKey = false, ctrlKey = false, metaKey = false } = event ?? {};
    this.during((state) => {
      const free = altKey ? edits.broken(state, index) : state;
      const place = shiftKey ? turnedBy15(free, index, to, from) : ctrlKey || metaKey || altKey ? to : snapped(free, index, to, this.#stage?.reach ?? 1);
      return edits.withPointAt(free, index, place);
    });
  }

  /** The words for some points and where they are. @param {number[]} indices */
  #places(indices) {
    const { names, points } = this.made();
    return indices.map((index) => `${names[index]} at ${placeWords(points[index])}`).join(". ");
  }

  /** The segment of a point is the one that t is about. @param {number} index */
  #select(index) {
    const { pieces } = this.made();
    const state = this.now();
    if (pieces[state.segment]?.indices.includes(index)) return;
    const segment = pieces.findIndex(({ indices }) => indices.includes(index));
    if (segment >= 0) this.show({ ...state, segment });
  }

  /** @returns {import("./stage.js").StagePort} */
  #stagePort() {
    return {
      now: () => ({ state: this.now(), figure: this.made() }),
      fixed: () => this.readonly,
      begun: () => this.settle(),
      move: (index, to, drag) => void this.attempt(() => this.#pull(index, to, drag)),
      restored: () => this.giveUp(),
      ended: (moved) => {
        this.settle();
        if (moved.length) this.#speaker?.say(this.#places(moved));
      },
      grabbed: (index) => this.#select(index),
      doubleTap: (at) => !this.readonly && this.#append(at),
      tap: () => undefined,
      point: (at) => this.now().layers.has("nearest") && this.show({ ...this.now(), pointer: at }),
      look: (factor, from, to) => this.#look(factor, from, to),
      drawn: (told) => this.#hear(told),
    };
  }

  /** @param {{ name: string, words: string }[]} told */
  #hear(told) {
    const changed = JSON.stringify(told) !== JSON.stringify(this.#tells);
    this.#tells = told;
    if (changed && this.#panelled) this.requestUpdate();
  }

  get #panelled() {
    return this.controls !== null && this.controls !== false;
  }

  /** @param {Place} at */
  #append(at) {
    this.#do((state) => edits.appended(state, at), "Point added");
    this.#stage?.place();
    this.#stage?.handles.focus(this.now().shown - 1);
  }

  /**
   * @param {number} factor
   * @param {Place} from
   * @param {Place} to
   */
  #look(factor, from, to) {
    const state = states.zoomed(this.now(), factor, from);
    const { view } = state;
    this.show({ ...state, view: { ...view, x: view.x + from[0] - to[0], y: view.y + from[1] - to[1] } });
  }

  /** @param {number} factor */
  #zoom(factor) {
    const { x, y, width, height } = this.now().view;
    this.show(states.zoomed(this.now(), factor, [x + width / 2, y + height / 2]));
  }

  /**
   * @param {number} index
   * @returns {boolean}
   */
  #cycle(index) {
    const chain = edits.chainOf(this.now());
    const joint = chain ? index / chain.degree : 0;
    const mode = this.joints[joint - 1];
    if (!mode || this.readonly) return false;
    const next = states.MODES[(states.MODES.indexOf(mode) + 1) % states.MODES.length];
    this.#hold(joint, next);
    return true;
  }

  /**
   * @param {number} joint
   * @param {string} mode
   */
  #hold(joint, mode) {
    this.#do((state) => edits.withJoint(state, joint, mode), `${this.made().names[joint * this.made().degree]} held: ${MODE_NAMES[/** @type {states.JointMode} */ (mode)]}`);
  }

  /** @returns {import("./keys.js").KeyPort} */
  #keyPort() {
    const editable = (/** @type {() => void} */ act) => () => void (this.readonly || act());
    const { act } = this.#actions();
    return {
      off: () => this.hotkeys === "off",
      pointOf: (event) => this.#stage?.handles.indexOf(event.composedPath()[0]) ?? -1,
      nudge: (index, [dx, dy]) => {
        if (this.readonly) return;
        const scale = states.scaleOf(this.now());
        const [x, y] = this.now().points[index];
        this.attempt(() => this.during((state) => edits.withPointAt(state, index, [x + dx * scale, y + dy * scale])));
        this.#speaker?.say(this.#places([index]));
      },
      settled: () => void (this.#stage?.dragging || this.settle()),
      escape: () => this.#stage?.cancel() ?? false,
      remove: (index, bare) => {
        if (this.readonly) return;
        this.#do((state) => edits.removed(state, index, bare), `${this.made().names[index]} removed`);
        this.#stage?.place();
        this.#stage?.handles.focus(Math.min(index, this.now().shown - 1));
      },
      cycle: (index) => this.#cycle(index),
      insert: editable(act.insert),
      undo: editable(act.undo),
      redo: editable(act.redo),
      randomize: editable(act.randomize),
      toggle: editable(act.toggle),
      help: act.help,
    };
  }

  #actions() {
    const act = {
      play: () => {
        if (this.#player.playing) this.#player.stop();
        else this.#player.start();
        if (!this.#player.playing) this.fire("change");
        this.requestUpdate();
      },
      undo: () => this.#goBack(() => this.undo(), "Undone"),
      redo: () => this.#goBack(() => this.redo(), "Done again"),
      reset: () => this.#do(() => this.origin, "As at first"),
      randomize: () => this.#do((state) => edits.randomized(state, Math.floor(Math.random() * 2 ** 32)), "Points randomized"),
      toggle: () => {
        this.#do(states.toggled, "");
        this.#speaker?.say(`${this.now().shown} points shown`);
      },
      append: () => this.#append(roomiestAmong(this.now().box, this.now().points)),
      insert: () => this.#do((state) => edits.inserted(state), "Cut at t"),
      help: () => this.say("Keys"),
      home: () => this.show(states.withHome(this.now())),
    };
    return { act };
  }

  /**
   * @param {() => void} act
   * @param {string} words
   */
  #goBack(act, words) {
    const before = this.now();
    this.#stage?.cancel();
    act();
    if (this.now() === before) return;
    this.#speaker?.say(words);
    this.fire("input");
    this.fire("change");
  }

  /** @returns {import("./panel.js").PanelPort} */
  #panelPort() {
    const figure = this.made();
    const wanted = String(this.controls === true ? "" : this.controls).split(/\s+/).filter(Boolean);
    return {
      state: this.now(),
      figure,
      joints: jointsOf(figure),
      modes: this.joints,
      tells: this.#tells,
      shows: (group) => !wanted.length || wanted.includes(group),
      readonly: this.readonly,
      playing: this.#player.playing,
      can: { undo: this.history.canUndo, redo: this.history.canRedo, insert: edits.canInsert(this.now()) },
      set: (change) => this.#do(change, ""),
      put: (name, value, done = true) => {
        this.attempt(() => this.during((state) => FIELDS[name].put(state, value)));
        if (done) this.settle();
      },
      ...this.#actions(),
      hold: (joint, mode) => this.#hold(joint, mode),
      zoom: (factor) => this.#zoom(factor),
      home: () => this.show(states.withHome(this.now())),
    };
  }

  render() {
    const { basis } = this.now();
    return frame({
      name: this.label || `${BASIS_NAMES[basis]} curve with control points that can be moved`,
      drawing: this.#drawing,
      message: [...this.problems, this.message].filter(Boolean).join(" · "),
      panel: this.#drawing && this.#panelled ? this.#panelPort() : null,
    });
  }
}
