// The style sheet inside the shadow root. Custom properties that begin with --bz- may be set from outside.
import { css, unsafeCSS } from "lit";
import { SHEET, themeColours, TOKENS } from "../../ui/tokens.js";

const light = `
  --bz-front: #b2daf7; --bz-back: #e0a070; --bz-line: #1d3a52; --bz-level1: #00805d; --bz-level2: #b3478a;
  --bz-low: #0072b2; --bz-middle: #f2f2ee; --bz-high: #d55e00; --bz-gap: #ff00c8; --bz-wire: #f0b060;
`;
const dark = `
  --bz-front: #6fb0dc; --bz-back: #b8773f; --bz-line: #d8ebf9; --bz-level1: #2fc48f; --bz-level2: #cc79a7;
  --bz-low: #3d9be0; --bz-middle: #d9dad6; --bz-high: #e8862e; --bz-gap: #ff4fd8; --bz-wire: #f0b060;
`;

/**
 * @cssprop --bz-ink - text
 * @cssprop --bz-quiet - secondary text
 * @cssprop --bz-paper - the background of the picture
 * @cssprop --bz-panel - the background of everything else
 * @cssprop --bz-raised - the background of buttons and fields
 * @cssprop --bz-rim - lines between things of one kind
 * @cssprop --bz-field - the borders of buttons and fields
 * @cssprop --bz-front - the front side of the surface
 * @cssprop --bz-back - its back side
 * @cssprop --bz-line - mesh, curves and net
 * @cssprop --bz-handle - control points
 * @cssprop --bz-level1 - the rows of de Casteljau's grid
 * @cssprop --bz-level2 - the curve across them
 * @cssprop --bz-low - the smallest curvature
 * @cssprop --bz-middle - zero curvature
 * @cssprop --bz-high - the greatest curvature
 * @cssprop --bz-gap - cracks
 * @cssprop --bz-wire - tubes
 * @cssprop --bz-accent - the focus and selected items
 * @cssprop --bz-on-accent - text on the accent colour
 * @cssprop --bz-hit - the size of the hit area of a handle
 * @cssprop --bz-aspect - the aspect ratio of the picture, width / height
 */
