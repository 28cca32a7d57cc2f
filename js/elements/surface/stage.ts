// The canvas and its frames: at most one for each refresh of the display, and only when something has changed.
import { messageOf } from "../../editor/check.js";
import { followSize } from "../../ui/canvas-size.js";
import { moved, cameraMatricesOf } from "./camera.js";
import { FlatView } from "./flat-view.js";
import { Geometry } from "./geometry.js";
import { GlView } from "./gl-view.js";
import { contextSlotOf } from "./context-slot.js";
import { followColours } from "../../ui/theme.js";
import { readTheme } from "./theme.js";
import type { CameraMatrices, View } from "./camera.js";
import type { Facts, Scene } from "./geometry.js";
import type { Theme } from "./theme.js";

/** What the stage reports, and what it asks. */
type Callbacks = {
  /** At the beginning of each frame: pointers that have moved, and the panel */
  render: () => void;
  /** After each frame */
  drawn: (facts: Facts, matrices: CameraMatrices) => void;
  /** The core cannot make this mesh */
  refused: (message: string) => void;
  stateChanged: (state: "webgl" | "flat" | "lost") => void;
  /** Whether the surface rotates by itself */
  isRotating: () => boolean;
};

const ROTATION_DEGREES_PER_SECOND = 24;
/** After so many frames without a movement the camera rests. */
const REST_FRAMES = 3;
/** A frame after a pause (a hidden tab) does not make the picture jump. */
const LONGEST_FRAME_MS = 100;

export class Stage {
  geometry = new Geometry();
  #canvas;
  /** The size of the canvas in CSS pixels; to ask for it in each frame would cost a layout. */
  #size = { width: 0, height: 0 };
  #overlay;
  #probe;
  #callbacks;
  #view: GlView | FlatView | null = null;
  #scene: Scene | null = null;
  /** What the canvas shows; null if it has to be drawn again. */
  #drawnScene: Scene | null = null;
  #theme: Theme | null = null;
  #camera: View;
  #frame = 0;
  #before = 0;
  #framesAtRest = REST_FRAMES;
  #lost = false;
  #slot;
  #endings: (() => void)[] = [];

  /**
   * @param overlay is kept over the canvas
   * @param probe from which colours are read
   */
  constructor(canvas: HTMLCanvasElement, overlay: HTMLElement, probe: HTMLElement, camera: View, callbacks: Callbacks) {
    this.#canvas = canvas;
    this.#overlay = overlay;
    this.#probe = probe;
    this.#camera = camera;
    this.#callbacks = callbacks;
    this.#view = GlView.on(canvas) ?? FlatView.on(canvas);
    this.#lost = this.#view instanceof GlView && this.#view.lost;
    this.#slot = contextSlotOf(canvas);
    if (this.#lost) this.#slot.renew();
    callbacks.stateChanged(this.#lost ? "lost" : this.#view instanceof GlView ? "webgl" : "flat");
    this.#listen();
  }

  #listen() {
    const canvas = this.#canvas;
    const lost = () => {
      this.#lost = true;
      this.#drawnScene = null;
      if (!this.#slot.ended) this.#callbacks.stateChanged("lost");
    };
    const restored = () => {
      this.#lost = false;
      this.#view = GlView.on(canvas);
      this.#callbacks.stateChanged("webgl");
      this.schedule();
    };
    canvas.addEventListener("webglcontextlost", lost);
    canvas.addEventListener("webglcontextrestored", restored);
    this.#endings.push(
      () => canvas.removeEventListener("webglcontextlost", lost),
      () => canvas.removeEventListener("webglcontextrestored", restored),
      followSize(canvas, this.#overlay, (width, height) => {
        this.#size = { width, height };
        this.draw(); // at once: the canvas is empty
      }),
      followColours(() => this.recolour()),
    );
  }

  get camera() {
    return this.#camera;
  }

  move(changes: Partial<View>) {
    this.#camera = moved(this.#camera, changes);
    this.#framesAtRest = 0;
    this.schedule();
  }

  show(scene: Scene) {
    this.#scene = scene;
    if (scene !== this.#drawnScene || this.#callbacks.isRotating()) this.schedule();
  }

  /** The style sheet has other colours now. */
  recolour() {
    this.#theme = null;
    this.schedule();
  }

  /** Releases the WebGL context while the element is far from the visible page: browsers limit their number. */
  suspend() {
    if (!(this.#view instanceof GlView) || this.#lost) return;
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#lost = true;
    this.#view.drop();
    this.#slot.end();
  }

  /** The picture comes back after a rest. */
  wake() {
    this.#slot.renew();
  }

  /** How the scene is projected now; null before there is one. */
  matrices() {
    const { width, height } = this.#size;
    return this.#scene && cameraMatricesOf(this.#camera, this.#scene.sphere, width || 1, height || 1);
  }

  schedule() {
    this.#frame ||= requestAnimationFrame((now) => this.#step(now));
  }

  #step(now: number) {
    try {
      this.#callbacks.render(); // the scene that it shows is drawn in this frame
    } finally {
      this.#frame = 0;
    }
    const passed = Math.min(now - this.#before, LONGEST_FRAME_MS);
    this.#before = now;
    if (this.#callbacks.isRotating() && this.#scene && !this.#lost)
      this.move({ turn: this.#camera.turn + (ROTATION_DEGREES_PER_SECOND * passed) / 1000 });
    this.draw(this.#framesAtRest++ < REST_FRAMES);
    if (this.geometry.outdated) this.schedule();
  }

  /** Draws now. @param moving whether the camera moves */
  draw(moving = false) {
    const [canvas, scene, matrices] = [this.#canvas, this.#scene, this.matrices()];
    if (!scene || !matrices || this.#lost || this.#size.width === 0) return;
    this.#theme ??= readTheme(this.#probe);
    const theme = this.#theme;
    const { width, height } = canvas;
    const ratio = width / matrices.width;
    this.geometry.seen(matrices, moving);
    const facts = this.factsOf(scene);
    if (!facts) return;
    this.#view?.draw({ scene, geometry: this.geometry, matrices, theme, width, height, ratio });
    this.#drawnScene = scene;
    this.#callbacks.drawn(facts, matrices);
  }

  /**
   * The mesh is made before anything is wiped out: where the core refuses (a tolerance that f32 cannot keep), the picture
   * stays as it was.
   */
  factsOf(scene: Scene) {
    try {
      return this.geometry.facts(scene);
    } catch (error) {
      this.#callbacks.refused(messageOf(error));
      return null;
    }
  }

  /** The picture as a file: it is drawn and read in one go, since the browser empties the canvas after a frame. */
  toBlob(): Promise<Blob | null> {
    if (this.#lost) return Promise.resolve(null);
    this.draw();
    return new Promise((done) => this.#canvas.toBlob(done));
  }

  /** Ends frames and listeners and gives the graphics card its memory back. */
  end() {
    cancelAnimationFrame(this.#frame);
    for (const ending of this.#endings) ending();
    if (!this.#lost) this.#view?.drop();
  }
}
