// The style sheet inside the shadow root: the small applet's, and what this one has more.
import { css, unsafeCSS } from "lit";
import { CSS } from "../../applet/style.js";
import { themeColours } from "../../ui/tokens.js";
import { LEVELS } from "../../layers/theme.js";

export const style = css`
${unsafeCSS(CSS)}
${unsafeCSS(themeColours(LEVELS.light, LEVELS.dark))}
:host { container-type: inline-size; inline-size: 670px; }
@media (forced-colors: active) { :host { --bz-level3: CanvasText; --bz-level4: Highlight; } }
[hidden] { display: none; }
.stage { aspect-ratio: 670 / 480; touch-action: pan-y; overflow: clip; }
.frame:not(:has(.controls)) .stage { border-radius: 16px; }
canvas { display: block; inline-size: 100%; block-size: 100%; }
.overlay { overflow: clip; }
.overlay.grab { cursor: move; }
.overlay.place { cursor: crosshair; }
:host([readonly]) .handle { cursor: default; touch-action: auto; }
.message { margin: 0; padding: 0.45rem 0.9rem; color: var(--bz-broken, var(--bz-broken-ink)); overflow-wrap: anywhere; }
.message.good { color: inherit; }
.tools { display: flex; gap: 4px; margin-inline-start: auto; }
.icon { inline-size: 2.1rem; min-block-size: 2.1rem; padding: 0; display: grid; place-items: center; flex: none; }
.icon svg { inline-size: 18px; block-size: 18px; fill: none; stroke: currentColor; stroke-width: 2; stroke-linecap: round; stroke-linejoin: round; }
.icon svg .solid { fill: currentColor; }

.joints { list-style: none; margin: 0; padding: 0.35rem 0.9rem; max-block-size: 10.2rem; overflow: auto; }
.joints li { display: flex; flex-wrap: wrap; gap: 0.15rem 0.7rem; align-items: center; padding-block: 0.2rem; }
.joints .verdict { min-inline-size: 3.2em; }
.joints .fact { color: var(--bz-quiet); font-variant-numeric: tabular-nums; }
.controls { display: grid; gap: 0.8rem; }
.controls > * { min-inline-size: 0; }
.controls:not(:has(> *)) { display: none; }
.t { display: flex; flex-wrap: wrap; gap: 0.4rem 0.8rem; align-items: center; font-weight: 400; }
.line > span:first-child { white-space: nowrap; }
.line:has([type="range"]) { flex: 1 1 9rem; min-inline-size: 0; }
.line [type="range"] { flex: 1; min-inline-size: 5rem; min-block-size: 24px; accent-color: var(--bz-accent); }
.line .value { min-inline-size: 2.6em; text-align: end; font-variant-numeric: tabular-nums; }
legend { float: none; margin-block-end: 0.3rem; }
fieldset { gap: 0.4rem 1.1rem; }
.layers { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 9.4rem), 1fr)); gap: 0 0.9rem; inline-size: 100%; }
.measure { display: grid; gap: 0 1.4rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 15rem), 1fr)); inline-size: 100%; }
.messages { flex: 1 1 100%; margin: 0; padding: 0; list-style: none; color: var(--bz-quiet); font-size: 0.875rem; font-variant-numeric: tabular-nums; }
.matrix { display: grid; grid-template-columns: repeat(4, minmax(3.2rem, 5rem)); gap: 4px; }
input[type="checkbox"] { flex: none; }
details { margin-inline: -0.9rem; padding-inline: 0.9rem; }
summary { font-weight: 600; cursor: pointer; padding-block: 0.25rem; }
details[open] > summary { margin-block-end: 0.4rem; }
.body { display: grid; gap: 0.6rem; }
pre { margin: 0; padding: 0.6rem 0.7rem; max-block-size: 15rem; overflow: auto; background: var(--bz-raised); border: 1px solid var(--bz-rim); border-radius: 10px; font: 0.8125rem/1.5 ui-monospace, "SF Mono", Menlo, Consolas, monospace; }
select, .number, .file {
  font: inherit; color: inherit; background: var(--bz-raised); border: 1px solid var(--bz-field); border-radius: 6px; padding: 0.2rem 0.5rem; min-block-size: 2.1rem; min-inline-size: 0; max-inline-size: 100%;
}
button { padding: 0.22rem 0.65rem; min-block-size: 2.1rem; }
button[aria-pressed="true"] { background: var(--bz-accent); border-color: var(--bz-accent); color: var(--bz-on-accent); }
.number { inline-size: 100%; }
.file { position: relative; padding-inline: 0.65rem; }
.file input { position: absolute; inset: 0; inline-size: 100%; opacity: 0; cursor: pointer; }
.file:focus-within { outline: 2px solid var(--bz-accent); outline-offset: 2px; }
.note { margin: 0; color: var(--bz-quiet); font-size: 0.875rem; }
dialog { max-inline-size: min(34rem, calc(100% - 2rem)); padding: 1rem 1.2rem; color: var(--bz-ink); background: var(--bz-raised); border: 1px solid var(--bz-rim); border-radius: 16px; }
dialog h2 { margin: 0 0 0.6rem; font-size: 1.1rem; }
dialog dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.3rem 1rem; margin: 0 0 0.9rem; }
dialog dt, dialog dd { margin: 0; }
@container (max-width: 420px) {
  .controls, .joints, .message { padding-inline: 0.65rem; }
  details { margin-inline: -0.65rem; padding-inline: 0.65rem; }
  fieldset > .line { flex: 1 1 100%; }
  fieldset > .line > span:first-child { min-inline-size: 4rem; }
  fieldset > .line > select { flex: 1; }
}
@media print { .tools, .controls, .joints select { display: none; } .frame { break-inside: avoid; } }
`;
