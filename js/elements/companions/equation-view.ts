import { css, html, mathml, nothing } from "lit";
import { Curve } from "../../geometry/curve/curve.js";
import { Fields } from "../../ui/number-fields.js";
import {
  bernsteinTerm,
  factor,
  matrix,
  name,
  number,
  pair,
  point,
  polynomial,
  powers,
  sign,
  square,
  symbol,
} from "./formulas.js";
import { shown } from "../../ui/numbers.js";
import { ownMatrix, standaloneCurve } from "./own.js";
import { slider } from "./slider.js";
import { style } from "./style.js";
import { bezierForm, inPoints, subjectOf } from "./subject.js";
import { BASES, MATRIX_DEGREE, matrixOf, throughMatrix, weightsAt } from "./weights.js";
import { translated, translatedTable } from "../../editor/translations.js";
import type { LinkedWithPoints } from "./with-points.js";
import type { Check } from "./points.js";
import type { Subject } from "./subject.js";

const FORMS = ["sum", "matrix", "casteljau"];
const BASIS_NAMES: Record<string, string> = translatedTable({
  bezier: "Bézier",
  hermite: "Hermite",
  "b-spline": "B-spline",
  "catmull-rom": "Catmull-Rom",
  matrix: "own numbers",
});
/** Largest degree whose matrix is shown. */
const MAX_MATRIX = 10;
/** Largest number of levels of de Casteljau's triangle that are shown: the last ones. */
const MAX_LEVELS = 6;

/** The element: its properties as they are given, good or not. */
type Host = LinkedWithPoints & {
  t: number;
  degree: number | null;
  basis: string;
  matrix: string;
  form: string;
  editable: boolean;
};

/**
 * What `<bezier-equation>` shows.
 *
 * @csspart equation - the formula, which scrolls
 * @csspart field - each number of a matrix that can be edited
 */
