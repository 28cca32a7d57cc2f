import { once } from "../loading.js";

/**
 * @import { CSSResult } from "lit"
 */

/**
 * What shows a companion. Each companion creates its own when it is about to become visible for the first time.
 *
 * @typedef {object} View
 * @property {() => unknown} content
 * @property {(event: Event) => void} [attended] the applet gets or loses the focus
 * @property {(done: boolean) => void} [chosen] the user has chosen
 * @property {() => void} [stop] the companion leaves the page
 */

/** @typedef {{ new (host: any): View, styles: CSSResult[] }} ViewClass */

/**
 * The class of a view, which is in a file of its own: fetched when a companion of this kind is about to become visible.
 *
 * @template {string} N
 */
export class LazyView {
  #fetch;
  #name;
  /** The class, once it was fetched. @type {ViewClass | null} */
  loaded = null;

  /**
   * @param {() => Promise<Record<N, unknown>>} fetch
   * @param {N} name
   */
  constructor(fetch, name) {
    this.#fetch = once(fetch, name);
    this.#name = name;
  }

  /** @returns {Promise<ViewClass>} */
  async load() {
    this.loaded = /** @type {ViewClass} */ ((await this.#fetch())[this.#name]);
    return this.loaded;
  }
}
