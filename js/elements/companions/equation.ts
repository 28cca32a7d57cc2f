import { LazyView } from "./loading.js";
import { LinkedWithPoints } from "./with-points.js";

/** `<bezier-equation>`; what can be set from outside is documented in types.js. */
export class BezierEquation extends LinkedWithPoints {
  declare t: number;
  declare degree: number | null;
  declare basis: string;
  declare matrix: string;
  declare form: string;
  declare editable: boolean;

  static properties = {
    t: { type: Number, reflect: true, useDefault: true },
    degree: { type: Number, reflect: true, useDefault: true },
    basis: { reflect: true, useDefault: true },
    matrix: { reflect: true, useDefault: true },
    form: { reflect: true, useDefault: true },
    editable: { type: Boolean, reflect: true, useDefault: true },
  };
  static view = new LazyView(() => import("./equation-view.js"), "EquationView");

  constructor() {
    super();
    this.t = 0.5;
    this.degree = null;
    this.basis = "bezier";
    this.matrix = "";
    this.form = "sum";
    this.editable = false;
  }
}
