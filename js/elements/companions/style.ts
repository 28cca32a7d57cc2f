// What the style sheets of all companions have in common. Custom properties that begin with --bz- may be set from outside.
import { css, unsafeCSS } from "lit";
import { CONTROLS, SHEET, themeColours, TOKENS } from "../../ui/tokens.js";

export const style = css`
${unsafeCSS(TOKENS)}
${unsafeCSS(themeColours())}
${unsafeCSS(CONTROLS)}
:host { container-type: inline-size; }
${unsafeCSS(SHEET)}
.message { margin: 0; padding: 0.4rem 0.2rem 0; color: var(--bz-broken, var(--bz-broken-ink)); font-size: 0.875rem; overflow-wrap: anywhere; }
.message:empty { display: none; }
.bar { display: flex; flex-wrap: wrap; gap: 0.4rem 1rem; align-items: center; padding: 0.5rem 0.8rem; }
.t { display: flex; font-weight: 600; } .t input { flex: 1; min-inline-size: 4rem; } .t .value { font-weight: 400; min-inline-size: 2.6em; }
.quiet { color: var(--bz-quiet); font-size: 0.875rem; }
.value { font-variant-numeric: tabular-nums; }
p { margin: 0; }
i { font-family: ui-serif, Georgia, serif; font-size: 1.1em; }
input, select { font: inherit; color: inherit; }
select:disabled, input:disabled { opacity: 0.6; }
select, input[type="number"] { background: var(--bz-raised); border: 1px solid var(--bz-field); border-radius: 6px; padding: 0.2rem 0.45rem; min-block-size: 2rem; }
input[type="number"] { font-variant-numeric: tabular-nums; }
input[type="range"] { accent-color: var(--bz-accent); min-block-size: 24px; margin: 0; }
input[aria-invalid="true"] { border-color: var(--bz-broken, var(--bz-broken-ink)); box-shadow: 0 0 0 1px var(--bz-broken, var(--bz-broken-ink)); }
.error { color: var(--bz-broken, var(--bz-broken-ink)); font-size: 0.8125rem; }
.scroll { overflow: auto; }
.scroll:focus-visible { outline-offset: -3px; }
@media print { :host { break-inside: avoid; } button, input[type="range"] { display: none; } }
`;
