// What the user does in `<bezier-surface>`. Pointers, keys and controls become changes of the editor's state or of the camera;
// controls and picture are rendered together in the next frame.
import { acceptDrops, save } from "../../ui/files.js";
import { historyStep, isForText } from "../../ui/keys.js";
import { messageOf } from "../../editor/check.js";
import { controlGroups } from "../attribute-text.js";
import { missing } from "../loading.js";
import { whenIdle } from "../start-queue.js";
import { AutoRotation } from "./auto-rotation.js";
import { HOME, moved, rayThrough } from "./camera.js";
import { meshFile, surfaceIn } from "./files.js";
import { loadDrawing, loadRational } from "./loading.js";
import { isRational } from "./settings.js";
import { withoutMoves, withPointAt, withSurface } from "./state.js";
import { MODEL_NAMES, STATES } from "./words.js";
import { translated } from "../../editor/translations.js";
import type { LitElement } from "lit";
import type { Surface } from "../../surfaces.js";
import type { ControlGroups } from "../attribute-text.js";
import type { CameraMatrices, View } from "./camera.js";
import type { Facts, Scene } from "./geometry.js";
import type { Handles } from "./handles.js";
import type { Labels } from "./labels.js";
import type { Drawing, Rational } from "./loading.js";
import type { Settings } from "./settings.js";
import type { Stage } from "./stage.js";
import type { State } from "./state.js";
import type { Subject } from "./subject.js";

/** The element as its controller sees it. */
export type SurfaceHost = LitElement & {
  subject: Subject;
  label: string;
  patch: number | null;
  controls: string | boolean | null;
  autoRotate: boolean;
  /** Renders the controls at once if they are to be rendered */
  renderControls: () => void;
};

/** Limit of the triangles in the first picture of a file. */
const MAX_TRIANGLES = 1e6;
/** First values of the sliders: in radii of the surface, and in pixels. */
const [FIRST_TOLERANCE, FIRST_PIXELS] = [0.005, 1];

export class SurfaceController {
  host: SurfaceHost;
  /** The mesh of the last picture; null before. */
  facts: Facts | null = null;
  /** Whether the canvas holds a picture: before, and while the WebGL context is released, the poster is shown. */
  isDrawn = false;
  rotation: AutoRotation = new AutoRotation();
  #stage: Stage | null = null;
  #handles: Handles | null = null;
  #labels: Labels | null = null;
  #removeListeners: (() => void) | null = null;
  /** The camera while there is no stage. */
  #camera: View = HOME;
  #pictureState: keyof typeof STATES = "loading";
  /** Loads what draws, since the element was connected. */
  #starting: Promise<void> | null = null;
  #isVisible = false;
  #isNear = false;
  /** The model of the last picture. */
  #model = "";
  #message = "";
  /** Whether the message stays until the next file: what is wrong with a setting goes with it. */
  #isLasting = false;
  /** The file that was opened last: an earlier one that is read later is not shown. */
  #opened: File | null = null;

  constructor(host: SurfaceHost) {
    this.host = host;
  }

  get subject() {
    return this.host.subject;
  }

  get scene(): Scene {
    return this.subject.scene(this.host.patch);
  }

  // The picture

  /** The element is within the distance at which it has a WebGL context, or no longer. */
  setNear(near: boolean) {
    this.#isNear = near;
    if (near) return;
    this.#stage?.suspend();
    this.#setDrawn(false);
  }

  /** The element is within the distance at which it is drawn, or no longer. */
  setVisible(visible: boolean) {
    this.#isVisible = visible;
    if (!visible) return;
    this.#isNear = true; // the other observer may report later
    if (!this.#stage) this.#starting ??= this.#start();
    this.#stage?.wake();
    this.#stage?.schedule();
  }

  /** Leaves nothing running. */
  end() {
    this.#starting = null;
    this.#removeListeners?.();
    this.#removeListeners = null;
    this.#camera = this.view;
    this.#handles?.release();
    this.subject.editor.commit();
    this.#stage?.end();
    this.#stage = null;
    this.isDrawn = false;
  }

  #setDrawn(drawn: boolean) {
    if (drawn === this.isDrawn) return;
    this.isDrawn = drawn;
    this.host.requestUpdate();
  }

  /** Loads what draws. An element that was disconnected meanwhile, and perhaps connected again, starts anew. */
  #start(): Promise<void> {
    const starting: Promise<void> = loadDrawing()
      .catch(() => null)
      .then(async (drawing) => {
        await whenIdle();
        if (starting !== this.#starting) return;
        this.#starting = null;
        if (!this.#isNear) return; // it was scrolled past
        if (drawing) this.#build(drawing);
        else this.#setPictureState("missing");
      });
    return starting;
  }

  #setPictureState(state: keyof typeof STATES) {
    this.#pictureState = state;
    this.host.requestUpdate();
  }

