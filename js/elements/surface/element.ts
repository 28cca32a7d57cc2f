import { History } from "../../editor/history.js";
import { Surface } from "../../surfaces.js";
import { historyStep, isForText } from "../../ui/keys.js";
import { adoptProperties } from "../adopt.js";
import { controlGroups } from "../attribute-text.js";
import { SurfaceAttributes } from "./attributes.js";
import { HOME, moved, rayThrough, ZOOM_STEP } from "./camera.js";
import { FileController } from "./file-controller.js";
import { acceptDrops } from "../../ui/files.js";
import { figureOf } from "./figure.js";
import { frame } from "./frame.js";
import { missing } from "../loading.js";
import { loadDrawing, loadRational } from "./loading.js";
import { isRational } from "./settings.js";
import { whenIdle } from "../start-queue.js";
import { style } from "./style.js";
import { Subject } from "./subject.js";
import { AutoRotation } from "./auto-rotation.js";
import { MODEL_NAMES, STATES } from "./words.js";
import { translated } from "../../editor/translations.js";
import type { View } from "./camera.js";
import type { Edits } from "./subject.js";
import type { Facts } from "./geometry.js";
import type { Handles } from "./handles.js";
import type { Labels } from "./labels.js";
import type { Drawing } from "./loading.js";
import type { Stage } from "./stage.js";
import type { PanelPort } from "./panel.js";

/** Root margin for lazy loading. */
const NEAR = "300px";
/** Farther away than so many heights of what is seen it gives the graphics card back. */
const FAR = "150% 0px";
/** A file is shown with no more, at first. */
const MAX_TRIANGLES = 1e6;
/** Where the sliders begin: in radii of the surface, and in pixels. */
const [FIRST_TOLERANCE, FIRST_PIXELS] = [0.005, 1];

/** The properties that undo and redo restore, besides moved points and the surface of a file. */
const UNDOABLE = [
  "model",
  "parts",
  "height",
  "up",
  "shading",
  "show",
  "evaluation",
  "segments",
  "tolerance",
  "pixels",
  "flatness",
  "lines",
] as const;

type UndoState = { edits: Edits } & Pick<SurfaceAttributes, (typeof UNDOABLE)[number]>;

/** A surface of another entry point ("casteljau/surfaces", "casteljau/slim"), which has a class of its own. */
function surfaceOfOtherBundle(value: Surface): Surface {
  if (value?.casteljauType !== "surface") {
    const isEmpty = typeof value === "object" && Object.keys(value).length === 0;
    const hint = isEmpty ? " without keys; structuredClone and postMessage need toJSON() and fromJSON()" : "";
    throw new TypeError(`surface: expected a Surface or null, got ${typeof value}${hint}`);
  }
  return Surface.fromJSON(value.toJSON());
}

/** `<bezier-surface>`; what can be set from outside is documented in ../types.js. */
export class BezierSurface extends SurfaceAttributes {
  static styles = style;
  #subject = new Subject();
  #history: History<UndoState> = new History();
  #stage: Stage | null = null;
  #handles: Handles | null = null;
  #labels: Labels | null = null;
  #watches: IntersectionObserver[] = [];
  #removeListeners: (() => void) | null = null;
  #camera: View = HOME;
  /** What there is to see; see STATES. */
  #state: keyof typeof STATES = "coming";
  /** The stage being fetched, for this stay in the document. */
  #coming: Promise<void> | null = null;
  #facts: Facts | null = null;
  #rotation = new AutoRotation();
  #files = new FileController({
    show: (surface) => this.#showFile(surface),
    rational: () => this.#rational(),
    changed: () => this.requestUpdate(),
    picture: () => this.toBlob(),
    mesh: () => this.#stage && { mesh: this.#stage.geometry.closedMesh(this.#scene()), up: this.settings().up },
    names: () => ({ page: this.ownerDocument, name: this.#subject.given ? "surface" : this.settings().model }),
  });
  /** The model of the last picture. */
  #model = "";
  /** The surface that was set last. */
  #awaited: unknown = null;
  #visible = false;
  #kept = false;
  /** Whether the canvas holds a picture: before, and while the graphics card is given back, the page's own is shown. */
  #drawn = false;

