import { css, html } from "lit";
import { Fields } from "../../ui/number-fields.js";
import { readPoints } from "../../ui/numbers.js";
import { style } from "./style.js";
import { translated } from "../../editor/translations.js";
import type { LinkedWithPoints } from "./with-points.js";
import type { Point2 } from "./points.js";

const COLUMNS = ["x", "y", "w"] as const;
/** So many columns are coordinates. */
const AXES = 2;
/** Weights go down to 0.001. */
const WEIGHT_DECIMALS = 6;

/**
 * What `<bezier-coordinates>` shows.
 *
 * @csspart table - the table
 * @csspart field - each number in it
 */
export class CoordinatesView {
  static styles = [
    style,
    css`
    .scroll { max-block-size: 24rem; }
    table { border-collapse: collapse; inline-size: 100%; }
    caption { text-align: start; padding: 0.5rem 0.8rem; font-weight: 600; }
    th, td { padding: 0.2rem 0.4rem; text-align: start; font-weight: 600; vertical-align: top; } td { font-weight: 400; }
    tbody th { inline-size: 1%; white-space: nowrap; padding: 0.5rem 0.4rem 0.2rem 0.8rem; }
    thead th { position: sticky; inset-block-start: 0; background: var(--bz-panel); z-index: 1; padding-block: 0.1rem; } thead th:first-child { padding-inline-start: 0.8rem; }
    td input { inline-size: 100%; min-inline-size: 4.5rem; max-inline-size: 11rem; } td .error { display: block; max-inline-size: 16rem; }
    tr:last-child > * { padding-block-end: 0.6rem; }
  `,
  ];
  #host;
  #fields = new Fields({
    read: (key) => this.#row(indexOf(key))[columnOf(key)] ?? 0,
    write: (key, value, done) => this.#set(indexOf(key), columnOf(key), value, done),
    changed: () => this.#host.requestUpdate(),
    paste: (key, text) => this.#paste(key, text),
  });

  constructor(host: LinkedWithPoints) {
    this.#host = host;
  }

  /** Of the points; null without weights. */
  #weights(): number[] | null {
    return this.#host.target?.figure?.weights ?? null;
  }

  /** The coordinates of a point, and its weight where there are weights. */
  #row(index: number): number[] {
    const weights = this.#weights();
    return [...(this.#host.places()[index] ?? []), ...(weights ? [weights[index]] : [])];
  }

  content() {
    const places = this.#host.places();
    const names = this.#host.target?.figure?.names ?? [];
    const title = this.#host.label || translated("Control points");
    const columns = this.#weights() ? COLUMNS : COLUMNS.slice(0, AXES);
    return html`<div class="frame" part="frame"><div class="scroll" role="group" tabindex="0" aria-label=${title}><table part="table">
      <caption>${title}</caption>
      <thead><tr><th scope="col">${translated("Point")}</th>${columns.map((column) => html`<th scope="col"><i>${column}</i></th>`)}</tr></thead>
      <tbody>${places.map((_, i) => this.#fieldsOf(names[i] || `P${i}`, i, columns))}</tbody>
    </table></div></div>`;
  }

  #fieldsOf(name: string, i: number, columns: readonly string[]) {
    const disabled = this.#host.target?.hasAttribute("readonly") ?? false;
    const decimals = (k: number) => (k < AXES ? undefined : WEIGHT_DECIMALS);
    return html`<tr><th scope="row">${name}</th>${columns.map((column, k) => html`<td>${this.#fields.field(`${i}-${k}`, `${name} ${column}`, { disabled, decimals: decimals(k) })}</td>`)}</tr>`;
  }

  #set(index: number, column: number, value: number, done: boolean) {
    if (column < AXES) {
      const place = [...this.#host.places()[index]] as Point2;
      place[column] = value;
      this.#place([place], index, done);
    } else this.#weigh(index, value, done);
    this.#host.notify(done);
  }

  #weigh(index: number, weight: number, done: boolean) {
    const { target } = this.#host;
    const all = (target && "weights" in target ? target.weights : this.#weights()) as number[];
    target?.edit({ weights: all.map((each, i) => (i === index ? weight : each)) }, done);
  }

  /** Points in a row, from the one at `first` on. */
  #place(given: Point2[], first: number, done: boolean) {
    const { target } = this.#host;
    if (target && given.length === 1) return target.edit({ index: first, point: given[0] }, done);
    const all = (target && "points" in target ? target.points : this.#host.places()) as Point2[];
    const points = [...all.slice(0, first), ...given, ...all.slice(first + given.length)];
    if (target) target.edit({ points }, done);
    else this.#host.given = points;
  }

  /** A table of points fills this one, from the point where it was pasted. */
  #paste(key: string, text: string) {
    try {
      this.#place(readPoints(text), indexOf(key), true);
    } catch (error) {
      this.#fields.say(
        key,
        translated("Pasted text: {0}. Nothing is changed.", error instanceof Error ? error.message : error),
      );
      return true;
    }
    this.#fields.clear();
    this.#fields.leave();
    this.#host.notify(true);
    return true;
  }
}

const indexOf = (key: string) => Number(key.split("-")[0]);
const columnOf = (key: string) => Number(key.split("-")[1]);
