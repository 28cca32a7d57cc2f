// The part of `<bezier-applet>` that is loaded when one comes near: the picture, the hands, the panel.
import { isForText } from "../../ui/keys.js";
import { Speaker, setText } from "../../applet/voice.js";
import { AppletActions } from "./actions.js";
import * as edits from "./edits.js";
import { listenToFiles } from "./files.js";
import { frame } from "./frame.js";
import { listenToKeys, listenToPage } from "./keys.js";
import { jointsOf } from "./joints.js";
import { snapped, turnedBy15 } from "./snap.js";
import { Stage } from "./stage.js";
import * as states from "./state.js";
import { description } from "./words.js";
import type { Point2 } from "./state.js";

export class AppletView extends AppletActions {
  /** Theme of the cached colours. */
  #theme = "";

  #stopListeningToPage: (() => void) | null = null;

  constructor(host: import("./editing.js").AppletEditing) {
    super(host);
    listenToKeys(host, this.#keyPort());
    listenToFiles(host, { busy: isForText, take: (text) => this.take(text) });
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
    const figure = this.host.made();
    const joints = jointsOf(figure);
    const words = description(
      this.host.now(),
      figure,
      joints,
      this.messages.map((messages) => messages.words),
    );
    setText(this.host.renderRoot.querySelector("#description") as HTMLElement, words);
    const truths = joints.map(({ at, verdict }) => `At ${at}: ${verdict}`);
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
    const { pieces } = this.host.made();
    const state = this.host.now();
    this.choose(index);
    if (pieces[state.segment]?.indices.includes(index)) return;
    const segment = pieces.findIndex(({ indices }) => indices.includes(index));
    if (segment >= 0) this.host.display({ ...state, segment });
  }

  #pull(index: number, to: Point2, { from, event }: { from: Point2; event?: PointerEvent }) {
    to = this.#roundedToPixels(to);
    const { shiftKey = false, altKey = false, ctrlKey = false, metaKey = false } = event ?? {};
    this.host.updateOpenStep((state) => {
      const free = altKey ? edits.broken(state, index) : state;
      const place = shiftKey
        ? turnedBy15(free, index, to, from)
        : ctrlKey || metaKey || altKey
          ? to
          : snapped(free, index, to, this.stage?.reach ?? 1);
      return edits.withPointAt(free, index, place);
    });
  }

  /** As fine as anyone sees: pointers' places come with the dust of divisions. */
  #roundedToPixels([x, y]: Point2): Point2 {
    const digits = 3 - Math.floor(Math.log10(states.scaleOf(this.host.now())));
    return [Number(x.toFixed(digits)), Number(y.toFixed(digits))];
  }

  #stagePort(): import("./stage.js").StagePort {
    return {
      now: () => ({ state: this.host.now(), figure: this.host.made() }),
      fixed: () => this.host.readonly,
      begun: () => this.host.commit(),
      move: (index, to, drag) => void this.host.attempt(() => this.#pull(index, to, drag)),
      restored: () => this.host.revert(),
      ended: (moved) => {
        this.host.commit();
        if (moved.length) this.speaker?.say(this.places(moved));
      },
      grabbed: (index) => this.#choose(index),
      slide: (index, to) => {
        this.host.attempt(() => this.host.updateOpenStep((state) => edits.withPointAt(state, index, to)));
        this.speaker?.say(this.places([index]));
      },
      slid: () => this.host.commit(),
      doubleTap: (at) => this.host.readonly || this.tapping || this.appendAt(at),
      tap: (at) =>
        this.tapping &&
        this.selected >= 0 &&
        this.do((state) => edits.withPointAt(state, this.selected, at), this.places([this.selected])),
      point: (at) => {
        const state = this.host.now();
        const isFollowed =
          state.layers.has("nearest") || (state.layers.has("construction") && !state.layers.has("names"));
        if (isFollowed) this.host.display({ ...state, pointer: at?.() ?? null });
      },
      look: (factor, from, to) => this.#look(factor, from, to),
      drawn: (messages) => this.show(messages),
    };
  }

  #look(factor: number, from: Point2, to: Point2) {
    const state = states.zoomed(this.host.now(), factor, from);
    const { view } = state;
    this.host.display({ ...state, view: { ...view, x: view.x + from[0] - to[0], y: view.y + from[1] - to[1] } });
  }

  #keyPort(): import("./keys.js").KeyPort {
    const editable = (act: () => void) => () => void (this.host.readonly || act());
    const { insert, undo, redo, randomize, toggle, help } = this.actions;
    return {
      off: () => this.host.hotkeys === "off",
      pointOf: (event) => this.#pointOf(event),
      nudge: (index, step) => this.#nudge(index, step),
      settled: () => void (this.stage?.dragging || this.host.commit()),
      escape: () => this.stage?.cancel() ?? false,
      remove: (index, bare) => {
        if (!this.host.readonly && this.removeAt(index, bare)) this.focusPoint(index);
      },
      cycle: (index) => this.cycle(index),
      insert: editable(insert),
      undo: editable(undo),
      redo: editable(redo),
      randomize: editable(randomize),
      toggle: editable(toggle),
      help,
    };
  }

  #nudge(index: number, [dx, dy]: [number, number]) {
    if (this.host.readonly) return;
    const scale = states.scaleOf(this.host.now());
    const [x, y] = this.host.now().points[index];
    this.host.attempt(() =>
      this.host.updateOpenStep((state) => edits.withPointAt(state, index, [x + dx * scale, y + dy * scale])),
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
      cursor: this.tapping ? "place" : states.isHome(host.now()) ? "" : "grab",
      panel: this.panelled ? this.panelPort() : null,
    });
  }
}
