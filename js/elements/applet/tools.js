import { html } from "lit";

/**
 * The buttons on the picture.
 *
 * @param {Pick<import("./panel.js").PanelPort, "zoom" | "home" | "state">} port
 */
export function tools({ zoom, home, state }) {
  const enlarged = Math.round(state.box.width / state.view.width);
  return html`<div class="tools" role="group" aria-label="Zoom">
    <button type="button" aria-label="Closer" title="Closer (Ctrl + wheel, or two fingers)" @click=${() => zoom(2)}>${icon("M12 5v14M5 12h14")}</button>
    <button type="button" aria-label="Farther" title="Farther" @click=${() => zoom(1 / 2)}>${icon("M5 12h14")}</button>
    <button type="button" aria-label="Whole picture" title=${`Whole picture (now ${enlarged < 1 ? "smaller" : `${enlarged} ×`})`} @click=${home}>${icon("M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5")}</button>
  </div>`;
}

/** @param {string} d */
const icon = (d) => html`<svg viewBox="0 0 24 24" aria-hidden="true"><path d=${d}></path></svg>`;