export const style = css`
${unsafeCSS(TOKENS)}
${unsafeCSS(themeColours(light, dark))}
:host { container-type: inline-size; }
::before { box-sizing: border-box; }
@media (forced-colors: active) { :host { --bz-level1: GrayText; --bz-level2: LinkText; } }
${unsafeCSS(SHEET)}
.stage { position: relative; background: var(--bz-paper); }
canvas { display: block; inline-size: 100%; aspect-ratio: var(--bz-aspect, 4 / 3); cursor: grab; touch-action: pan-y; -webkit-tap-highlight-color: transparent; }
@container (max-width: 420px) { canvas { aspect-ratio: var(--bz-aspect, 1); } }
canvas:active { cursor: grabbing; }
.stage:has(> .poster) canvas:not(:focus-visible) { opacity: 0; } /* once its context is lost it is white, which shows at round corners */
canvas:focus-visible { outline-offset: -3px; }
.poster { position: absolute; inset: 0; overflow: clip; pointer-events: none; }
.poster ::slotted(*) { inline-size: 100%; block-size: 100%; object-fit: contain; }
.overlay { position: absolute; inset: 0; overflow: clip; pointer-events: none; user-select: none; -webkit-user-select: none; }
.names { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; overflow: hidden; }
.names text { fill: var(--bz-ink); font-size: 14px; font-style: italic; paint-order: stroke; stroke: var(--bz-paper); stroke-width: 3.5px; stroke-linejoin: round; }
.names .index { font-size: 0.72em; font-style: normal; }
.names :is(.axis, .u, .v, .normal) { font-size: 16px; font-weight: 600; }
.names path { fill: none; stroke: var(--bz-ink); stroke-width: 1.75; stroke-linecap: round; }
.handle {
  position: absolute; inset: 0 auto auto 0; inline-size: var(--bz-hit); block-size: var(--bz-hit); min-block-size: 0; margin: calc(var(--bz-hit) / -2) 0 0 calc(var(--bz-hit) / -2);
  padding: 0; border: 0; border-radius: 50%; background: none; pointer-events: auto; touch-action: none; cursor: grab;
}
.handle[hidden] { display: none; }
.handle:active { cursor: grabbing; }
.handle::before {
  content: ""; position: absolute; inset: 0; margin: auto; inline-size: 12px; block-size: 12px;
  background: var(--bz-handle); border: 2px solid var(--bz-paper); border-radius: 50%;
}
.handle[data-kind="off"]::before { border-radius: 2px; inline-size: 11px; block-size: 11px; }
.handle:hover::before, .handle:focus-visible::before { scale: 1.35; }
.handle:focus-visible { outline: 2px solid var(--bz-accent); outline-offset: -1px; z-index: 1; }
.tools { position: absolute; inset: 8px 8px auto auto; display: flex; gap: 4px; }
.tools button { inline-size: 34px; min-block-size: 34px; padding: 0; display: grid; place-items: center; }
.tools svg { inline-size: 18px; block-size: 18px; fill: none; stroke: currentColor; stroke-width: 2; stroke-linecap: round; stroke-linejoin: round; }
.message { position: absolute; inset: auto 10px 10px; margin: 0; padding: 0.45rem 0.7rem; background: var(--bz-raised); border: 1px solid var(--bz-field); border-radius: 6px; font-size: 0.875rem; }
.message:empty { display: none; }
.facts { display: flex; flex-wrap: wrap; gap: 0.1rem 1.3rem; margin: 0; padding: 0.5rem 0.9rem; color: var(--bz-quiet); font-size: 0.875rem; font-variant-numeric: tabular-nums; }
.facts b { font-weight: 600; color: var(--bz-ink); }
.controls { display: grid; gap: 0.8rem 1.6rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 17rem), 1fr)); padding: 0.6rem 0.9rem 0.9rem; }
.more { flex: 1 1 100%; grid-column: 1 / -1; }
.more > summary { font-weight: 600; cursor: pointer; padding-block: 0.25rem; }
.more > .body { display: grid; gap: 0.8rem 1.6rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 17rem), 1fr)); padding-block-start: 0.5rem; }
fieldset { border: 0; margin: 0; padding: 0; min-inline-size: 0; display: flex; flex-wrap: wrap; gap: 0.35rem 0.95rem; align-items: center; align-content: start; }
fieldset.wide { grid-column: 1 / -1; }
legend { padding: 0 0 0.15rem; color: var(--bz-quiet); }
label { display: inline-flex; gap: 0.4rem; align-items: center; min-block-size: 1.75rem; cursor: pointer; }
label.line { flex: 1 1 100%; }
.main label.line { flex: 1 1 14rem; }
label.line > span:first-child { min-inline-size: 5.2rem; }
label.line > select, label.line > input { flex: 1; min-inline-size: 5rem; inline-size: 0; }
.value { min-inline-size: 3.1em; text-align: end; font-variant-numeric: tabular-nums; }
input[type="checkbox"], input[type="radio"] { inline-size: 1.05rem; block-size: 1.05rem; margin: 0; accent-color: var(--bz-accent); }
input[type="range"] { accent-color: var(--bz-accent); min-block-size: 24px; }
button, select {
  font: inherit; color: inherit; background: var(--bz-raised); border: 1px solid var(--bz-field); border-radius: 6px; padding: 0.25rem 0.6rem; min-block-size: 2.1rem; cursor: pointer;
}
.file { position: relative; background: var(--bz-raised); border: 1px solid var(--bz-field); border-radius: 6px; padding: 0.25rem 0.6rem; min-block-size: 2.1rem; }
.file input { position: absolute; inset: 0; inline-size: 100%; opacity: 0; cursor: pointer; }
.file:focus-within { outline: 2px solid var(--bz-accent); outline-offset: 2px; }
.file:hover, button:not(.handle):hover { border-color: var(--bz-accent); color: var(--bz-accent); }
button:disabled { opacity: 0.55; cursor: default; }
button[aria-pressed="true"] { background: var(--bz-accent); border-color: var(--bz-accent); color: var(--bz-on-accent); }
button[aria-pressed="true"]:hover { color: var(--bz-on-accent); }
:focus-visible { outline: 2px solid var(--bz-accent); outline-offset: 2px; }
.note { flex: 1 1 100%; margin: 0; color: var(--bz-quiet); font-size: 0.875rem; }
.row { display: flex; flex-wrap: wrap; gap: 0.4rem; }
.away { position: absolute; inline-size: 1px; block-size: 1px; margin: -1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
@media print { .tools, .message { display: none; } }
`;
