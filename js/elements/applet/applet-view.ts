// The part of `<bezier-applet>` that is loaded when one comes near: the picture, the handles, the panel.
import { isForText } from "../../ui/keys.js";
import { translated } from "../../editor/translations.js";
import { Speaker, setText } from "../../ui/announcer.js";
import { AppletActions } from "./actions.js";
import * as commands from "../../editor/commands.js";
import { textIn } from "../../editor/import.js";
import { listenToFiles } from "../../ui/files.js";
import { frame } from "./frame.js";
import { listenToKeys, listenToPage } from "./keys.js";
import { jointsOf } from "../../editor/joints.js";
import { snapped, turnedBy15 } from "../../editor/snapping.js";
import { Stage } from "./stage.js";
import * as states from "../../editor/state.js";
import { description } from "../../editor/descriptions.js";
import type { Point2 } from "../../editor/state.js";

export class AppletView extends AppletActions {
  /** Theme of the cached colours. */
  #theme = "";

  #stopListeningToPage: (() => void) | null = null;

  constructor(host: import("./editing.js").AppletEditing) {
    super(host);
    listenToKeys(host, this.#keyPort());
    listenToFiles(host, { busy: isForText, take: (text) => this.take(text), textIn });
    host.addEventListener("focusin", (event) => this.#choose(this.#pointOf(event)));
  }

  /** The element is in the page, and its shadow tree is up to date. */
  start() {
    const { host } = this;
    if (!this.stage) {
      const find = (selector: string) => host.renderRoot.querySelector(selector) as any;
      const stage = new Stage(
        { canvas: find("canvas"), overlay: find(".overlay"), probe: find(".probe") },
        this.#stagePort(),
      );
      this.begin(stage, new Speaker(find("[role=status]"), () => this.#describe()));
      this.#describe();
    }
    this.#stopListeningToPage ??= listenToPage(host, this.#keyPort());
    if (!this.announced.includes(this.message)) this.speaker?.say();
    this.stage?.start();
    if (this.#theme !== host.theme)
      this.stage?.recolour(); // asks for the computed style, which costs as much as the picture
    else this.stage?.refresh();
    this.#theme = host.theme;
  }

  /** Leaves nothing running. */
  end() {
    this.player.stop();
    this.#stopListeningToPage?.();
    this.#stopListeningToPage = null;
    this.stage?.end();
    this.speaker?.end();
  }

  /** The picture in words, brought up to date; what is new in it. */
  #describe() {
    const figure = this.host.currentFigure();
    const joints = jointsOf(figure);
    const words = description(
      this.host.editor.state,
      figure,
      joints,
      this.messages.map((messages) => messages.words),
    );
    setText(this.host.renderRoot.querySelector("#description") as HTMLElement, words);
    const truths = joints.map(({ at, verdict }) => translated("At {0}: {1}", at, verdict));
    const news = [this.message, ...truths].filter((each) => each && !this.announced.includes(each));
    this.announced = [this.message, ...truths];
    return news.join(". ");
  }

  /** What is told below the picture. */
  get message() {
    return [...this.host.problems, this.host.message].filter(Boolean).join(" · ");
  }

  #pointOf(event: Event) {
    return this.stage?.handles.indexOf(event.composedPath()[0]) ?? -1;
  }

  /** The last point touched; its segment is the one that t is about. */
  #choose(index: number) {
    if (index < 0) return;
    const figure = this.host.currentFigure();
    const pieces = figure.weights ? figure.rational : figure.pieces;
    const state = this.host.editor.state;
    this.choose(index);
    if (pieces[state.segment]?.indices.includes(index)) return;
    const segment = pieces.findIndex(({ indices }) => indices.includes(index));
    if (segment >= 0) this.host.editor.show({ ...state, segment });
  }

  /** A part of what the user is doing. */
  #changeOn(change: (state: states.State) => states.State) {
    this.host.editor.dispatch(change, { origin: "user", merge: true });
  }

  #pull(index: number, to: Point2, { from, event }: { from: Point2; event?: PointerEvent }) {
    to = this.#roundedToPixels(to);
    const { shiftKey = false, altKey = false, ctrlKey = false, metaKey = false } = event ?? {};
    this.#changeOn((state) => {
      const free = altKey ? commands.broken(state, index) : state;
      const place = shiftKey
        ? turnedBy15(free, index, to, from)
        : ctrlKey || metaKey || altKey
          ? to
          : snapped(free, index, to, this.stage?.reach ?? 1);
      return commands.withPointAt(free, index, place);
    });
  }

  /** Rounded to a fraction of a pixel that nobody sees, because positions of pointers are quotients with many digits. */
  #roundedToPixels([x, y]: Point2): Point2 {
    const digits = 3 - Math.floor(Math.log10(states.scaleOf(this.host.editor.state)));
    return [Number(x.toFixed(digits)), Number(y.toFixed(digits))];
  }

  #stagePort(): import("./stage.js").StagePort {
    return {
      now: () => ({ state: this.host.editor.state, figure: this.host.currentFigure() }),
      rational: () => this.host.rational,
      layers: () => this.layers,
      fixed: () => this.host.readonly,
      begun: () => this.host.editor.commit(),
      move: (index, to, drag) => void this.host.attempt(() => this.#pull(index, to, drag)),
      restored: () => this.host.editor.revert(),
      ended: (moved, weighed) => {
        this.host.editor.commit();
        const words = [this.places(moved), ...weighed.map((index) => this.weightWords(index))].filter(Boolean);
        if (words.length) this.speaker?.say(words.join(". "));
      },
      grabbed: (index) => this.#choose(index),
      slide: (index, to) => {
        this.host.attempt(() => this.#changeOn((state) => commands.withPointAt(state, index, to)));
        this.speaker?.say(this.places([index]));
      },
      weigh: (index, to) => this.#weigh((now, { withWeightPointAt }) => withWeightPointAt(now, index, to)),
      slideWeight: (index, weight) => {
        this.#weigh((now, { withWeight }) => withWeight(now, index, weight));
        this.speaker?.say(this.weightWords(index));
      },
      slid: () => this.host.editor.commit(),
      doubleTap: (at) => this.host.readonly || this.tapping || this.appendAt(at),
      tap: (at) =>
        this.tapping &&
        this.selected >= 0 &&
        this.change((state) => commands.withPointAt(state, this.selected, at), this.places([this.selected])),
      point: (at) => {
        const state = this.host.editor.state;
        const isFollowed =
          state.layers.has("nearest") || (state.layers.has("construction") && !state.layers.has("names"));
        if (isFollowed) this.host.editor.show({ ...state, pointer: at?.() ?? null });
      },
      look: (factor, from, to) => this.#look(factor, from, to),
      drawn: (messages) => this.show(messages),
    };
  }

  #look(factor: number, from: Point2, to: Point2) {
    const state = states.zoomed(this.host.editor.state, factor, from);
    const { view } = state;
    this.host.editor.show({ ...state, view: { ...view, x: view.x + from[0] - to[0], y: view.y + from[1] - to[1] } });
  }

  #keyPort(): import("./keys.js").KeyPort {
    return {
      off: () => this.host.hotkeys === "off",
      pointOf: (event) => this.#pointOf(event),
      nudge: (index, step) => this.#nudge(index, step),
      weightOf: (event) => {
        const leg = this.stage?.weights?.indexOf(event.composedPath()[0]) ?? -1;
        return leg < 0 ? -1 : leg + 1;
      },
      nudgeWeight: (index, steps) => {
        if (this.host.readonly) return;
        this.#weigh((now, { steppedWeight }) => steppedWeight(now, index, steps));
        this.speaker?.say(this.weightWords(index));
      },
      settled: () => void (this.stage?.dragging || this.host.editor.commit()),
      escape: () => this.stage?.cancel() ?? false,
      remove: (index, bare) => {
        if (!this.host.readonly && this.removeAt(index, bare)) this.focusPoint(index);
      },
      cycle: (index) => this.cycle(index),
      run: (name) => void (this.host.readonly || this.run(name)),
      help: this.actions.help,
    };
  }

  /** A part of a change of weights. */
  #weigh(change: (state: states.State, rational: import("./loading.js").Rational) => states.State) {
    const { rational } = this.host;
    if (rational) this.host.attempt(() => this.#changeOn((state) => change(state, rational)));
  }

  #nudge(index: number, [dx, dy]: [number, number]) {
    if (this.host.readonly) return;
    const scale = states.scaleOf(this.host.editor.state);
    const [x, y] = this.host.editor.state.points[index];
    this.host.attempt(() =>
      this.#changeOn((state) => commands.withPointAt(state, index, [x + dx * scale, y + dy * scale])),
    );
    this.speaker?.say(this.places([index]));
  }

  /** Everything in the shadow root. */
  template() {
    const { host } = this;
    return frame({
      name: host.name,
      message: this.message,
      good: host.good && !host.problems.length,
      cursor: this.tapping ? "place" : states.isHome(host.editor.state) ? "" : "grab",
      weights: states.weightsOf(host.editor.state) !== null,
      panel: this.panelled ? this.panelPort() : null,
    });
  }
}