  /** The surface that is shown, moved points and all. */
  get surface() {
    return this.#subject.surface(this.settings());
  }

  set surface(surface: Surface | null | undefined) {
    this.#awaited = surface;
    if ((surface as { casteljauType?: string } | null | undefined)?.casteljauType === "rationalsurface") {
      void this.#showWithWeights(surface);
      return;
    }
    const own = surface === undefined || surface === null || surface instanceof Surface;
    this.#show(own ? (surface ?? null) : surfaceOfOtherBundle(surface));
    this.#history = new History(); // its states are those of another surface
  }

  /** Shows a surface with weights when the code for them is there, unless another one is set before. */
  async #showWithWeights(surface: any) {
    const rational = await this.#rational();
    if (!rational || this.#awaited !== surface) return;
    this.#show(rational.shownSurface(surface));
    this.#history = new History();
  }

  /** What surfaces with weights need; null where it cannot be fetched. */
  async #rational() {
    const rational = await loadRational().catch(() => null);
    if (!rational) this.#files.say(missing());
    this.#subject.rational = rational;
    this.requestUpdate();
    return rational;
  }

  #show(surface: Surface | null) {
    this.#subject.given = surface;
    this.patch = null;
    this.requestUpdate();
  }

  /** Where the eye is: degrees, enlargement, shift in radii. */
  get view() {
    return { ...(this.#stage?.camera ?? this.#camera) };
  }

  set view(view) {
    this.#move(view ?? HOME);
  }

  /** What is shown, as plain values; see SurfaceFigure in ../types.js. */
  get figure() {
    const scene = this.#scene();
    return figureOf(scene, (this.#facts && this.#stage?.factsOf(scene)) ?? this.#facts);
  }

  /** Takes back the last change of the surface or its settings by the user. */
  undo() {
    this.#restore(this.#history.undo(this.#undoState()));
  }

  /** Repeats the change that was taken back. */
  redo() {
    this.#restore(this.#history.redo(this.#undoState()));
  }

  #undoState(): UndoState {
    const properties = UNDOABLE.map((name) => [name, this[name]] as const);
    return { edits: this.#subject.edits, ...Object.fromEntries(properties) } as UndoState;
  }

  #restore({ edits, ...properties }: UndoState) {
    if (edits.given !== this.#subject.given) this.patch = null;
    this.#subject.edits = edits;
    Object.assign(this, properties);
    this.requestUpdate();
  }

  /** The user changes something, which is one undo step when it is done. */
  #edit(change: () => void, type: "input" | "change" = "change") {
    this.#history.begin(this.#undoState());
    change();
    if (type === "change") this.#history.commit(this.#undoState());
    this.requestUpdate();
    this.#fire(type);
  }

  #cancelEdit() {
    const before = this.#history.rollback(this.#undoState());
    if (before) this.#restore(before);
    this.#fire("change");
  }

  #stepByUser(step: "undo" | "redo") {
    const { isOpen, canUndo, canRedo } = this.#history;
    if (!(step === "undo" ? canUndo || isOpen : canRedo)) return;
    this.#handles?.endDrags();
    this[step]();
    this.#fire("change");
  }

  #key = (event: KeyboardEvent) => {
    const step = historyStep(event);
    if (!step || isForText(event)) return;
    event.preventDefault();
    this.#stepByUser(step);
  };

  /** The picture as it is now, a PNG. */
  async toBlob(): Promise<Blob | null> {
    await this.#coming;
    if (this.isConnected) await this.updateComplete; // updates begin when it is connected for the first time
    return this.#stage?.toBlob() ?? null;
  }

  connectedCallback() {
    super.connectedCallback();
    adoptProperties(this, ["surface", "view"]);
    this.#watches = [this.#watch(FAR, (kept) => this.#keep(kept)), this.#watch(NEAR, (near) => this.#seen(near))];
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#watches.forEach((watch) => watch.disconnect());
    this.#watches = [];
    this.#coming = null;
    this.#removeListeners?.();
    this.#removeListeners = null;
    this.#camera = this.view;
    this.#handles?.endDrags();
    this.#stage?.end();
    this.#stage = null;
    this.#drawn = false;
  }

  #watch(margin: string, act: (inside: boolean) => void) {
    const observer = new IntersectionObserver((entries) => act(entries[entries.length - 1].isIntersecting), {
      rootMargin: margin,
    });
    observer.observe(this);
    return observer;
  }

  /** @param kept whether it is near enough to keep the graphics card */
  #keep(kept: boolean) {
    this.#kept = kept;
    if (kept) return;
    this.#stage?.suspend();
    this.#setDrawn(false);
  }

  #setDrawn(drawn: boolean) {
    if (drawn === this.#drawn) return;
    this.#drawn = drawn;
    this.requestUpdate();
  }

  #seen(visible: boolean) {
    this.#visible = visible;
    if (!visible) return;
    this.#kept = true; // the other watch may report later
    if (!this.#stage) this.#coming ??= this.#start();
    this.#stage?.wake();
    this.#stage?.schedule();
  }

  /** Fetches what draws. Whoever was taken out meanwhile, and perhaps put in again, has other watches. */
  async #start() {
    const watches = this.#watches;
    const drawing = await loadDrawing().catch(() => null);
    await whenIdle();
    if (watches !== this.#watches || !this.isConnected) return;
    this.#coming = null;
    if (!this.#kept) return; // it was scrolled past
    if (drawing) return this.#build(drawing);
    this.#setState("missing");
  }

  #setState(state: keyof typeof STATES) {
    this.#state = state;
    this.requestUpdate();
  }

  #build({ Gestures, Handles, Labels, Stage }: Drawing) {
    const find = (selector: string) => this.renderRoot.querySelector(selector) as any;
    const canvas = find("canvas");
    this.#stage = new Stage(canvas, find(".probe"), this.#camera, {
      drawn: (facts, sight, width, height) => {
        this.#handles?.place(sight, width, height);
        this.#labels?.place(sight, width, height);
        this.#setDrawn(true);
        this.#publish(facts);
      },
      refused: (message) => this.#files.say(message),
      stateChanged: (state) => this.#setState(state),
      turning: () => this.#visible && this.#turns(),
    });
    this.#handles ??= new Handles(find(".overlay"), {
      moved: (vertex, to, done) =>
        this.#edit(() => this.#subject.move(vertex, to, this.settings()), done ? "change" : "input"),
      cancelled: () => this.#cancelEdit(),
      sight: () => this.#stage?.sight() ?? null,
    });
    this.#labels ??= new Labels(find(".overlay"));
    const gestures = new Gestures(canvas, {
      view: () => this.view,
      move: (changes, done) => this.#moveByHand(changes, done),
      home: () => this.#moveByHand(HOME, true),
      pick: (x, y) => this.#pick(x, y),
    });
    const endings = [gestures.listen(), acceptDrops(find(".stage"), (file) => this.#files.open(file))];
    this.#removeListeners = () => endings.forEach((end) => end());
    this.requestUpdate();
  }

  #scene() {
    return this.#subject.scene(this.settings(), this.patch);
  }

  willUpdate(changed: Map<string, unknown>) {
    if (!this.hasUpdated) return;
    if (["model", "height", "up"].some((name) => changed.has(name))) {
      this.#subject.forgetMovesOfOthers(this.settings());
      if (!changed.has("patch")) this.patch = null;
    }
  }

  updated(changed: Map<string, unknown>) {
    if (changed.has("turn") && this.turn) this.#rotation.restart();
    if (changed.has("theme")) this.#stage?.recolour();
    if (this.#stage) {
      const { model } = this.settings();
      if (model !== this.#model && isRational(model)) void this.#rational();
      this.#model = model;
      const scene = this.#scene();
      this.#handles?.update(scene);
      this.#labels?.update(scene);
      this.#stage.show(scene);
    }
    this.dispatchEvent(new Event("update"));
  }

  #turns() {
    return this.#rotation.on(this.turn);
  }

  /** The read-out follows the mesh. */
  #publish(facts: Facts) {
    this.#files.clear();
    const before = this.#facts;
    this.#facts = facts;
    const onGpu = (each: Facts) => each.ms === null;
    // Another time alone is no reason for an update.
    const time = before && onGpu(before) === onGpu(facts) ? before.ms : facts.ms;
    if (JSON.stringify(before) === JSON.stringify({ ...facts, ms: time })) return;
    this.requestUpdate();
  }

  #move(changes: Partial<View>) {
    if (this.#stage) this.#stage.move(changes);
    else this.#camera = moved(this.#camera, changes);
  }

  #moveByHand(changes: Partial<View>, done: boolean) {
    if ("turn" in changes && this.#turns()) {
      this.#rotation.stop();
      this.requestUpdate();
    }
    this.#move(changes);
    this.#fire(done ? "change" : "input");
  }

  /**
   * The patch under a click gets handles, a click beside the surface takes them away; where de Casteljau's grid is shown,
   * it goes to the place.
   */
  #pick(x: number, y: number) {
    const seen = this.#stage?.sight();
    if (!seen) return;
    const { origin, direction } = rayThrough(seen.sight, x, y, seen.width, seen.height);
    const [hit] = this.#scene().surface.intersectRay(origin, direction);
    this.patch = hit?.patch ?? null;
    if (hit && ["casteljau", "place", "derivatives"].some((each) => this.settings().layers.has(each as any)))
      Object.assign(this, { u: rounded(hit.u), v: rounded(hit.v) });
    this.#fire("change");
  }

  #fire(type: "input" | "change") {
    this.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  }

  #set(name: string, value: unknown, type: "input" | "change") {
    this.#edit(() => Object.assign(this, { [name]: value }), type);
  }

  #toggleRotation() {
    const turning = !this.#turns();
    this.#rotation.ask(turning);
    this.turn = turning;
    this.requestUpdate();
    this.#fire("change");
  }

  #showFile(surface: Surface) {
    this.#awaited = surface;
    const max = Math.floor(Math.sqrt(MAX_TRIANGLES / 2 / surface.patchCount));
    this.#edit(() => {
      this.#show(surface);
      if (this.segments > max) this.segments = Math.max(1, max);
    });
  }

  #backToModel() {
    this.#edit(() => this.#show(null));
  }

  render() {
    const settings = this.settings();
    const name =
      this.label ||
      translated(
        "{0}, in three dimensions",
        this.#subject.given ? translated("A surface of Bézier patches") : MODEL_NAMES[settings.model],
      );
    const zoomed = (factor: number) => () => this.#moveByHand({ zoom: this.view.zoom * factor }, true);
    return frame({
      name,
      blank: !this.#drawn,
      message: this.#files.message || STATES[this.#state](),
      facts: this.#facts,
      language: (this.closest<HTMLElement>("[lang]") ?? this.ownerDocument.documentElement).lang,
      key: this.#key,
      tools: {
        turning: this.#turns(),
        toggle: () => this.#toggleRotation(),
        nearer: zoomed(ZOOM_STEP),
        farther: zoomed(1 / ZOOM_STEP),
        home: () => this.#moveByHand(HOME, true),
      },
      panel: this.controls === null || this.controls === false ? null : this.#panelPort(),
    });
  }

  #panelPort(): PanelPort {
    return {
      settings: this.settings(),
      groups: controlGroups(this.controls),
      size: this.#scene().frame.radius,
      named: !this.#subject.given,
      patches: this.#scene().surface.patchCount,
      edited: this.#subject.edited,
      set: (...args) => this.#set(...args),
      setDetail: (kind) => this.#setDetail(kind),
      can: { undo: this.#history.canUndo, redo: this.#history.canRedo },
      step: (step) => this.#stepByUser(step),
      restore: () => this.#edit(() => this.#subject.restore()),
      savePicture: () => this.#files.savePicture(),
      saveMesh: (kind) => this.#files.saveMesh(kind),
      open: (file) => this.#files.open(file),
      backToModel: () => this.#backToModel(),
    };
  }

  #setDetail(kind: "segments" | "tolerance" | "pixels" | "flatness") {
    const distance = Number((this.#scene().frame.radius * FIRST_TOLERANCE).toPrecision(1));
    const firsts = { tolerance: distance, pixels: FIRST_PIXELS, flatness: distance };
    this.#edit(() => {
      for (const [name, first] of Object.entries(firsts)) Object.assign(this, { [name]: name === kind ? first : null });
    });
  }
}

/** As the sliders have it. */
const rounded = (x: number) => Math.round(100 * x) / 100;