export class EquationView {
  static styles = [
    style,
    css`
    .scroll { padding: 0.7rem 0.8rem; background: var(--bz-paper); max-block-size: 26rem; }
    math { font-size: 1.05em; math-style: normal; } math[display="block"] { inline-size: max-content; margin: 0 0 0.5rem; }
    .lines + math { margin-block-start: 0.6rem; } .lines mtd { text-align: start; padding: 0.12em 0.35em; } .lines mtd.sign { text-align: end; padding-inline-end: 0; }
    .lines mtr.total mtd { border-block-start: 1px solid var(--bz-field); }
    .matrix { border-inline: 1.5px solid currentColor; border-radius: 4px; margin-inline: 0.2em; } .matrix mtd { padding: 0.1em 0.35em; }
    .product { display: flex; flex-wrap: wrap; gap: 0.4rem; align-items: center; margin-block-end: 0.5rem; }
    .product math { margin: 0; }
    .cells { display: grid; grid-template-columns: repeat(4, 4.3rem); gap: 3px; padding: 4px; border-inline: 2px solid currentColor; border-radius: 4px; }
    .cells input { inline-size: 100%; min-inline-size: 0; appearance: textfield; } .cells .error { grid-column: 1 / -1; }
    .note { padding: 0 0.8rem 0.5rem; }
    @media print { .scroll { max-block-size: none; } }
  `,
  ];
  #host;
  #fields = new Fields({
    read: (key) => this.#matrix()[Number(key)],
    write: (key, value, done) => this.#setMatrix(Number(key), value, done),
    changed: () => this.#host.requestUpdate(),
    paste: (_, text) => this.#pasteMatrix(text),
  });

  constructor(host: Host) {
    this.#host = host;
  }

  #subject() {
    const check = ((...args) => this.#host.checked(...args)) as Check;
    return this.#host.target ? subjectOf(this.#host.target.figure) : standaloneCurve(this.#host, check);
  }

  content() {
    const subject = this.#subject();
    if (!subject) return html`<p class="quiet">${translated("No curve yet.")}</p>`;
    const form = this.#host.checked(
      "form",
      this.#host.form,
      FORMS.includes(this.#host.form),
      `one of ${FORMS.join(", ")}`,
      FORMS[0],
    );
    const body =
      form === "matrix"
        ? this.#matrixForm(subject)
        : form === "casteljau"
          ? casteljauForm(subject)
          : subject.weights
            ? rationalForm(subject)
            : sumForm(subject);
    return html`<div class="frame" part="frame">
      ${slider(subject.t, [Math.min(0, subject.t), Math.max(1, subject.t)], (t, done) => this.#host.setT(t, done))}
      ${form === "matrix" ? this.#chooser(subject) : nothing}
      <div class="scroll" part="equation" role="group" tabindex="0" aria-label=${this.#host.label || translated("Equation")}>${body}</div>
    </div>`;
  }

  #chooser({ basis }: Subject) {
    const words = [...BASES, ...(this.#host.editable || basis === "matrix" ? ["matrix"] : [])];
    const option = (word: string) =>
      html`<option value=${word} .selected=${word === basis}>${BASIS_NAMES[word]}</option>`;
    const onChange = (event: Event) => this.#setBasis((event.target as HTMLSelectElement).value);
    return html`<label class="bar">${translated("Basis")} <select @change=${onChange}>${words.map(option)}</select></label>`;
  }

  #matrixForm(subject: Subject) {
    if (this.#host.editable) subject = editableForm(subject);
    const { basis, degree, t, points, names } = subject;
    const numbers = degree <= MAX_MATRIX ? matrixOf(basis, degree, subject.matrix) : null;
    if (!numbers)
      return html`<p class="quiet">${translated("The matrix is shown up to degree {0}; this is degree {1}.", basis === "bezier" ? MAX_MATRIX : MATRIX_DEGREE, degree)}</p>`;
    const weights = throughMatrix(numbers, t);
    const own = subject.weights;
    const column = matrix(names.map((each) => (own ? [weighted(each), weightName(each)] : [name(each)])));
    const editable = this.#host.editable && numbers.length === 16 && !own;
    const before = html`<math>${own ? HOMOGENEOUS : symbol}${sign("=")}${powers(degree)}</math>`;
    const cell = (_: unknown, k: number) =>
      this.#fields.field(String(k), translated("Row {0}, column {1}", (k >> 2) + 1, (k & 3) + 1), {
        step: "0.1",
        decimals: 4,
      });
    const amid = editable
      ? html`<div class="cells" role="group" aria-label=${translated("Matrix")}>${numbers.map(cell)}</div>`
      : html`<math aria-label=${translated("the matrix {0}", rowsSpoken(numbers))}>${square(numbers)}</math>`;
    const row = matrix([weights.map((x) => number(x))]);
    const rows = own ? homogeneous(points, own) : points;
    const sums = numbersAt(rows, weights);
    const result = own ? matrix([sums.map((each) => number(each))]) : pair(sums);
    return html`<div class="product">${before}${amid}<math>${column}</math></div>
      <math display="block" aria-label=${translated("The powers of t times the matrix are the weights {0}", weights.map((x) => shown(x)).join(", "))}>${matrix([t0(degree, t)])}<mi>M</mi>${sign("=")}${row}</math>
      <math display="block" aria-label=${own ? nothing : spoken(t, sums)}>${own ? HOMOGENEOUS : point(t)}${sign("=")}${row}${matrix(rows.map((p) => p.map((x) => number(x))))}${sign("=")}${result}</math>
      ${own ? quotient(t, sums) : nothing}`;
  }

  #matrix() {
    const given = this.#subject();
    const subject = given && editableForm(given);
    return (subject && matrixOf(subject.basis, subject.degree, subject.matrix)) ?? [];
  }

  #setMatrix(k: number, value: number, done: boolean) {
    this.#giveMatrix(
      this.#matrix().map((x, i) => (i === k ? value : x)),
      done,
    );
  }

  #giveMatrix(numbers: number[], done: boolean) {
    const { target } = this.#host;
    if (target) target.edit({ basis: "matrix", matrix: numbers }, done);
    else this.#host.basis = "matrix";
    this.#host.matrix = numbers.join(" ");
    this.#host.notify(done);
  }

  /** Sixteen numbers at once. */
  #pasteMatrix(text: string) {
    const numbers = ownMatrix(text);
    if (numbers) this.#giveMatrix(numbers, true);
    return numbers !== null;
  }

  #setBasis(basis: string) {
    if (basis === "matrix") return this.#giveMatrix(this.#matrix(), true);
    if (this.#host.target) this.#host.target.edit({ basis }, true);
    else this.#host.basis = basis;
    this.#fields.clear();
    this.#host.notify(true);
  }
}

/** With a matrix that acts on points. */
function editableForm(subject: Subject) {
  return subject.basis === "hermite" ? inPoints(subject, matrixOf("hermite", MATRIX_DEGREE, null) ?? []) : subject;
}

/** Of the weights in a sum. */
const MAX_WEIGHT_DECIMALS = 6;
/** t has two: the products add up. */
const decimalsOf = (degree: number) => Math.min(Math.max(2 * degree, 3), MAX_WEIGHT_DECIMALS);

