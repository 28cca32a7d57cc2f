// The picture: a canvas, and over it a handle for each point and each weight.
import { followSize } from "../../ui/canvas-size.js";
import { Handles } from "../../ui/handles.js";
import { followTheme, readTheme } from "../../ui/theme.js";
import { clamped } from "../../editor/plane.js";
import { nameOf } from "../../editor/figure.js";
import { scaleOf, toPlane } from "../../editor/state.js";
import { drawFigure } from "../../layers/draw-figure.js";
import { ROLES } from "../../layers/index.js";
import type { AppletModel } from "./model.js";
import type { Point2 } from "../../editor/state.js";
import type { Layer, LayerMessage } from "../../layers/draw-figure.js";
import type { WeightHandles } from "./weight-handles.js";

export class Picture {
  #model: AppletModel;
  #canvas: HTMLCanvasElement;
  #overlay: HTMLElement;
  /** An element whose computed style has the colours. */
  #probe: HTMLElement;
  #context: CanvasRenderingContext2D;
  #theme;
  /** The length of a CSS pixel in the box's units. */
  #px = 1;
  #points: Handles;
  /** The handle on the leg after point k is that of the weight of point k + 1. */
  #weights: WeightHandles | null = null;
  #stopFollowing: (() => void)[] = [];

  constructor(root: ParentNode, model: AppletModel) {
    const find = (selector: string) => root.querySelector(selector) as any;
    this.#model = model;
    this.#canvas = find("canvas");
    this.#overlay = find(".overlay");
    this.#probe = find(".probe");
    this.#context = this.#canvas.getContext("2d") as CanvasRenderingContext2D;
    this.#theme = readTheme(this.#probe, ROLES);
    this.#points = new Handles(this.#overlay, model.state.box);
  }

  get overlay() {
    return this.#overlay;
  }

  get theme() {
    return this.#theme;
  }

  /** The length of a CSS pixel in the plane. */
  get unitsPerPixel() {
    return this.#px * scaleOf(this.#model.state);
  }

  /**
   * Follows the size and the colours.
   *
   * @param draw draws at once: a canvas of a new size is empty, and a printer does not wait for a frame
   */
  start(draw: () => void) {
    this.#stopFollowing = [
      followTheme(
        this.#probe,
        (theme) => {
          this.#theme = theme;
          draw();
        },
        ROLES,
      ),
      followSize(this.#canvas, this.#overlay, (width) => {
        this.#px = width > 0 ? this.#model.state.box.width / width : 1;
        draw();
      }),
    ];
  }

  end() {
    for (const stop of this.#stopFollowing.splice(0)) stop();
  }

  /** Reads the colours again, which costs as much as drawing. */
  readTheme() {
    this.#theme = readTheme(this.#probe, ROLES);
  }

  /**
   * @param pointer where the user points, in the plane
   * @param layers from the back to the front
   * @returns the messages of the layers
   */
  draw(pointer: Point2 | null, layers: readonly Layer[], readonly: boolean): LayerMessage[] {
    const { state, figure } = this.#model;
    const { width, height } = this.#canvas;
    this.#context.setTransform(width / state.box.width, 0, 0, height / state.box.height, 0, 0);
    const pen = { ctx: this.#context, theme: this.#theme, px: this.#px };
    const messages = drawFigure(pen, { ...state, pointer }, figure, layers);
    this.placeHandles(readonly);
    return messages;
  }

  /** As many handles as points and weights, each at its place. */
  placeHandles(readonly: boolean) {
    const { state, figure, rational } = this.#model;
    const { names, kinds, points } = figure;
    this.#points.update(points, state.view, {
      nameOf: (i) => (state.labels === "none" ? nameOf("P0", i) : names[i]),
      kindOf: (i) => kinds[i],
    });
    if (rational) {
      this.#weights ??= new rational.WeightHandles(this.#overlay);
      this.#weights.update(figure, state);
    }
    for (const input of this.#overlay.getElementsByTagName("input")) input.disabled = readonly;
  }

  /** The place of an event in the plane. */
  planePoint({ clientX, clientY }: { clientX: number; clientY: number }): Point2 {
    const { left, top, width, height } = this.#overlay.getBoundingClientRect();
    const { state } = this.#model;
    return toPlane(state, [
      ((clientX - left) / width) * state.box.width,
      ((clientY - top) / height) * state.box.height,
    ]);
  }

  /** The number of handles: those of the points come first, then those of the weights. */
  get handleCount() {
    return this.#points.count + (this.#weights?.count ?? 0);
  }

  /** The point of a handle, or the point whose weight it changes. */
  handleTarget(index: number): { kind: "point" | "weight"; index: number } {
    const leg = index - this.#points.count;
    return leg < 0 ? { kind: "point", index } : { kind: "weight", index: leg + 1 };
  }

  handleElement(index: number): HTMLElement {
    const leg = index - this.#points.count;
    return leg < 0 ? this.#points.elementOf(index) : (this.#weights as WeightHandles).elementOf(leg);
  }

  /** The place of a handle in the plane. */
  handlePlace(index: number): Point2 {
    const leg = index - this.#points.count;
    const { state, figure } = this.#model;
    return clamped(state.view, leg < 0 ? figure.points[index] : (this.#weights as WeightHandles).placeOf(leg));
  }

  /** Moves the focus to a handle. */
  focusHandle(index: number) {
    const leg = index - this.#points.count;
    if (leg < 0) this.#points.focus(index);
    else this.#weights?.focus(leg);
  }

  /** The point that a slider moves; −1 for anything else. */
  pointOf(input: EventTarget | null): number {
    return this.#points.indexOf(input);
  }

  /** The point whose weight a slider changes; −1 for anything else. */
  weightOf(input: EventTarget | null): number {
    const leg = this.#weights?.indexOf(input) ?? -1;
    return leg < 0 ? -1 : leg + 1;
  }

  /** The value of the slider of the weight of a point. */
  sliderWeight(point: number): number {
    return (this.#weights as WeightHandles).weightOf(point - 1);
  }
}
