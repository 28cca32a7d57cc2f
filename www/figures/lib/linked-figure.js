// The base of figures and controls that belong to another element of the page, which their attribute `for` names. They are drawn
// into the page itself, not into a shadow root.

export class LinkedFigure extends HTMLElement {
  /** The element that `for` names. @type {any} */
  target = null;
  #isBuilt = false;

  connectedCallback() {
    this.target = document.getElementById(this.getAttribute("for") ?? "");
    if (!this.#isBuilt) this.build();
    this.#isBuilt = true;
    this.target?.addEventListener("update", this);
    if (this.target)
      void customElements.whenDefined(this.target.localName).then(() => this.isConnected && this.follow());
  }

  disconnectedCallback() {
    this.target?.removeEventListener("update", this);
  }

  /** The target has changed. */
  handleEvent() {
    this.follow();
  }

  /** Makes the content, once. */
  build() {}

  /** Shows the target's state; called when the target is there, and after each of its changes. */
  follow() {}

  /**
   * Sets properties of the target as if the reader had done it in the figure itself.
   *
   * @param {Record<string, unknown>} properties
   * @param {"input" | "change"} type whether the reader is still moving something
   */
  setTarget(properties, type) {
    Object.assign(this.target, properties);
    this.target.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
  }
}
