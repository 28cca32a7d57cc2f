import { Pointed } from "./pointed.js";

/** `<bezier-equation>`; what can be set from outside is documented in types.js. */
export class BezierEquation extends Pointed {
  static properties = {
    t: { type: Number, reflect: true },
    degree: { type: Number, reflect: true },
    basis: { reflect: true },
    matrix: { reflect: true },
    form: { reflect: true },
    editable: { type: Boolean, reflect: true },
  };
  static view = /** @type {const} */ ("EquationView");

  constructor() {
    super();
    this.t = 0.5;
    /** @type {number | null} */
    this.degree = null;
    this.basis = "bezier";
    this.matrix = "";
    this.form = "sum";
    this.editable = false;
  }
}
