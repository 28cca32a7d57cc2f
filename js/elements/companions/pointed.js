import { Linked } from "./linked.js";
import { ownPoints, pointsText } from "./points.js";

/**
 * @import { Place, PointsLike } from "./points.js"
 */

/** A companion with points of its own while it is linked to nothing. */
export class Pointed extends Linked {
  /** @type {import("lit").PropertyDeclarations} */
  static properties = {
    given: {
      attribute: "points",
      reflect: true,
      useDefault: true,
      converter: { fromAttribute: (/** @type {string | null} */ text) => text, toAttribute: pointsText },
    },
    points: { attribute: false, noAccessor: true },
  };

  constructor() {
    super();
    /** As it was given, good or not. @type {PointsLike} @internal */
    this.given = null;
  }

  get points() {
    return this.places().map((place) => [...place]);
  }

  /** @param {PointsLike} given pairs, or text as in the attribute */
  set points(given) {
    this.given = given;
  }

  /** @internal @returns {Place[]} what is shown: the applet's points, or its own */
  places() {
    return this.target ? (this.target.figure?.points ?? []) : ownPoints(this.given, (...args) => this.checked(...args));
  }
}
