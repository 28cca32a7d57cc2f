import { Linked } from "./linked.js";
import { ownPoints, pointsText } from "./points.js";
import type { Point2, PointsLike } from "./points.js";
import type { PropertyDeclarations } from "lit";

/** A companion with points of its own while it is linked to nothing. */
export class LinkedWithPoints extends Linked {
  /** @internal As it was given, good or not. */
  declare given: PointsLike;

  static properties: PropertyDeclarations = {
    given: {
      attribute: "points",
      reflect: true,
      useDefault: true,
      converter: { fromAttribute: (text: string | null) => text, toAttribute: pointsText },
    },
    points: { attribute: false, noAccessor: true },
  };

  constructor() {
    super();
    /** @internal As it was given, good or not. */
    this.given = null;
  }

  get points() {
    return this.places().map((place) => [...place]);
  }

  /** @param given pairs, or text as in the attribute */
  set points(given: PointsLike) {
    this.given = given;
  }

  /**
   * The points that are shown: those of the applet, or its own.
   *
   * @internal
   */
  places(): Point2[] {
    return this.target ? (this.target.figure?.points ?? []) : ownPoints(this.given, (...args) => this.checked(...args));
  }
}
