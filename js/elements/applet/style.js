// The style sheet inside the shadow root: the small applet's, and what this one has more.
import { css, unsafeCSS } from "lit";
import { CSS, DARK, LIGHT } from "../../applet/style.js";
import { LEVELS } from "./layers/theme.js";

const [LIGHT_LEVELS, DARK_LEVELS] = [unsafeCSS(LEVELS.light), unsafeCSS(LEVELS.dark)];

export const style = css`
${unsafeCSS(CSS)}
:host { ${LIGHT_LEVELS} container-type: inline-size; inline-size: 670px; }
@media (prefers-color-scheme: dark) { :host { ${DARK_LEVELS} } }
@media (forced-colors: active) { :host { --bz-level3: CanvasText; --bz-level4: Highlight; } }
@media not (forced-colors: active) {
  :host([theme="light"]) { color-scheme: light; ${unsafeCSS(LIGHT)} ${LIGHT_LEVELS} }
  :host([theme="dark"]) { color-scheme: dark; ${unsafeCSS(DARK)} ${DARK_LEVELS} }
}
:host([hidden]), [hidden] { display: none; }
.stage { aspect-ratio: 670 / 480; touch-action: pan-y; overflow: clip; }
canvas { display: block; inline-size: 100%; block-size: 100%; }
.overlay { overflow: clip; }
.poster, .poster ::slotted(*) { inline-size: 100%; block-size: 100%; }
.message { margin: 0; padding: 0.45rem 0.9rem; border-block-start: 1px solid var(--bz-rim); color: var(--bz-broken, var(--bz-broken-ink)); }
.joints { list-style: none; margin: 0; padding: 0.4rem 0.9rem; border-block-start: 1px solid var(--bz-rim); max-block-size: 11rem; overflow: auto; }
.joints li { display: flex; flex-wrap: wrap; gap: 0.2rem 0.7rem; align-items: center; min-block-size: 2.4rem; }
.fact { font-variant-numeric: tabular-nums; color: var(--bz-quiet); }
.controls { border-block-start: 1px solid var(--bz-rim); }
.tools { position: absolute; inset: 8px 8px auto auto; display: flex; gap: 4px; }
.tools button, .icon { inline-size: 34px; min-block-size: 34px; padding: 0; display: grid; place-items: center; }
.tools svg { inline-size: 18px; block-size: 18px; fill: none; stroke: currentColor; stroke-width: 2; stroke-linecap: round; stroke-linejoin: round; }
.t { display: flex; flex-wrap: wrap; gap: 0.5rem 1rem; align-items: center; flex: 1 1 100%; font-weight: 400; }
.t .line:has(input) { flex: 1 1 12rem; }
.t .line input { flex: 1; }
.layers { display: grid; grid-template-columns: repeat(auto-fill, minmax(10rem, 1fr)); gap: 0.1rem 0.9rem; }
select {
  font: inherit; color: inherit; background: var(--bz-paper); border: 1px solid var(--bz-field); border-radius: 7px; padding: 0.25rem 0.5rem; min-block-size: 2.1rem;
}
`;
