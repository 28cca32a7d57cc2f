import { once } from "../loading.js";

/**
 * @import { CSSResult } from "lit"
 */

/**
 * What shows a companion. It is made once for each, when the companion comes near for the first time.
 *
 * @typedef {object} View
 * @property {() => unknown} content
 * @property {(event: Event) => void} [attended] the focus comes to the applet or leaves it
 * @property {(done: boolean) => void} [chosen] the user has chosen
 * @property {() => void} [stop] the companion leaves the page
 */

/** @typedef {{ new (host: any): View, styles: CSSResult[] }} ViewClass */

/**
 * The class of a view: a file of its own, fetched when a companion of this kind comes near.
 *
 * @template {string} N
 */
export class LazyView {
  #fetch;
  #name;
  /** The class, as soon as a companion needed it. @type {ViewClass | null} */
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
