import { LitElement } from "lit";
import { Surface } from "../../surfaces.js";
import { historyStep, isForText } from "../../ui/keys.js";
import { adoptProperties } from "../adopt.js";
import { acceptAttributeText, controlGroups } from "../attribute-text.js";
import { followTranslations } from "../follow-translations.js";
import { PROPERTIES } from "./attributes.js";
import { HOME, moved, rayThrough, ZOOM_STEP } from "./camera.js";
import { FileController } from "./file-controller.js";
import { acceptDrops } from "../../ui/files.js";
import { figureOf } from "./figure.js";
import { frame } from "./frame.js";
import { missing } from "../loading.js";
import { loadDrawing, loadRational } from "./loading.js";
import { ATTRIBUTE_NAMES, isRational } from "./settings.js";
import { whenIdle } from "../start-queue.js";
import { withoutMoves, withPointAt, withSurface } from "./state.js";
import { style } from "./style.js";
import { Subject } from "./subject.js";
import { AutoRotation } from "./auto-rotation.js";
import { MODEL_NAMES, STATES } from "./words.js";
import { translated } from "../../editor/translations.js";
import type { PropertyDeclaration, PropertyDeclarations } from "lit";
import type { Attributes } from "./settings.js";
import type { State } from "./state.js";
import type { View } from "./camera.js";
import type { Facts } from "./geometry.js";
import type { Handles } from "./handles.js";
import type { Labels } from "./labels.js";
import type { Drawing } from "./loading.js";
import type { Stage } from "./stage.js";
import type { PanelPort } from "./panel.js";

/** Root margin for lazy loading. */
const NEAR = "300px";
/** Root margin of the WebGL context: farther away it is released. */
const FAR = "150% 0px";
/** Limit of the triangles in the first picture of a file. */
const MAX_TRIANGLES = 1e6;
/** First values of the sliders: in radii of the surface, and in pixels. */
const [FIRST_TOLERANCE, FIRST_PIXELS] = [0.005, 1];

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
export class BezierSurface extends LitElement {
  // Of the properties, those that are no part of the state.
  declare label: string;
  declare theme: string;
  declare patch: number | null;
  declare controls: string | boolean | null;
  declare autoRotate: boolean;

  static properties: PropertyDeclarations = Object.fromEntries(
    Object.entries(PROPERTIES).map(([name, { declaration }]) => [name, declaration]),
  );

  static getPropertyDescriptor(name: PropertyKey, key: string | symbol, options: PropertyDeclaration) {
    const accessor = isAttribute(name)
      ? BezierSurface.#accessor(name)
      : // biome-ignore lint/complexity/noThisInStatic: Lit's method reads the prototype of the class it is called on
        super.getPropertyDescriptor(name, key, options);
    return acceptAttributeText(accessor, name, options);
  }

