import { finiteNumber } from "../editor/check.js";
import { appended, randomized } from "../editor/commands.js";
import { pointPair } from "../editor/plane.js";
import { allPointsToggled } from "../editor/state.js";
import * as changes from "./changes.js";
import { Engine } from "./engine.js";
import { continuityAtP3 } from "./words.js";
import type { Continuity } from "../editor/figure.js";
import type { Box } from "../editor/plane.js";
import type { JointMode, Layers } from "./changes.js";

/**
 * The applet on one canvas, as `bezierApp` returns it.
 *
 * What is written here shows at the next frame and fires no event. What the user does fires "input" while something
 * moves and "change" when it is done:
 *
 *     const app = bezierApp("beziercanvas");
 *     app.addEventListener("input", () => console.log(app.points));
 */
export class BezierApp extends EventTarget {
  #engine;

  /**
   * Starts the applet on a canvas.
   *
   * @internal
   * @param forget called when the applet is taken away
   */
  constructor(canvas: HTMLCanvasElement, context: CanvasRenderingContext2D, box: Box, forget: () => void) {
    super();
    this.#engine = new Engine(canvas, context, box, (type) => this.dispatchEvent(new Event(type)));
    this.#engine.endings.push(forget);
  }

  /**
   * All points as [x, y] in the canvas's own units, y down; also the hidden ones. Assigned
   * points (4, 7, 10 …) are taken as they are; the joint mode holds from the next move on. What cannot be points is
   * refused with a RangeError or TypeError, and the applet stays as it was.
   *
   * @returns a copy
   */
  get points(): [number, number][] {
    return this.#engine.state.points.map(([x, y]) => [x, y]);
  }

  set points(points) {
    this.#engine.command((state) => changes.withPoints(state, points));
  }

  /** How many points are shown: 4, 7, 10 …, at most as many as there are. */
  get visiblePoints() {
    return this.#engine.state.shown;
  }

  set visiblePoints(count) {
    this.#engine.command((state) => changes.withShown(state, count));
  }

  /**
   * What is held at every inner joint, P3 first of all: nothing ("free"), P2, P3, P4 aligned ("g1"), or aligned with
   * P3 half-way ("c1"). Setting it moves P4 to where it must be.
   */
  get joint(): JointMode {
    return this.#engine.state.joints[0] as JointMode;
  }

  set joint(mode) {
    this.#engine.command((state) => changes.withJoint(state, mode));
  }

  /** The parameter from 0 to 1, applied to every segment shown: each has its point, its construction and its halves at t. */
  get t() {
    return this.#engine.state.t;
  }

  set t(t) {
    this.#engine.set(changes.withT(this.#engine.state, t));
  }

  /**
   * What is drawn besides curve and points: polygon, hull, construction, halves. Assigned is an object with those that
   * change: `app.layers = { hull: true }`.
   */
  get layers(): Readonly<Layers> {
    return changes.layersOf(this.#engine.state);
  }

  set layers(some: Partial<Layers>) {
    this.#engine.set(changes.withLayers(this.#engine.state, some));
  }

  /** What holds at P3 now, as `Spline.continuity` reports it; null where four points are shown. */
  get continuity(): Continuity | null {
    return continuityAtP3(this.#engine.figure);
  }

  /**
   * Puts all points at random places inside the picture, the joint mode held.
   *
   * @param seed an integer: equal seeds give equal points
   */
  randomize(seed?: number) {
    const integer = finiteNumber(seed ?? Math.floor(Math.random() * 2 ** 32), "seed", "an integer");
    if (!Number.isInteger(integer)) throw new RangeError(`seed: expected an integer, got ${integer}`);
    this.#engine.command((state) => randomized(state, integer));
  }

  /** Shows four points only; called again, all of them. Nothing is deleted. */
  toggleAllPoints() {
    this.#engine.command(allPointsToggled);
  }

  /** Appends a segment that ends at a point, with two automatic handles; then all points are shown. */
  append(point: [number, number]) {
    const checked = pointPair(point, "point");
    this.#engine.command((state) => appended(state, checked));
  }

  /** Takes back the last change; what the page set before the first action of the user stays. */
  undo() {
    this.#engine.undo();
  }

  /** Repeats the change that was taken back. */
  redo() {
    this.#engine.redo();
  }

  /** Takes the applet away and leaves the page as it was. */
  destroy() {
    this.#engine.end();
  }
}