function sumForm(subject: Subject) {
  const { t, points, names } = subject;
  const weights = weightsAt(subject, t);
  const at = numbersAt(points, weights);
  const formula = symbolic(subject);
  const decimals = decimalsOf(subject.degree);
  const numeric = (i: number, axis: 0 | 1) => mathml`${lineSign(i, weights[i] < 0)}
      <mtd>${number(i ? Math.abs(weights[i]) : weights[i], decimals)}${sign("·")}${factor(points[i][axis])}</mtd>`;
  const head = (letter: string) => mathml`<mrow><mi>${letter}</mi><mo>(</mo>${number(t)}<mo>)</mo></mrow>`;
  return html`<math class="lines" aria-label=${translated("{0}, from {1}", spoken(t, at), weights.map((w, i) => `${shown(w)} ${names[i]}`).join(translated(" plus ")))}><mtable>
    <mtr><mtd class="sign"></mtd><mtd>${symbol}</mtd><mtd class="sign"></mtd><mtd>${head("x")}</mtd><mtd class="sign"></mtd><mtd>${head("y")}</mtd></mtr>
    ${points.map((_, i) => mathml`<mtr>${lineSign(i)}<mtd>${formula(i)}${name(names[i])}</mtd>${numeric(i, 0)}${numeric(i, 1)}</mtr>`)}
    <mtr class="total"><mtd></mtd><mtd></mtd><mtd class="sign">${sign("=")}</mtd><mtd>${number(at[0])}</mtd><mtd class="sign">${sign("=")}</mtd><mtd>${number(at[1])}</mtd></mtr>
  </mtable></math>`;
}

const lineSign = (i: number, minus = false) =>
  mathml`<mtd class="sign">${sign(i === 0 ? "=" : minus ? "−" : "+")}</mtd>`;
const head = (letter: string) => mathml`<mrow><mi>${letter}</mi><mo>(</mo><mi>t</mi><mo>)</mo></mrow>`;
const weightName = (text: string) => name(`w${text.slice(1)}`);
const weighted = (text: string) => mathml`<mrow>${weightName(text)}${name(text)}</mrow>`;
/** [A(t) w(t)]: the sum of the wᵢPᵢ and that of the wᵢ. */
const HOMOGENEOUS = matrix([[head("A"), head("w")]]);

/** B = A / w. */
const quotient = (t: number, [x, y, w]: number[]) =>
  html`<math display="block" aria-label=${spoken(t, [x / w, y / w])}>${point(t)}${sign("=")}<mfrac>${pair([x, y])}${number(w)}</mfrac>${sign("=")}${pair([x / w, y / w])}</math>`;

/** The points (wP, w). */
const homogeneous = (points: number[][], weights: number[]) =>
  points.map(([x, y], i) => [weights[i] * x, weights[i] * y, weights[i]]);

/** Numerator and denominator of a rational curve, and their quotient. */
function rationalForm(subject: Subject) {
  const { t, points, names } = subject;
  const own = subject.weights as number[];
  const formula = symbolic(subject);
  const blend = weightsAt({ ...subject, weights: null }, t);
  const weights = blend.map((value, i) => value * own[i]);
  const sums = numbersAt(homogeneous(points, own), blend);
  const [x, y, w] = sums;
  const decimals = decimalsOf(subject.degree);
  const factors = (i: number, left: unknown, right: unknown) =>
    mathml`${lineSign(i, weights[i] < 0)}<mtd>${left}${sign("·")}${right}</mtd>`;
  const size = (i: number, value: number) => number(i ? Math.abs(value) : value, decimals);
  const empty = mathml`<mtd class="sign"></mtd>`;
  const letters = [head("A"), head("w"), ...["x", "y"].map((axis) => mathml`<msub><mi>A</mi><mi>${axis}</mi></msub>`)];
  return html`<math class="lines" aria-label=${translated("{0}, from {1}, divided by {2}", spoken(t, [x / w, y / w]), weights.map((each, i) => `${shown(each)} ${names[i]}`).join(translated(" plus ")), shown(w))}><mtable>
    <mtr>${letters.map((letter) => mathml`${empty}<mtd>${letter}</mtd>`)}</mtr>
    ${points.map(
      (place, i) => mathml`<mtr>${lineSign(i)}<mtd>${weightName(names[i])}${formula(i)}${name(names[i])}</mtd>
      ${factors(i, number(own[i], 4), size(i, blend[i]))}${place.map((coordinate) => factors(i, size(i, weights[i]), factor(coordinate)))}</mtr>`,
    )}
    <mtr class="total"><mtd></mtd><mtd></mtd>${[w, x, y].map((sum) => mathml`<mtd class="sign">${sign("=")}</mtd><mtd>${number(sum, decimals)}</mtd>`)}</mtr>
  </mtable></math>
  ${quotient(t, sums)}`;
}

