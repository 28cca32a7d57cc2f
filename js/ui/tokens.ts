// The parts of style sheets that the applet and the elements share. Custom properties that begin with --bz- may be set from outside.

/** The colours of a light page. */
export const LIGHT = `
  --bz-ink: #1d2733; --bz-quiet: #51606f; --bz-paper: #ffffff; --bz-panel: #f4f6f8; --bz-rim: #c9d1d9; --bz-field: #7a8794;
  --bz-curve: #0072b2; --bz-handle: #d55e00; --bz-first: #0072b2; --bz-second: #d55e00; --bz-level1: #009e73; --bz-level2: #cc79a7;
  --bz-accent: #0067a3; --bz-on-accent: #ffffff; --bz-broken-ink: #b34700; --bz-smooth-ink: #00704f;`;

/** Those that differ on a dark page. */
export const DARK = `
  --bz-ink: #e8edf2; --bz-quiet: #a9b5c1; --bz-paper: #12171d; --bz-panel: #1b222a; --bz-rim: #36414c; --bz-field: #7d8b99;
  --bz-curve: #56b4e9; --bz-handle: #e69f00; --bz-first: #56b4e9; --bz-second: #e69f00;
  --bz-accent: #7cc4f0; --bz-on-accent: #0d141a; --bz-broken-ink: #f0b13c; --bz-smooth-ink: #3ecf9f;`;

/**
 * What everything of ours has in common: colours by role, size of a hit box, letters.
 *
 * @cssprop --bz-ink - text and marks
 * @cssprop --bz-quiet - secondary text
 * @cssprop --bz-paper - the background of pictures and fields
 * @cssprop --bz-panel - the background of everything else
 * @cssprop --bz-rim - the borders of panels
 * @cssprop --bz-field - the borders of buttons and fields
 * @cssprop --bz-curve - the curve
 * @cssprop --bz-handle - points off the curve, and tangents
 * @cssprop --bz-first - the first part of a curve that is split
 * @cssprop --bz-second - the second part
 * @cssprop --bz-level1 - the first level of de Casteljau's algorithm, and every fourth after it
 * @cssprop --bz-level2 - the second level
 * @cssprop --bz-accent - the focus and selected items
 * @cssprop --bz-on-accent - text on the accent colour
 * @cssprop --bz-broken - messages about continuity that does not hold
 * @cssprop --bz-smooth - messages about continuity that holds
 * @cssprop --bz-hit - the size of the hit area of a handle
 */
export const TOKENS = `
:host {${LIGHT}
  --bz-hit: 24px;
  display: block; box-sizing: border-box; max-inline-size: 100%;
  color-scheme: light dark; color: var(--bz-ink);
  font: 400 0.9375rem/1.45 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif; text-align: start;
}
@media screen and (prefers-color-scheme: dark) {
  :host {${DARK}
  }
}
@media (any-pointer: coarse) { :host { --bz-hit: 44px; } }
@media (forced-colors: active) {
  :host {
    --bz-ink: CanvasText; --bz-quiet: CanvasText; --bz-paper: Canvas; --bz-panel: Canvas; --bz-rim: CanvasText; --bz-field: CanvasText;
    --bz-curve: CanvasText; --bz-handle: LinkText; --bz-first: CanvasText; --bz-second: Highlight;
    --bz-level1: GrayText; --bz-level2: LinkText; --bz-accent: Highlight; --bz-on-accent: HighlightText;
  }
  .probe { forced-color-adjust: none; }
}
*, ::after { box-sizing: border-box; }
`;

/** Buttons, labels, the ring of the focus, and what only screen readers find. */
export const CONTROLS = `
fieldset { border: 0; margin: 0; padding: 0; min-inline-size: 0; display: flex; flex-wrap: wrap; gap: 0.2rem 0.9rem; align-items: center; }
legend { float: left; padding: 0; margin-inline-end: 0.1rem; font-weight: 600; }
button {
  font: inherit; color: inherit; background: var(--bz-paper); border: 1px solid var(--bz-field); border-radius: 7px;
  padding: 0.32rem 0.7rem; min-block-size: 2.25rem; cursor: pointer;
}
button:hover { border-color: var(--bz-accent); color: var(--bz-accent); }
button:disabled { opacity: 0.55; cursor: default; }
label { display: inline-flex; gap: 0.4rem; align-items: center; min-block-size: 1.75rem; cursor: pointer; }
input[type="checkbox"], input[type="radio"] { inline-size: 1.05rem; block-size: 1.05rem; margin: 0; accent-color: var(--bz-accent); }
:focus-visible { outline: 2px solid var(--bz-accent); outline-offset: 2px; }
.away { position: absolute; inline-size: 1px; block-size: 1px; margin: -1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
`;
