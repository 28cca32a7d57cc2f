import { css, html } from "lit";
import { Fields } from "../../ui/number-fields.js";
import { readPoints } from "../../ui/numbers.js";
import { style } from "./style.js";
import { translated } from "../../editor/translations.js";
import type { Pointed } from "./pointed.js";
import type { Point2 } from "./points.js";

const AXES = ["x", "y"] as const;

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
    read: (key) => this.#host.places()[indexOf(key)]?.[axisOf(key)] ?? 0,
    write: (key, value, done) => this.#move(indexOf(key), axisOf(key), value, done),
    changed: () => this.#host.requestUpdate(),
    paste: (key, text) => this.#paste(key, text),
  });

  constructor(host: Pointed) {
    this.#host = host;
  }

  content() {
    const places = this.#host.places();
    const names = this.#host.target?.figure?.names ?? [];
    const title = this.#host.label || translated("Control points");
    return html`<div class="frame" part="frame"><div class="scroll" role="group" tabindex="0" aria-label=${title}><table part="table">
      <caption>${title}</caption>
      <thead><tr><th scope="col">${translated("Point")}</th>${AXES.map((axis) => html`<th scope="col"><i>${axis}</i></th>`)}</tr></thead>
      <tbody>${places.map((_, i) => this.#row(names[i] || `P${i}`, i))}</tbody>
    </table></div></div>`;
  }

  #row(name: string, i: number) {
    const disabled = this.#host.target?.hasAttribute("readonly") ?? false;
    return html`<tr><th scope="row">${name}</th>${AXES.map((axis, k) => html`<td>${this.#fields.field(`${i}-${k}`, `${name} ${axis}`, { disabled })}</td>`)}</tr>`;
  }

  #move(index: number, axis: 0 | 1, value: number, done: boolean) {
    const places = this.#host.places();
    const place = [...places[index]] as Point2;
    place[axis] = value;
    this.#place([place], index, done);
    this.#host.notify(done);
  }

  /** Points in a row, from the one at `first` on. */
  #place(given: Point2[], first: number, done: boolean) {
    const { target } = this.#host;
    if (target && given.length === 1) return target.steer({ index: first, point: given[0] }, done);
    const all = (target && "points" in target ? target.points : this.#host.places()) as Point2[];
    const points = [...all.slice(0, first), ...given, ...all.slice(first + given.length)];
    if (target) target.steer({ points }, done);
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
const axisOf = (key: string) => Number(key.split("-")[1]) as 0 | 1;