  /** A property that is a part of the state. */
  static #accessor(name: keyof Attributes): PropertyDescriptor {
    return {
      configurable: true,
      enumerable: true,
      get(this: BezierSurface) {
        return this.#subject.state[name];
      },
      set(this: BezierSurface, value: unknown) {
        const { editor, state } = this.#subject;
        if (!Object.is(value, state[name])) editor.replaceState({ ...state, [name]: value });
      },
    };
  }

  static styles = style;
  #subject = new Subject((problem) => console.warn(`<${this.localName}> ${problem}`));
  /** The state of the last call of `#stateChanged`. */
  #lastState: State = this.#subject.state;
  #stage: Stage | null = null;
  #handles: Handles | null = null;
  #labels: Labels | null = null;
  #observers: IntersectionObserver[] = [];
  #removeListeners: (() => void) | null = null;
  #camera: View = HOME;
  #pictureState: keyof typeof STATES = "loading";
  /** Loads what draws, since the element was connected. */
  #starting: Promise<void> | null = null;
  #facts: Facts | null = null;
  #rotation = new AutoRotation();
  #files = new FileController({
    show: (surface) => this.#showFile(surface),
    rational: () => this.#rational(),
    changed: () => this.requestUpdate(),
    picture: () => this.toBlob(),
    mesh: () => this.#stage && { mesh: this.#stage.geometry.closedMesh(this.#scene()), up: this.#subject.settings.up },
    names: () => ({
      page: this.ownerDocument,
      name: this.#subject.state.given ? "surface" : this.#subject.settings.model,
    }),
  });
  /** The model of the last picture. */
  #model = "";
  /** The surface that was set last. */
  #awaited: unknown = null;
  #isVisible = false;
  #isNear = false;
  /** Whether the canvas holds a picture: before, and while the WebGL context is released, the poster is shown. */
  #isDrawn = false;

  constructor() {
    super();
    followTranslations(this);
    this.#subject.editor.subscribe((event) => {
      if (event === "state") this.#stateChanged();
      if (event !== "input") this.requestUpdate(); // a complete step can be undone
    });
    for (const [name, { value }] of Object.entries(PROPERTIES)) Object.assign(this, { [name]: value });
  }

  /** Lit renders what has changed and reflects it. */
  #stateChanged() {
    const [before, { state }] = [this.#lastState, this.#subject];
    this.#lastState = state;
    if (before.given !== state.given) this.patch = null;
    for (const name of ATTRIBUTE_NAMES) if (before[name] !== state[name]) this.requestUpdate(name, before[name]);
  }

  /** The surface that is shown, moved points and all. */
  get surface() {
    return this.#subject.surface;
  }

  set surface(surface: Surface | null | undefined) {
    this.#awaited = surface;
    if ((surface as { casteljauType?: string } | null | undefined)?.casteljauType === "rationalsurface") {
      void this.#showWithWeights(surface);
      return;
    }
    const own = surface === undefined || surface === null || surface instanceof Surface;
    this.#replaceSurface(own ? (surface ?? null) : surfaceOfOtherBundle(surface));
  }

  /** Shows a surface with weights when the code for them is there, unless another one is set before. */
  async #showWithWeights(surface: any) {
    const rational = await this.#rational();
    if (!rational || this.#awaited !== surface) return;
    this.#replaceSurface(rational.shownSurface(surface));
  }

  /** The page shows another surface: the undo steps are those of the one before. */
  #replaceSurface(surface: Surface | null) {
    const { editor, state } = this.#subject;
    editor.replaceState(withSurface(state, surface));
    editor.clearHistory();
    this.patch = null;
  }

  /** What surfaces with weights need; null where it cannot be fetched. */
  async #rational() {
    const rational = await loadRational().catch(() => null);
    if (!rational) this.#files.say(missing());
    this.#subject.rational = rational;
    this.requestUpdate();
    return rational;
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
    this.#subject.editor.undo();
  }

  /** Repeats the change that was taken back. */
  redo() {
    this.#subject.editor.redo();
  }

  /** The user changes something, which is one undo step when it is done. */
  #edit(change: (state: State) => State, type: "input" | "change" = "change") {
    const { editor } = this.#subject;
    editor.dispatch(change, { by: "user", merge: true });
    if (type === "change") editor.commit();
    this.#fire(type);
  }

  /** The last pointer has let go of its point. */
  #endDrag() {
    if (!this.#subject.editor.isOpen) return;
    this.#subject.editor.commit();
    this.#fire("change");
  }

  #cancelDrag() {
    if (!this.#subject.editor.isOpen) return;
    this.#subject.editor.revert();
    this.#fire("change");
  }

  #stepByUser(step: "undo" | "redo") {
    const { isOpen, canUndo, canRedo } = this.#subject.editor;
    if (!(step === "undo" ? canUndo || isOpen : canRedo)) return;
    this.#handles?.release();
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
    await this.#starting;
    if (this.isConnected) await this.updateComplete; // updates begin when it is connected for the first time
    return this.#stage?.toBlob() ?? null;
  }

  connectedCallback() {
    super.connectedCallback();
    adoptProperties(this, ["surface", "view"]);
    this.#observers = [
      this.#observe(FAR, (near) => this.#setNear(near)),
      this.#observe(NEAR, (visible) => this.#setVisible(visible)),
    ];
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#observers.forEach((observer) => observer.disconnect());
    this.#observers = [];
    this.#starting = null;
    this.#removeListeners?.();
    this.#removeListeners = null;
    this.#camera = this.view;
    this.#handles?.release();
    this.#subject.editor.commit();
    this.#stage?.end();
    this.#stage = null;
    this.#isDrawn = false;
  }

  #observe(margin: string, act: (inside: boolean) => void) {
    const observer = new IntersectionObserver((entries) => act(entries[entries.length - 1].isIntersecting), {
      rootMargin: margin,
    });
    observer.observe(this);
    return observer;
  }

  /** Far away, it releases the WebGL context. */
  #setNear(near: boolean) {
    this.#isNear = near;
    if (near) return;
    this.#stage?.suspend();
    this.#setDrawn(false);
  }

  #setDrawn(drawn: boolean) {
    if (drawn === this.#isDrawn) return;
    this.#isDrawn = drawn;
    this.requestUpdate();
  }

  #setVisible(visible: boolean) {
    this.#isVisible = visible;
    if (!visible) return;
    this.#isNear = true; // the other observer may report later
    if (!this.#stage) this.#starting ??= this.#start();
    this.#stage?.wake();
    this.#stage?.schedule();
  }

  /** Loads what draws. An element that was disconnected meanwhile, and perhaps connected again, has other observers. */
  async #start() {
    const observers = this.#observers;
    const drawing = await loadDrawing().catch(() => null);
    await whenIdle();
    if (observers !== this.#observers || !this.isConnected) return;
    this.#starting = null;
    if (!this.#isNear) return; // it was scrolled past
    if (drawing) return this.#build(drawing);
    this.#setPictureState("missing");
  }

  #setPictureState(state: keyof typeof STATES) {
    this.#pictureState = state;
    this.requestUpdate();
  }

  #build({ Gestures, Handles, Labels, Stage }: Drawing) {
    const find = (selector: string) => this.renderRoot.querySelector(selector) as any;
    const canvas = find("canvas");
    this.#stage = new Stage(canvas, find(".overlay"), find(".probe"), this.#camera, {
      render: () => this.#renderNow(),
      drawn: (facts, matrices) => {
        this.#handles?.place(matrices);
        this.#labels?.place(matrices);
        this.#setDrawn(true);
        this.#publish(facts);
      },
      refused: (message) => this.#files.say(message),
      stateChanged: (state) => this.#setPictureState(state),
      isRotating: () => this.#isVisible && this.#isRotating(),
    });
    this.#handles ??= new Handles(find(".overlay"), {
      moved: (vertex, to, done) =>
        this.#edit((state) => withPointAt(state, this.#subject.modelKey, vertex, to), done ? "change" : "input"),
      dropped: () => this.#endDrag(),
      cancelled: () => this.#cancelDrag(),
      schedule: () => this.#stage?.schedule(),
      matrices: () => this.#stage?.matrices() ?? null,
    });
    this.#labels ??= new Labels(find(".overlay"));
    const gestures = new Gestures(canvas, {
      view: () => this.view,
      move: (changes, done) => this.#moveByUser(changes, done),
      home: () => this.#moveByUser(HOME, true),
      pick: (x, y) => this.#pick(x, y),
    });
    const endings = [gestures.listen(), acceptDrops(find(".stage"), (file) => this.#files.open(file))];
    this.#removeListeners = () => endings.forEach((end) => end());
    this.requestUpdate();
  }

  /** Pointers that have moved, and the panel if it is to be rendered. */
  #renderNow() {
    this.#handles?.apply();
    if (this.isUpdatePending) this.performUpdate();
  }

  #scene() {
    return this.#subject.scene(this.patch);
  }

  willUpdate(changed: Map<string, unknown>) {
    if (!this.hasUpdated) return;
    if (["model", "height", "up"].some((name) => changed.has(name))) {
      this.#subject.forgetMovesOfOthers();
      if (!changed.has("patch")) this.patch = null;
    }
  }

  updated(changed: Map<string, unknown>) {
    if (changed.has("autoRotate") && this.autoRotate) this.#rotation.restart();
    if (changed.has("theme")) this.#stage?.recolour();
    if (this.#stage) {
      const { model } = this.#subject.settings;
      if (model !== this.#model && isRational(model)) void this.#rational();
      this.#model = model;
      const scene = this.#scene();
      this.#handles?.update(scene);
      this.#labels?.update(scene);
      this.#stage.show(scene);
    }
    this.dispatchEvent(new Event("update"));
  }

  #isRotating() {
    return this.#rotation.isOn(this.autoRotate);
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

  #moveByUser(changes: Partial<View>, done: boolean) {
    if ("turn" in changes && this.#isRotating()) {
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
    const matrices = this.#stage?.matrices();
    if (!matrices) return;
    const { origin, direction } = rayThrough(matrices, x, y);
    const [hit] = this.#scene().surface.intersectRay(origin, direction);
    this.patch = hit?.patch ?? null;
    if (hit && ["casteljau", "place", "derivatives"].some((each) => this.#subject.settings.layers.has(each as any)))
      Object.assign(this, { u: rounded(hit.u), v: rounded(hit.v) });
    this.#fire("change");
  }

  #fire(type: "input" | "change") {
    this.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  }

  #toggleRotation() {
    const isRotating = !this.#isRotating();
    this.#rotation.ask(isRotating);
    this.autoRotate = isRotating;
    this.requestUpdate();
    this.#fire("change");
  }

  #showFile(surface: Surface) {
    this.#awaited = surface;
    const max = Math.max(1, Math.floor(Math.sqrt(MAX_TRIANGLES / 2 / surface.patchCount)));
    this.#edit((state) => {
      const isTooFine = Number(state.segments) > max;
      return { ...withSurface(state, surface), ...(isTooFine && { segments: max }) };
    });
  }

  render() {
    const settings = this.#subject.settings;
    const name =
      this.label ||
      translated(
        "{0}, in three dimensions",
        this.#subject.state.given ? translated("A surface of Bézier patches") : MODEL_NAMES[settings.model],
      );
    const zoomed = (factor: number) => () => this.#moveByUser({ zoom: this.view.zoom * factor }, true);
    return frame({
      name,
      blank: !this.#isDrawn,
      message: this.#files.message || STATES[this.#pictureState](),
      facts: this.#facts,
      language: (this.closest<HTMLElement>("[lang]") ?? this.ownerDocument.documentElement).lang,
      key: this.#key,
      tools: {
        isRotating: this.#isRotating(),
        toggle: () => this.#toggleRotation(),
        nearer: zoomed(ZOOM_STEP),
        farther: zoomed(1 / ZOOM_STEP),
        home: () => this.#moveByUser(HOME, true),
      },
      panel: this.controls === null || this.controls === false ? null : this.#panelPort(),
    });
  }

  #panelPort(): PanelPort {
    const { settings, state, editor } = this.#subject;
    const { sphere, surface } = this.#scene();
    return {
      settings,
      groups: controlGroups(this.controls),
      size: sphere.radius,
      named: !state.given,
      patches: surface.patchCount,
      edited: state.moves.size > 0,
      set: (name, value, type) => this.#edit((state) => ({ ...state, [name]: value }), type),
      setDetail: (kind) => this.#setDetail(kind),
      can: { undo: editor.canUndo, redo: editor.canRedo },
      step: (step) => this.#stepByUser(step),
      restore: () => this.#edit(withoutMoves),
      savePicture: () => this.#files.savePicture(),
      saveMesh: (kind) => this.#files.saveMesh(kind),
      open: (file) => this.#files.open(file),
      backToModel: () => this.#edit((state) => withSurface(state, null)),
    };
  }

  #setDetail(kind: "segments" | "tolerance" | "pixels" | "flatness") {
    const distance = Number((this.#scene().sphere.radius * FIRST_TOLERANCE).toPrecision(1));
    const firsts = { tolerance: distance, pixels: FIRST_PIXELS, flatness: distance };
    const values = Object.entries(firsts).map(([name, first]) => [name, name === kind ? first : null]);
    this.#edit((state) => ({ ...state, ...Object.fromEntries(values) }));
  }
}

const isAttribute = (name: PropertyKey): name is keyof Attributes => ATTRIBUTE_NAMES.some((each) => each === name);

/** As the sliders have it. */
const rounded = (x: number) => Math.round(100 * x) / 100;