/** The formula of each weight. */
function symbolic({ basis, degree, matrix }: Subject): (i: number) => unknown {
  if (basis === "bezier") return (i) => bernsteinTerm(degree, i);
  const numbers = matrixOf(basis, degree, matrix);
  const size = degree + 1;
  if (numbers) return (i) => polynomial(numbers.filter((_, k) => k % size === i));
  return (i) => mathml`<mrow><msub><mi>N</mi><mn>${i}</mn></msub><mo>(</mo><mi>t</mi><mo>)</mo></mrow>`;
}

/** De Casteljau's algorithm: on the points (wP, w) where there are weights. */
function levelsOf({ curve, points, weights, t }: Subject): number[][][] {
  const polynomial = weights ? new Curve(homogeneous(points, weights), { dimension: 3 }) : curve;
  const size = weights ? 3 : 2;
  return (polynomial?.deCasteljau(t) ?? []).map((flat) =>
    Array.from({ length: flat.length / size }, (_, i) => {
      const [x, y, w = 1] = flat.subarray(size * i, size * (i + 1));
      return [x / w, y / w, w];
    }),
  );
}

function casteljauForm(subject: Subject) {
  const { curve, names, basis, t, weights } = subject;
  const levels = levelsOf(subject);
  if (!levels.length) return nothing;
  const first = Math.max(0, levels.length - MAX_LEVELS);
  const bezier = basis === "bezier" || !curve ? names : bezierForm(curve).names;
  const own = (level: number, i: number) => (level ? atLevel("b", number(i), number(level)) : name(bezier[i]));
  const weight = (level: number, i: number) =>
    weights
      ? mathml`<mo separator="true">,</mo>${level ? atLevel("w", number(i), number(level)) : weightName(bezier[i])}${sign("=")}${number(levels[level][i][2])}`
      : nothing;
  const cell = (level: number, i: number) =>
    mathml`<mtd>${levels[level][i] && mathml`${own(level, i)}${sign("=")}${pair(levels[level][i])}${weight(level, i)}`}</mtd>`;
  const columns = Array.from({ length: levels.length - first }, (_, k) => first + k);
  const at = levels[levels.length - 1][0];
  const step = (...letters: string[]) => {
    const next = (i: unknown, k: unknown) => letters.map((letter) => atLevel(letter, i, k));
    const before = mathml`<mrow><mi>k</mi><mo>−</mo><mn>1</mn></mrow>`;
    return mathml`<mrow>${next(mathml`<mi>i</mi>`, mathml`<mi>k</mi>`)}${sign("=")}${number(1 - t)}${next(mathml`<mi>i</mi>`, before)}${sign("+")}${number(t)}${next(mathml`<mrow><mi>i</mi><mo>+</mo><mn>1</mn></mrow>`, before)}</mrow>`;
  };
  return html`<math display="block" aria-label=${translated("Each point lies between two of the level before, at t of the way")}>${weights ? mathml`${step("w", "b")}<mo separator="true">,</mo>${step("w")}` : step("b")}</math>
    ${first ? html`<p class="quiet">${translated("The last {0} of {1} levels:", columns.length, levels.length)}</p>` : nothing}
    <math class="lines" aria-label=${translated("De Casteljau: {0} steps. {1}", levels.length - 1, spoken(t, at))}><mtable>
      ${levels[first].map((_, i) => mathml`<mtr>${columns.map((level) => cell(level, i))}</mtr>`)}
    </mtable></math>`;
}

/** A point or a weight of de Casteljau's algorithm. */
const atLevel = (letter: string, i: unknown, k: unknown) => mathml`<msubsup><mi>${letter}</mi>${i}${k}</msubsup>`;

function numbersAt(points: number[][], weights: number[]) {
  return points[0].map((_, axis) => points.reduce((sum, p, i) => sum + weights[i] * p[axis], 0));
}

const t0 = (degree: number, t: number) => Array.from({ length: degree + 1 }, (_, k) => number(t ** (degree - k)));

const spoken = (t: number, at: number[]) =>
  translated("B of {0} is x {1}, y {2}", shown(t), shown(at[0]), shown(at[1]));

function rowsSpoken(numbers: number[]) {
  const size = Math.sqrt(numbers.length);
  return Array.from({ length: size }, (_, row) =>
    numbers
      .slice(row * size, (row + 1) * size)
      .map((x) => shown(x))
      .join(", "),
  ).join("; ");
}
