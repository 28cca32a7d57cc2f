import { Linked } from "./linked.js";
import { LazyView } from "./loading.js";

/** `<bezier-bernstein>`; what can be set from outside is documented in types.js. */
export class BezierBernstein extends Linked {
  declare degree: number;
  declare t: number;
  declare basis: string;

  static properties = {
    degree: { type: Number, reflect: true, useDefault: true },
    t: { type: Number, reflect: true, useDefault: true },
    basis: { reflect: true, useDefault: true },
  };
  static view = new LazyView(() => import("./bernstein-view.js"), "BernsteinView");

  constructor() {
    super();
    this.degree = 3;
    this.t = 0.5;
    this.basis = "bezier";
  }
}
