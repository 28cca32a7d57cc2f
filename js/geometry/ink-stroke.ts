import * as check from "./check.js";
import { regionsModule } from "../wasm/regions-module.js";
import { endOfPath, readPath } from "./path/path-boolean.js";
import { pathOf } from "./path/path.js";
import { showInNode } from "./inspected.js";
import { flatten } from "./points.js";
import type { PointsLike } from "./check.js";
import type { Path } from "./path/path.js";
import type { WidthProfile } from "./path/path-stroke.js";
import type { Spline } from "./spline/spline.js";

/** The options of an `InkStroke`. */
export interface InkOptions {
  /** The width at a pressure of 0.5, above 0 */
  size: number;
  /**
   * How much the width follows the pressure p, from −1 to 1: it is size·(1 + thinning·(2p − 1)). 0.5 by default; a negative
   * number makes fast strokes wider
   */
  thinning?: number;
  /**
   * The lengths over which the width grows from 0 at the start and shrinks to 0 at the end: 0 by default. In a stroke that
   * is shorter than both, they have the same ratio and fill it
   */
  taper?: { start?: number; end?: number };
  /** From 0 to 1: positions and widths are averaged over this part of `size` along the stroke. 0.5 by default */
  smoothing?: number;
  /** From 0 to 1, how far each position stays behind its sample: 0.5 by default. The stroke ends at the last sample */
  streamline?: number;
  /**
   * The largest distance of the curve from the smoothed samples, and of the outline from that of the curve: 2.5 % of `size`
   * by default
   */
  tolerance?: number;
  /**
   * Where the pressure comes from: "simulated", from the speed (a fast stroke has little pressure), or "device", from the
   * samples. "simulated" by default
   */
  pressure?: "simulated" | "device";
}

/** What a sample of an `InkStroke` has besides its position. */
export interface InkSample {
  /** From 0 to 1; used with `pressure: "device"`, and 0.5 by default */
  pressure?: number;
  /**
   * In milliseconds, for example `event.timeStamp`; used with `pressure: "simulated"`. Samples without times, or not later
   * than the one before, count as 10 ms apart
   */
  time?: number;
}

const OPTIONS = ["size", "thinning", "taper", "smoothing", "streamline", "tolerance", "pressure"] as const;
const PRESSURES = ["simulated", "device"] as const;

/** Whether Node knows how to show the instances. */
let isShown = false;

/** Frees what a stroke has in the module of regions; made with the first stroke, so that bundlers can drop an unused class. */
let strokes: FinalizationRegistry<number> | undefined;

/**
 * A freehand stroke that grows with the samples of a pointer: a smooth curve of few cubics, whose width follows the pressure
 * or the speed.
 *
 *     const ink = new InkStroke({ size: 12 });
 *     canvas.onpointermove = ({ offsetX: x, offsetY: y, timeStamp: time }) => ink.append(x, y, { time });
 *     canvas.onpointerup = () => context.fill(ink.outline().toPath2D());
 *
 * Positions are pulled towards the ones before (streamline), averaged along the stroke (smoothing), and fitted by cubics
 * within the tolerance. The outline is that of `path.stroke(widths)` with round caps and joins.
 */
export class InkStroke {
  #index;

  /**
   * A stroke without samples.
   *
   * @param options `size`, and more
   * @throws {RangeError} for an option outside of its range
   */
  constructor(options: InkOptions) {
    if (!isShown) show();
    const checked = check.options(options, OPTIONS);
    const { thinning = 0.5, taper, smoothing = 0.5, streamline = 0.5, tolerance, pressure = "simulated" } = checked;
    const { start = 0, end = 0 } = check.object(taper, "taper");
    check.oneOf(pressure, "pressure", PRESSURES);
    const numbers = [
      check.finite(checked.size, "size"),
      check.finite(thinning, "thinning"),
      check.finite(start, "start"),
      check.finite(end, "end"),
      check.finite(smoothing, "smoothing"),
      check.finite(streamline, "streamline"),
      check.optionalTolerance(tolerance),
    ];
    regionsModule.write(Float64Array.from(numbers));
    this.#index = regionsModule.count(regionsModule.functions.region_ink_begin(pressure === "device"));
    strokes ??= new FinalizationRegistry((index) => regionsModule.functions.region_ink_end(index));
    strokes.register(this, this.#index);
  }

  /**
   * Appends a sample of the pointer. One at the position of the last sample adds nothing, except that the first position takes
   * its pressure.
   *
   * @param x the position
   * @param y in the same unit as `size`
   * @param sample `pressure` and `time`, if the device has them
   * @returns the stroke
   */
  append(x: number, y: number, sample?: InkSample): this {
    const { pressure = NaN, time = NaN } = check.options(sample, ["pressure", "time"]);
    if (sample?.pressure !== undefined) check.finite(pressure, "pressure");
    if (sample?.time !== undefined) check.finite(time, "time");
    const [atX, atY] = [check.coordinate(x, "x"), check.coordinate(y, "y")];
    regionsModule.count(regionsModule.functions.region_ink_append(this.#index, atX, atY, pressure, time));
    return this;
  }

  /**
   * The contours that are new since the last call, for drawing while the pointer moves. Contours overlap, and fill the stroke
   * under the nonzero rule.
   *
   *     const { settled, open } = ink.changes();
   *     drawing.fill(settled.toPath2D()); // stays
   *     preview.clearRect(0, 0, width, height);
   *     preview.fill(open.toPath2D()); // is drawn anew in each frame
   *
   * The end of the stroke is open over the length of its taper, and the whole stroke while it is shorter than both tapers.
   *
   * @param predicted positions that the pointer may have next, for example those of `event.getPredictedEvents()`: only
   *   `open` reaches them
   * @returns `settled`: contours that later samples do not change; `open`: those of the rest, which replace the last ones
   */
  changes(predicted: PointsLike = []): { settled: Path; open: Path } {
    const { flat } = flatten(predicted, 2, 2, "predicted");
    regionsModule.write(flat);
    const numbers = readPath(regionsModule.functions.region_ink_changes(this.#index, flat.length / 2));
    const end = endOfPath(numbers, 0);
    return { settled: pathOf(numbers.slice(0, end)), open: pathOf(numbers.slice(end)) };
  }

  /** The outline as a region without overlaps. Without samples it is empty, and a single point is a disc. */
  outline(): Path {
    return pathOf(readPath(regionsModule.functions.region_ink_outline(this.#index)));
  }

  /** The centre line; null without samples. A single point is a line of length 0. */
  spline(): Spline<2> | null {
    const { subpaths } = pathOf(readPath(regionsModule.functions.region_ink_spline(this.#index)));
    return subpaths[0] ?? null;
  }

  /** The widths along the centre line, as `path.stroke` takes them. */
  widths(): WidthProfile {
    const length = regionsModule.functions.region_ink_widths(this.#index);
    const numbers = regionsModule.read(0, length);
    const stops = Array.from({ length: numbers.length / 2 }, (_, k) => [numbers[2 * k], numbers[2 * k + 1]]);
    return { stops, at: "length", interpolation: "smooth" };
  }
}

/** Outside of the class, so that it does not refer to itself; see `markClassNames` in xtask/bundle.js. */
function show() {
  isShown = showInNode(InkStroke.prototype, "InkStroke", (value) => ({ spline: value.spline() }));
}
