// What the tools share: the picture and its controls stand side by side where there is room, on one sheet.
import { css } from "lit";

/** From this width of the element, in CSS pixels, there are two panes: a window of 60rem without its margins. */
export const PANES = 880;

export const toolStyle = css`
  :host { container-type: inline-size; margin-block: 0 2rem; }
  .panes { display: grid; grid-template-columns: minmax(0, 1fr); align-items: start; }
  .pane { min-inline-size: 0; }
  .side { padding-block: 0.4rem; }
  @container (min-width: ${PANES}px) { .panes { grid-template-columns: minmax(0, 1fr) var(--side, 20rem); } }
  @media (any-pointer: coarse) { button { min-block-size: 2.75rem; } }
  .slider { font-weight: 400; }
  .transport { flex-wrap: nowrap; }
  .transport .slider { flex: 1; }
`;
