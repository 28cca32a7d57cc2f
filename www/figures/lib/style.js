// What all figures of the chapters look like. The colours are those of the elements, see js/ui/tokens.ts.
import { css, unsafeCSS } from "lit";
import { DARK, FONT_FAMILY, LIGHT } from "#js/ui/tokens.js";

export const style = css`
  :host {
    ${unsafeCSS(LIGHT)}
    --ink: var(--bz-ink); --quiet: var(--bz-quiet); --paper: var(--bz-paper); --panel: var(--bz-panel); --raised: var(--bz-raised); --rim: var(--bz-rim); --field: var(--bz-field); --grid: var(--bz-rim);
    --curve: var(--bz-curve); --handle: var(--bz-handle); --level1: var(--bz-level1); --level2: var(--bz-level2); --accent: var(--bz-accent); --on-accent: var(--bz-on-accent); --hit: 24px;
    --first-ink: #0067a3; --second-ink: #a84a00; --third-ink: #00704f; --fourth-ink: #9c3f75;
    display: block; box-sizing: border-box; max-inline-size: 100%; margin-block: 1rem 1.4rem;
    color-scheme: light dark; color: var(--ink);
    font: 400 0.9375rem/1.45 ${unsafeCSS(FONT_FAMILY)}; text-align: start;
  }
  :host([hidden]) { display: none; }
  @media (prefers-color-scheme: dark) {
    :host {
      ${unsafeCSS(DARK)}
      --first-ink: #7cc4f0; --second-ink: #f0b13c; --third-ink: #3ecf9f; --fourth-ink: #e3a0c4;
    }
  }
  @media (any-pointer: coarse) { :host { --hit: 44px; } }
  @media (forced-colors: active) {
    :host {
      --ink: CanvasText; --quiet: CanvasText; --paper: Canvas; --panel: Canvas; --raised: Canvas; --rim: CanvasText; --field: CanvasText; --grid: GrayText;
      --curve: CanvasText; --handle: LinkText; --level1: Highlight; --level2: LinkText; --accent: Highlight; --on-accent: HighlightText;
      --first-ink: CanvasText; --second-ink: LinkText; --third-ink: CanvasText; --fourth-ink: LinkText;
    }
  }
  *, ::before, ::after { box-sizing: border-box; }
  a { color: var(--accent); text-underline-offset: 0.2em; }
  .frame { border-radius: 16px; background: var(--panel); overflow: clip; break-inside: avoid; }
  @media (forced-colors: active) { .frame { border: 1px solid var(--rim); } }
  .stage { position: relative; background: var(--paper); touch-action: pan-y pinch-zoom; -webkit-tap-highlight-color: transparent; user-select: none; -webkit-user-select: none; }
  .stage + .stage { border-block-start: 1px solid var(--rim); }
  .sides .stage { border: 0; }
  .sides { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 17.5rem), 1fr)); gap: 1px; background: var(--rim); }
  svg { display: block; inline-size: 100%; block-size: auto; overflow: hidden; font-family: inherit; }
  svg text { fill: var(--ink); font-size: 13px; font-variant-numeric: tabular-nums; }
  svg .quiet { fill: var(--quiet); }
  svg .strong { font-weight: 650; }
  svg .middle { text-anchor: middle; }
  svg .end { text-anchor: end; }
  svg .haloed { paint-order: stroke; stroke: var(--paper); stroke-width: 4px; stroke-linejoin: round; }
  .curve { fill: none; stroke: var(--curve); stroke-width: 3; stroke-linecap: round; stroke-linejoin: round; }
  .polygon { fill: none; stroke: var(--ink); stroke-opacity: 0.6; stroke-width: 1; }
  .ghost { fill: none; stroke: var(--quiet); stroke-width: 2; stroke-dasharray: 6 5; }
  .gridline { fill: none; stroke: var(--grid); stroke-width: 1; }
  .axis { fill: none; stroke: var(--quiet); stroke-width: 1; }
  .level1 { fill: none; stroke: var(--level1); stroke-width: 1.5; }
  .level2 { fill: none; stroke: var(--level2); stroke-width: 1.5; }
  .on { fill: var(--curve); stroke: var(--paper); stroke-width: 1.5; }
  .off { fill: var(--handle); stroke: var(--paper); stroke-width: 1.5; }
  .at { fill: var(--ink); stroke: var(--paper); stroke-width: 1.5; }
  .hollow { fill: var(--paper); stroke-width: 1.5; }
  .facts { margin: 0; padding: 0.6rem 0.9rem; font-variant-numeric: tabular-nums; text-wrap: pretty; }
  .facts + .facts { padding-block-start: 0; }
  .controls { display: flex; flex-wrap: wrap; gap: 0.6rem 1.4rem; align-items: center; padding: 0.75rem 0.9rem; }
  .row { display: flex; flex-wrap: wrap; gap: 0.4rem; align-items: center; }
  fieldset { border: 0; margin: 0; padding: 0; min-inline-size: 0; display: flex; flex-wrap: wrap; gap: 0.2rem 0.9rem; align-items: center; }
  legend { float: left; padding: 0; margin-inline-end: 0.1rem; color: var(--quiet); }
  button {
    font: inherit; color: inherit; background: var(--raised); border: 1px solid var(--field); border-radius: 6px; padding: 0.32rem 0.7rem;
    min-block-size: 2.25rem; cursor: pointer;
  }
  button:hover { border-color: var(--accent); color: var(--accent); }
  button:disabled { opacity: 0.55; cursor: default; }
  button[aria-pressed="true"] { border-color: var(--accent); outline: 1px solid var(--accent); outline-offset: -2px; }
  button[aria-pressed="true"]:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
  .play { flex: none; inline-size: 2.75rem; padding: 0; }
  .play svg { inline-size: 1rem; margin: auto; fill: currentColor; }
  label { display: inline-flex; gap: 0.45rem; align-items: center; min-block-size: 1.75rem; max-inline-size: 100%; cursor: pointer; }
  select { min-inline-size: 0; }
  input[type="checkbox"], input[type="radio"] { inline-size: 1.05rem; block-size: 1.05rem; margin: 0; accent-color: var(--accent); }
  select, input[type="number"], input[type="text"] {
    font: inherit; color: inherit; background: var(--raised); border: 1px solid var(--field); border-radius: 6px; padding: 0.25rem 0.5rem; min-block-size: 2.1rem; max-inline-size: 100%;
  }
  .slider { flex: 1 1 16rem; font-weight: 600; min-inline-size: 0; }
  .slider input { flex: 1; min-inline-size: 5rem; min-block-size: 24px; accent-color: var(--accent); }
  .value { min-inline-size: 2.6em; font-weight: 400; font-variant-numeric: tabular-nums; }
  i, .math { font-family: ui-serif, Georgia, "Times New Roman", serif; font-style: italic; }
  math { font-size: 1.08em; }
  :focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
  .handle {
    position: absolute; inline-size: var(--hit); block-size: var(--hit); margin: calc(var(--hit) / -2) 0 0 calc(var(--hit) / -2);
    touch-action: none; cursor: grab; z-index: 1;
  }
  .handle:active { cursor: grabbing; }
  .handle::after {
    content: ""; display: none; position: absolute; inset: 0; margin: auto; inline-size: 22px; block-size: 22px;
    border: 2px solid var(--field); border-radius: 50%; pointer-events: none;
  }
  .handle[data-kind="off"]::after { border-radius: 6px; }
  .handle:hover::after, .handle:focus-within::after { display: block; }
  .handle:focus-within { z-index: 2; }
  .handle:focus-within::after { border-color: var(--accent); border-width: 3px; }
  .handle input { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; margin: 0; opacity: 0; pointer-events: none; }
  .handle :focus-visible { outline: none; }
  .table { overflow-x: auto; }
  table { border-collapse: collapse; inline-size: 100%; font-variant-numeric: tabular-nums; }
  caption { padding: 0.6rem 0.9rem 0.2rem; text-align: start; font-weight: 600; }
  th, td { padding: 0.35rem 0.6rem; text-align: end; border-block-start: 1px solid var(--rim); font-weight: 400; }
  thead th { border-block-start: 0; color: var(--quiet); font-size: 0.875rem; vertical-align: bottom; }
  th:first-child, td:first-child { min-inline-size: 9rem; text-align: start; padding-inline-start: 0.9rem; }
  th:last-child, td:last-child { padding-inline-end: 0.9rem; }
  @media (max-width: 30rem) {
    .table { font-size: 0.8125rem; line-height: 1.35; }
    th, td { padding-inline: 0.25rem; }
    thead th { font-size: inherit; }
    th:first-child, td:first-child { min-inline-size: 0; }
    td.counts { white-space: normal; }
    .key { gap: 0.3rem; }
    .key > svg { inline-size: 20px; }
  }
  .away { position: absolute; inline-size: 1px; block-size: 1px; margin: -1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
  .arrow path { stroke: var(--field); stroke-width: 1.25; fill: none; }
  .arrow.right path:first-child { stroke-dasharray: 5 4; }
  .arrow .factor { fill: var(--quiet); font-size: 12px; font-style: italic; font-family: ui-serif, Georgia, serif; }
  .arrow.lit path { stroke-width: 2.5; }
  .arrow.left.lit path { stroke: var(--handle); }
  .arrow.right.lit path { stroke: var(--curve); }
  .arrow.lit .factor { fill: var(--ink); font-weight: 650; }
  .node { cursor: pointer; }
  .node rect { fill: var(--panel); stroke: var(--field); stroke-width: 1; }
  .node.chosen rect { stroke: var(--accent); stroke-width: 2.5; }
  .node:focus { outline: none; }
  .node:focus-visible rect { stroke: var(--ink); stroke-width: 3.5; }
  .ways { display: flex; flex-wrap: wrap; gap: 0.4rem; padding: 0 0.9rem 0.75rem; }
  .ways button { min-block-size: 1.9rem; padding: 0.1rem 0.55rem; font-size: 0.875rem; font-variant-numeric: tabular-nums; }
  .row { fill: none; }
  rect.row { fill: var(--panel); stroke: var(--rim); }
  .bar { fill: var(--curve); stroke: var(--paper); stroke-width: 0.75; }
  .bar.bar1, .bar.mine { fill: var(--handle); }
  .dropped { fill: none; stroke: var(--quiet); stroke-width: 1; stroke-dasharray: 2 4; }
  .edge { fill: none; stroke: var(--handle); stroke-width: 1.25; stroke-dasharray: 6 4; }
  .plane { fill: var(--handle); fill-opacity: 0.1; stroke: var(--quiet); stroke-width: 1; }
  .orbit { cursor: grab; touch-action: pan-y; }
  .orbit:active { cursor: grabbing; }
  .orbit:focus-visible { outline-offset: -3px; }
  .key { display: flex; align-items: center; gap: 0.6rem; }
  .key svg { inline-size: 34px; flex: none; }
  td, .line { white-space: nowrap; }
  .thumbs { display: grid; grid-template-columns: repeat(auto-fill, minmax(5.2rem, 1fr)); gap: 0.4rem; padding: 0.2rem 0.75rem 0.75rem; }
  .thumb { position: relative; display: block; padding: 0.2rem; border: 1px solid var(--rim); border-radius: 7px; background: var(--paper); text-align: center; }
  .thumb:hover { border-color: var(--accent); }
  .thumb input { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; opacity: 0; cursor: pointer; }
  .thumb:has(:checked) { border: 3px solid var(--accent); padding: calc(0.2rem - 2px); }
  .thumb[data-twin="true"] { border: 2px dashed var(--handle); padding: calc(0.2rem - 1px); }
  .thumb:has(:focus-visible) { outline: 2px solid var(--accent); outline-offset: 3px; }
  .thumb .curve { stroke-width: 4; }
  .thumb .thin { fill: none; stroke: var(--quiet); stroke-width: 1; stroke-opacity: 0.55; }
  .thumb .order { font-size: 0.78rem; color: var(--quiet); letter-spacing: 0.08em; }

  .code .bar { display: flex; gap: 0.8rem; align-items: center; justify-content: space-between; padding: 0.35rem 0.5rem 0 0.9rem; }
  .code .bar span { flex: 1; color: var(--quiet); font-size: 0.875rem; }
  .code .bar button { min-block-size: 1.9rem; padding: 0.1rem 0.7rem; }
  .code [role="tablist"] { display: flex; flex-wrap: wrap; }
  .code [role="tab"] { border: 0; border-block-end: 2px solid transparent; border-radius: 0; background: none; color: var(--quiet); }
  .code [role="tab"][aria-selected="true"] { border-color: var(--accent); color: var(--ink); font-weight: 600; }
  pre { margin: 0; padding: 0.35rem 0.9rem 0.75rem; white-space: pre-wrap; overflow-wrap: anywhere; max-block-size: 16rem; overflow: auto; font: 0.8125rem/1.55 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; }
  pre:focus-visible { outline-offset: -2px; }
  .problem { margin: 0; padding: 0.5rem 0.9rem; border-block-start: 1px solid var(--rim); border-inline-start: 4px solid var(--handle); }
  .problem:empty { display: none; }
  h3 { margin: 0; padding: 0.7rem 0.9rem 0; font-size: 1rem; }
  h3 + .facts { border-block-start: 0; padding-block-start: 0.2rem; }
  h2 { margin: 2rem 0 0.4rem; font-size: 1.25rem; line-height: 1.3; letter-spacing: -0.01em; }
  .say { margin: 0 0 0.8rem; max-inline-size: 42rem; font-size: 1.0625rem; line-height: 1.6; text-wrap: pretty; }
  .frame + .frame { margin-block-start: 1rem; }
  @media (forced-colors: active) { .gridline { stroke-opacity: 0.45; } }
  @media print {
    .controls, .handle, .code button, .keys { display: none; }
    pre { max-block-size: none; }
    .frame { background: none; }
    svg { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  }
`;
