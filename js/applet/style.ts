// The style sheet inside the shadow root. Custom properties that begin with --bz- may be set from outside.

import { CONTROLS, SHEET, TOKENS } from "../ui/tokens.js";

/** Everything inside the small applet. */
export const CSS = `${TOKENS}${CONTROLS}${SHEET}.frame { overflow: visible; } /* handles at the edge of the picture can be taken from outside */
.stage { position: relative; background: var(--bz-paper); border-radius: 16px 16px 0 0; touch-action: pan-y pinch-zoom; -webkit-tap-highlight-color: transparent; }
::slotted(canvas) {
  display: block !important; margin: 0 !important; padding: 0 !important; inline-size: 100%; max-inline-size: 100%;
  block-size: auto !important; aspect-ratio: var(--bz-box) !important;
}
.overlay { position: absolute; user-select: none; -webkit-user-select: none; }
.handle {
  position: absolute; inline-size: var(--bz-hit); block-size: var(--bz-hit); margin: calc(var(--bz-hit) / -2) 0 0 calc(var(--bz-hit) / -2);
  touch-action: none; cursor: grab;
}
.handle:active { cursor: grabbing; }
.handle::after {
  content: ""; display: none; position: absolute; inset: 0; margin: auto; inline-size: 22px; block-size: 22px;
  border: 2px solid var(--bz-field); border-radius: 50%; pointer-events: none;
}
.handle[data-kind="off"]::after { border-radius: 6px; }
.handle:hover::after, .handle:focus-within::after { display: block; }
.handle:focus-within { z-index: 1; }
.handle:focus-within::after { border-color: var(--bz-accent); }
.handle:has(:focus-visible)::after { border-width: 3px; outline: 2px solid var(--bz-paper); }
.handle input { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; margin: 0; opacity: 0; pointer-events: none; }
.status { display: flex; gap: 0.6rem; align-items: baseline; margin: 0; padding: 0.6rem 0.9rem 0; min-block-size: 4.1em; }
.verdict { flex: none; min-inline-size: 2.6em; padding: 0 0.45em; border-radius: 5px; text-align: center; font-weight: 650; border: 1.5px solid currentColor; }
.verdict { color: var(--bz-smooth, var(--bz-smooth-ink)); }
.verdict[data-verdict="C0"], .verdict[data-verdict="open"] { color: var(--bz-broken, var(--bz-broken-ink)); }
.verdict:empty { display: none; }
.controls { display: flex; flex-wrap: wrap; gap: 0.75rem 1.4rem; align-items: center; padding: 0.8rem 0.9rem; }
.row { display: flex; flex-wrap: wrap; gap: 0.5rem; align-items: center; }
kbd {
  font: 600 0.8em/1 ui-monospace, "SF Mono", Menlo, Consolas, monospace; color: var(--bz-quiet); border: 1px solid var(--bz-rim);
  border-block-end-width: 2px; border-radius: 4px; padding: 0.1em 0.4em; margin-inline-start: 0.25em;
}
.t { font-weight: 600; flex: 1 1 15rem; }
.t input { flex: 1; min-inline-size: 6rem; accent-color: var(--bz-accent); }
.t .value { min-inline-size: 2.4em; font-weight: 400; font-variant-numeric: tabular-nums; }
.t i { font-family: ui-serif, Georgia, serif; font-size: 1.1em; }
.handle :focus-visible { outline: none; }
@media (hover: none) and (pointer: coarse) { kbd, .keys, [aria-keyshortcuts="?"] { display: none; } }
.hint { flex: 1 1 100%; display: flex; flex-wrap: wrap; gap: 0.2rem 1.4rem; margin: 0; align-items: center; color: var(--bz-quiet); font-size: 0.875rem; }
`;

/** One sheet for each document. */
const sheets: WeakMap<Document, CSSStyleSheet> = new WeakMap();

/** Gives a shadow root its styles. */
export function adoptStyle(root: ShadowRoot) {
  const page = root.ownerDocument;
  const known = sheets.get(page) ?? makeSheet(page);
  root.adoptedStyleSheets = [known];
}

function makeSheet(page: Document): CSSStyleSheet {
  const sheet = new (page.defaultView ?? globalThis).CSSStyleSheet();
  sheet.replaceSync(CSS);
  sheets.set(page, sheet);
  return sheet;
}
