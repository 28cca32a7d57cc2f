import { css, html } from "lit";
import { adoptProperties } from "../adopt.js";
import { AppletEditing } from "./editing.js";
import { FIELDS } from "../../editor/schema.js";
import { missing } from "../loading.js";
import { loadDrawing, loadRational } from "./loading.js";
import { weightsOf } from "../../editor/state.js";
import { reportOf } from "./report.js";

/** Root margin for lazy loading. */
const NEAR = "300px";

/** `<bezier-applet>`; what can be set from outside is documented in ../types.js. */
export class BezierApplet extends AppletEditing {
  /** Until the rest has come: as large as it will be, with what the page put into it. */
  static styles = css`
    :host { display: block; box-sizing: border-box; inline-size: 670px; max-inline-size: 100%; }
    :host([hidden]) { display: none; }
    .poster { aspect-ratio: 670 / 480; }
    .poster ::slotted(*) { inline-size: 100%; block-size: 100%; }
  `;
  #watch: IntersectionObserver | null = null;
  #view: import("./applet-view.js").AppletView | null = null;
  /** Whether it is near, or was since it came into the page. */
  #near = false;
  #announcedState: import("../../editor/state.js").State | null = null;

  /** What is shown, as companions read it. */
  get figure() {
    return reportOf(this.editor.state, this.currentFigure());
  }

  /** The picture with all its layers. */
  async toSVG(): Promise<string> {
    return (await this.#loaded()).toSVG();
  }

  /** The picture as a PNG; null before it has been near. */
  async toBlob(): Promise<Blob | null> {
    return (await this.#loaded()).toBlob();
  }

  /** A program that makes the same curve. */
  async toCode(language: import("../../editor/code.js").Language): Promise<string> {
    return (await this.#loaded()).toCode(language);
  }

  connectedCallback() {
    super.connectedCallback();
    adoptProperties(this, ["state", "points", "joints", ...Object.keys(FIELDS)]);
    this.#watch ??= new IntersectionObserver((entries) => this.#seen(entries[entries.length - 1].isIntersecting), {
      rootMargin: NEAR,
    });
    this.#watch.observe(this);
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#watch?.disconnect();
    this.#near = false;
    this.#view?.end();
    this.editor.commit();
  }

  async #seen(near: boolean) {
    if (!near || this.#near || !this.isConnected) return;
    this.#near = true;
    try {
      await this.#loaded();
      if (this.message === missing()) this.say("");
    } catch {
      this.#near = false;
      this.say(missing());
    }
    this.requestUpdate();
  }

  /** What shows the figure: also what curves with weights need, where there are any. */
  async #loaded() {
    const view = await this.#viewed();
    await this.#weighted();
    return view;
  }

  async #weighted() {
    if (this.rational || !weightsOf(this.editor.state)) return;
    const rational = await loadRational();
    this.rational ??= rational; // two have waited
    if (this.message === missing()) this.say("");
  }

  async #viewed() {
    if (this.#view) return this.#view;
    const { AppletView, style } = await loadDrawing();
    if (this.#view) return this.#view; // two have waited
    const self = this as { renderRoot: HTMLElement | DocumentFragment };
    self.renderRoot ??= this.createRenderRoot();
    const root = this.renderRoot as ShadowRoot;
    root.adoptedStyleSheets = [...root.adoptedStyleSheets, style.styleSheet as CSSStyleSheet];
    this.#view = new AppletView(this);
    this.requestUpdate();
    if (this.isConnected) await this.updateComplete; // updates begin when it is connected for the first time
    return this.#view;
  }

  updated() {
    if (this.#near && this.isConnected) this.#view?.start();
    if (!this.editor.isOpen) this.reflectState();
    if (this.#view && this.#near) this.#weighted().catch(() => this.say(missing()));
    if (this.#announcedState === this.editor.state) return;
    this.#announcedState = this.editor.state;
    this.#view?.speaker?.say();
    this.dispatchEvent(new Event("update"));
  }

  render() {
    return (
      this.#view?.template() ??
      html`<slot name="label"></slot><div class="poster"><slot name="poster"><slot></slot></slot></div>${this.message}<slot name="caption"></slot>`
    );
  }
}
