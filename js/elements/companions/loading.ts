import { once } from "../loading.js";
import type { CSSResult } from "lit";

/** What shows a companion. Each companion creates its own when it is about to become visible for the first time. */
export interface View {
  content: () => unknown;
  /** The applet gets or loses the focus */
  handleFocus?: (event: Event) => void;
  /** The user has changed the value */
  onChange?: (done: boolean) => void;
  /** The companion leaves the page */
  stop?: () => void;
}

export type ViewClass = { new (host: any): View; styles: CSSResult[] };

/**
 * The class of a view, which is in a file of its own: fetched when a companion of this kind is about to become visible.
 */
export class LazyView<N extends string> {
  #fetch;
  #name;
  /** The class, once it was fetched. */
  loaded: ViewClass | null = null;

  constructor(fetch: () => Promise<Record<N, unknown>>, name: N) {
    this.#fetch = once(fetch, name);
    this.#name = name;
  }

  async load(): Promise<ViewClass> {
    this.loaded = (await this.#fetch())[this.#name] as ViewClass;
    return this.loaded;
  }
}
