// The parts of style sheets that the applet and the elements share. Custom properties that begin with --bz- may be set from outside.

/**
 * The colours of a light page: www/base.css has the same. On --bz-paper and --bz-raised, text has a contrast of 4.5 or more,
 * marks and the borders of controls have 3.
 */
export const LIGHT = `
  --bz-ink: #15202b; --bz-quiet: #51606e; --bz-paper: #f3f6fa; --bz-panel: #f3f6fa; --bz-raised: #ffffff; --bz-rim: #d9e1e8; --bz-field: #6f7d8a;
  --bz-curve: #0072b2; --bz-handle: #d55e00; --bz-first: #0072b2; --bz-second: #d55e00; --bz-level1: #008a64; --bz-level2: #b8558f;
  --bz-accent: #0067a3; --bz-on-accent: #ffffff; --bz-broken-ink: #a84a00; --bz-smooth-ink: #00714f;`;

/** Those of a dark page. */
export const DARK = `
  --bz-ink: #e8edf2; --bz-quiet: #a7b4c1; --bz-paper: #131a22; --bz-panel: #131a22; --bz-raised: #1c2530; --bz-rim: #2a3541; --bz-field: #7d8b99;
  --bz-curve: #56b4e9; --bz-handle: #e69f00; --bz-first: #56b4e9; --bz-second: #e69f00; --bz-level1: #2fc48f; --bz-level2: #d98ab8;
  --bz-accent: #7cc4f0; --bz-on-accent: #0c1117; --bz-broken-ink: #f0a95c; --bz-smooth-ink: #4fd1a5;`;

/** The letters of the interface. `system-ui` is wide and heavy on some systems. */
export const FONT_FAMILY = `"Segoe UI Variable", "Segoe UI", -apple-system, "SF Pro Text", Roboto, Ubuntu, Cantarell, "Noto Sans", "Helvetica Neue", Arial, sans-serif`;

/** A figure is one sheet: a picture and its controls on one colour, without lines between them. */
export const SHEET = `
.frame { border-radius: 16px; background: var(--bz-panel); overflow: clip; }
@media (forced-colors: active) { .frame { border: 1px solid var(--bz-rim); } }
`;

/**
 * What everything of ours has in common: colours by role, size of a hit box, letters.
 *
 * @cssprop --bz-ink - text and marks
 * @cssprop --bz-quiet - secondary text
 * @cssprop --bz-paper - the background of pictures
 * @cssprop --bz-panel - the background of everything else
 * @cssprop --bz-raised - the background of buttons and fields
 * @cssprop --bz-rim - lines between things of one kind
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
  font: 400 0.9375rem/1.45 ${FONT_FAMILY}; text-align: start;
}
@media screen and (prefers-color-scheme: dark) {
  :host {${DARK}
  }
}
@media (any-pointer: coarse) { :host { --bz-hit: 44px; } }
@media (forced-colors: active) {
  :host {
    --bz-ink: CanvasText; --bz-quiet: CanvasText; --bz-paper: Canvas; --bz-panel: Canvas; --bz-raised: Canvas; --bz-rim: CanvasText; --bz-field: CanvasText;
    --bz-curve: CanvasText; --bz-handle: LinkText; --bz-first: CanvasText; --bz-second: Highlight;
    --bz-level1: GrayText; --bz-level2: LinkText; --bz-accent: Highlight; --bz-on-accent: HighlightText;
  }
  .probe { forced-color-adjust: none; }
}
*, ::after { box-sizing: border-box; }
`;

/**
 * After TOKENS: more colours of an element, and its attribute `theme`.
 *
 * @param light those of a light page
 * @param dark those of a dark page
 */
export const themeColours = (light = "", dark = "") => `
:host { ${light} }
@media screen and (prefers-color-scheme: dark) { :host { ${dark} } }
@media screen and (forced-colors: none) {
  :host([theme="light"]) { color-scheme: light; ${LIGHT} ${light} }
  :host([theme="dark"]) { color-scheme: dark; ${DARK} ${dark} }
}
:host([hidden]) { display: none; }
`;

/** Buttons, labels, the ring of the focus, and what only screen readers find. */
export const CONTROLS = `
fieldset { border: 0; margin: 0; padding: 0; min-inline-size: 0; display: flex; flex-wrap: wrap; gap: 0.2rem 0.9rem; align-items: center; }
legend { float: left; padding: 0; margin-inline-end: 0.1rem; color: var(--bz-quiet); }
button {
  font: inherit; color: inherit; background: var(--bz-raised); border: 1px solid var(--bz-field); border-radius: 6px;
  padding: 0.32rem 0.7rem; min-block-size: 2.25rem; cursor: pointer;
}
button:hover { border-color: var(--bz-accent); color: var(--bz-accent); }
button:disabled { opacity: 0.55; cursor: default; }
label { display: inline-flex; gap: 0.4rem; align-items: center; min-block-size: 1.75rem; cursor: pointer; }
input[type="checkbox"], input[type="radio"] { inline-size: 1.05rem; block-size: 1.05rem; margin: 0; accent-color: var(--bz-accent); }
:focus-visible { outline: 2px solid var(--bz-accent); outline-offset: 2px; }
.away { position: absolute; inline-size: 1px; block-size: 1px; margin: -1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
`;