  #build({ Gestures, Handles, Labels, Stage }: Drawing) {
    const find = (selector: string) => this.host.renderRoot.querySelector(selector) as any;
    const [canvas, overlay] = [find("canvas"), find(".overlay")];
    this.#stage = new Stage(canvas, overlay, find(".probe"), this.#camera, {
      render: () => this.#render(),
      drawn: (facts, matrices) => this.#drawn(facts, matrices),
      refused: (message) => this.#say(message),
      stateChanged: (state) => this.#setPictureState(state),
      isRotating: () => this.#isVisible && this.isRotating,
    });
    this.#handles ??= new Handles(overlay, {
      moved: (vertex, to, isDone) =>
        this.edit((state) => withPointAt(state, this.subject.modelKey, vertex, to), isDone),
      dropped: () => this.#endDrag(() => this.subject.editor.commit()),
      cancelled: () => this.#endDrag(() => this.subject.editor.revert()),
      schedule: () => this.#stage?.schedule(),
      matrices: () => this.#stage?.matrices() ?? null,
    });
    this.#labels ??= new Labels(overlay);
    const gestures = new Gestures(canvas, {
      view: () => this.view,
      move: (changes, done) => this.moveByUser(changes, done),
      pick: (x, y) => this.#pick(x, y),
    });
    const endings = [gestures.listen(), acceptDrops(find(".stage"), (file) => this.open(file))];
    this.#removeListeners = () => endings.forEach((end) => end());
    this.host.requestUpdate();
  }

  /** Pointers that have moved, and the controls if they are to be rendered. */
  #render() {
    this.#handles?.apply();
    this.host.renderControls();
  }

  #drawn(facts: Facts, matrices: CameraMatrices) {
    this.#handles?.place(matrices);
    this.#labels?.place(matrices);
    this.#setDrawn(true);
    this.#publish(facts);
  }

  /** The read-out follows the mesh. */
  #publish(facts: Facts) {
    if (!this.#isLasting) this.#say(""); // all went well
    const before = this.facts;
    this.facts = facts;
    const onGpu = (each: Facts) => each.ms === null;
    // Another time alone is no reason for an update.
    const time = before && onGpu(before) === onGpu(facts) ? before.ms : facts.ms;
    if (JSON.stringify(before) === JSON.stringify({ ...facts, ms: time })) return;
    this.host.requestUpdate();
  }

  /** After an update of the element: shows its scene. */
  update(changed: Map<string, unknown>) {
    if (changed.has("autoRotate") && this.host.autoRotate) this.rotation.restart();
    if (changed.has("theme")) this.#stage?.recolour();
    if (!this.#stage) return;
    const { model } = this.settings;
    if (model !== this.#model && isRational(model)) void this.loadRational();
    this.#model = model;
    const { scene } = this;
    this.#handles?.update(scene);
    this.#labels?.update(scene);
    this.#stage.show(scene);
  }

  /** The mesh of a scene; before the first picture, null. */
  factsOf(scene: Scene) {
    return (this.facts && this.#stage?.factsOf(scene)) ?? this.facts;
  }

  /** The picture as it is now, a PNG. */
  async toBlob(): Promise<Blob | null> {
    await this.#starting;
    if (this.host.isConnected) await this.host.updateComplete; // updates begin when it is connected for the first time
    return this.#stage?.toBlob() ?? null;
  }

  // The camera

  get view(): View {
    return { ...(this.#stage?.camera ?? this.#camera) };
  }

  move(changes: Partial<View>) {
    if (this.#stage) this.#stage.move(changes);
    else this.#camera = moved(this.#camera, changes);
  }

  moveByUser(changes: Partial<View>, isDone: boolean) {
    if ("turn" in changes && this.isRotating) {
      this.rotation.stop();
      this.host.requestUpdate();
    }
    this.move(changes);
    this.#fire(isDone);
  }

  zoom(factor: number) {
    this.moveByUser({ zoom: this.view.zoom * factor }, true);
  }

  goHome() {
    this.moveByUser(HOME, true);
  }

  get isRotating() {
    return this.rotation.isOn(this.host.autoRotate);
  }

  toggleRotation() {
    const isRotating = !this.isRotating;
    this.rotation.ask(isRotating);
    this.host.autoRotate = isRotating;
    this.host.requestUpdate();
    this.#fire(true);
  }

  // Changes

  #fire(isDone: boolean) {
    this.host.dispatchEvent(new Event(isDone ? "change" : "input", { bubbles: true, composed: true }));
  }

  /** The user changes something, which is one undo step when it is done. */
  edit(change: (state: State) => State, isDone = true) {
    const { editor } = this.subject;
    editor.dispatch(change, { by: "user", merge: true });
    if (isDone) editor.commit();
    this.#fire(isDone);
  }

  #endDrag(end: () => void) {
    if (!this.subject.editor.isOpen) return;
    end();
    this.#fire(true);
  }

  /** Undoes or redoes a step, if there is one. */
  step(step: "undo" | "redo") {
    const { editor } = this.subject;
    if (!(step === "undo" ? editor.canUndo || editor.isOpen : editor.canRedo)) return;
    this.#handles?.release();
    editor[step]();
    this.#fire(true);
  }

  press(event: KeyboardEvent) {
    const step = historyStep(event);
    if (!step || isForText(event)) return;
    event.preventDefault();
    this.step(step);
  }

  /**
   * The patch under a click gets handles, a click beside the surface takes them away; where de Casteljau's grid is shown,
   * it goes to the place.
   */
  #pick(x: number, y: number) {
    const matrices = this.#stage?.matrices();
    if (!matrices) return;
    const { origin, direction } = rayThrough(matrices, x, y);
    const [hit] = this.scene.surface.intersectRay(origin, direction);
    this.host.patch = hit?.patch ?? null;
    if (hit && ["casteljau", "place", "derivatives"].some((each) => this.settings.layers.has(each as any)))
      Object.assign(this.host, { u: rounded(hit.u), v: rounded(hit.v) });
    this.#fire(true);
  }

  /** Another value of an attribute. */
  set(name: string, value: unknown, isDone = true) {
    this.edit((state) => ({ ...state, [name]: value }), isDone);
  }

  setDetail(kind: string) {
    const distance = Number((this.scene.sphere.radius * FIRST_TOLERANCE).toPrecision(1));
    const firsts = { tolerance: distance, pixels: FIRST_PIXELS, flatness: distance };
    const values = Object.entries(firsts).map(([name, first]) => [name, name === kind ? first : null]);
    this.edit((state) => ({ ...state, ...Object.fromEntries(values) }));
  }

  /** Takes back all moves. */
  restore() {
    this.edit(withoutMoves);
  }

  backToModel() {
    this.edit((state) => withSurface(state, null));
  }

  // Files

  /** What surfaces with weights need; null where it cannot be fetched. */
  async loadRational(): Promise<Rational | null> {
    const rational = await loadRational().catch(() => null);
    if (!rational) this.#say(missing());
    this.subject.rational = rational;
    this.host.requestUpdate();
    return rational;
  }

  #say(message: string, isLasting = false) {
    if (message === this.#message) return;
    [this.#message, this.#isLasting] = [message, isLasting];
    this.host.requestUpdate();
  }

  /** Shows the surface of a file; where there is none in it, says why and leaves all as it was. */
  async open(file: File) {
    this.#opened = file;
    try {
      const surface = await surfaceIn(file, () => this.loadRational());
      if (file !== this.#opened) return;
      this.#showFile(surface);
      this.#say("");
    } catch (error) {
      if (file === this.#opened) this.#say(`${file.name}: ${messageOf(error)}`, true);
    }
  }

  #showFile(surface: Surface) {
    this.subject.assigned = surface;
    const max = Math.max(1, Math.floor(Math.sqrt(MAX_TRIANGLES / 2 / surface.patchCount)));
    this.edit((state) => {
      const isTooFine = Number(state.segments) > max;
      return { ...withSurface(state, surface), ...(isTooFine && { segments: max }) };
    });
  }

  #save(ending: string, blob: Blob) {
    save(this.host.ownerDocument, `${this.hasModel ? this.settings.model : "surface"}.${ending}`, blob);
  }

  saveMesh(kind: "obj" | "stl" | "glb") {
    if (this.#stage) this.#save(kind, meshFile(this.#stage.geometry.closedMesh(this.scene), kind, this.settings.up));
  }

  async savePicture() {
    const blob = await this.toBlob();
    if (blob) this.#save("png", blob);
  }

  // What is shown and said

  /** The name of the picture for screen readers. */
  get name() {
    const model = MODEL_NAMES[this.settings.model];
    const subject = this.hasModel ? model : translated("A surface of Bézier patches");
    return this.host.label || translated("{0}, in three dimensions", subject);
  }

  /** The message on the picture. */
  get message() {
    return this.#message || STATES[this.#pictureState]();
  }

  get settings(): Settings {
    return this.subject.settings;
  }

  /** Whether a model of the list is shown. */
  get hasModel() {
    return !this.subject.state.given;
  }

  /** The language of numbers. */
  get language() {
    return (this.host.closest<HTMLElement>("[lang]") ?? this.host.ownerDocument.documentElement).lang;
  }

  get hasControls() {
    return this.host.controls !== null && this.host.controls !== false;
  }

  /** The groups of controls that are shown; none means all, with what is used less behind "More". */
  get groups(): ControlGroups {
    return controlGroups(this.host.controls);
  }
}

/** As the sliders have it. */
const rounded = (x: number) => Math.round(100 * x) / 100;
