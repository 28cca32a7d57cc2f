// The large picture of the letter: guides, ink, outline, handles, which way each contour runs.
import { html, svg } from "lit";
import { handle, polyline } from "../figures/lib/parts.js";
import { short } from "../figures/lib/numbers.js";
import { GUIDES } from "./glyphs.js";
import { countPoints, movePoint, nodesOf, pathOf } from "./outline.js";

/** @typedef {import("./glyph-editor.js").GlyphEditor} GlyphEditor */
/** @typedef {import("./outline.js").Place} Place */

/** Farther outside of the picture a point has no handle. */
const HANDLE_MARGIN_PX = 12;
/** Hundredths of a pixel are enough. */
const PRECISION = 2;
/** Seen closer than this, arrow keys take small steps. */
const CLOSE_UNITS = 200;

/**
 * An arrow in the middle of every contour's longest segment.
 *
 * @param {import("./outline.js").Outline} outline
 * @param {(point: readonly number[]) => Place} place
 */
function directionArrows(outline, place) {
  return outline.map(({ spline }) => {
    const segments = spline.segments();
    const longest = segments.reduce((best, segment) => (segment.length() > best.length() ? segment : best));
    const { x, y } = longest.eval(0.5);
    const tangent = longest.tangent(0.5);
    const [px, py] = place([x, y]);
    const [dx, dy] = [tangent.x, tangent.y];
    return svg`<path class="way" d="M${px + 10 * dx} ${py + 10 * dy}L${px - 6 * dx - 7 * dy} ${py - 6 * dy + 7 * dx}L${px - 6 * dx + 7 * dy} ${py - 6 * dy - 7 * dx}Z" />`;
  });
}

/** @param {GlyphEditor} editor */
export function outlineView(editor) {
  const { place, unplace, height, matrix } = editor.scales();
  const visible = ([x, y] = /** @type {Place} */ ([0, 0])) =>
    x > -HANDLE_MARGIN_PX &&
    y > -HANDLE_MARGIN_PX &&
    x < editor.pictureWidth + HANDLE_MARGIN_PX &&
    y < height + HANDLE_MARGIN_PX;
  const nodes = editor.outline.flatMap(({ spline }, c) => nodesOf(spline).map((node) => ({ ...node, c })));
  const shown = nodes.filter((node) => visible(place(node.at)));
  const rods = editor.outline.flatMap(({ spline }) =>
    spline.segments().flatMap((segment) => {
      const flat = segment.transform(matrix).controlPoints();
      const n = flat.length;
      return segment.degree > 1 ? [polyline("rod", flat.subarray(0, 4)), polyline("rod", flat.subarray(n - 4))] : [];
    }),
  );
  const reach = editor.seen.units * 4;
  const box = {
    min: [editor.seen.x - reach, editor.seen.y - reach],
    max: [editor.seen.x + reach, editor.seen.y + reach],
  };
  const [sx, sy] = place(editor.selected.node.at);
  const counts = countPoints(editor.outline);
  return html`
    <svg class="outline-view" viewBox="0 0 ${editor.pictureWidth} ${height}" role="img" tabindex="0" @pointerdown=${(/** @type {any} */ event) => editor.pan(event)} @wheel=${(/** @type {any} */ event) => editor.wheel(event)} @keydown=${(/** @type {any} */ event) => editor.onKey(event)} @dblclick=${(/** @type {any} */ event) => editor.insertHere(event)}
      @pointermove=${(/** @type {PointerEvent} */ event) => (editor.pointer = editor.locate(event))} @pointerleave=${() => (editor.pointer = null)}
      aria-label="The outline: ${editor.outline.length} contours, ${counts.on} points on it and ${counts.off} beside it. Plus and minus zoom, arrow keys move the picture, zero shows all">
      ${GUIDES.map(([name, y]) => svg`<path class="guide" d="M0 ${place([0, y])[1]}H${editor.pictureWidth}" /><text class="quiet" x="8" y=${place([0, y])[1] - 4}>${name}</text>`)}
      <path class="ink ${editor.filled ? "solid" : ""}" d=${editor.path.transform(matrix).toSVG({ precision: PRECISION })} />
      ${editor.ghost ? svg`<path class="ghost" d=${pathOf(editor.quadratic.outline).transform(matrix).toSVG({ precision: PRECISION })} />` : ""}
      <path class="curve" d=${editor.path.transform(matrix).toSVG({ precision: PRECISION })} stroke-width="2" />
      ${rods}${directionArrows(editor.outline, place)}
      ${
        editor.ghost
          ? editor.quadratic.outline.flatMap(({ spline }) =>
              nodesOf(spline).map(({ at, on }) => {
                const [x, y] = place(at);
                return visible([x, y])
                  ? svg`<circle class="hollow" cx=${x} cy=${y} r=${on ? 4 : 2.5} stroke="var(--quiet)" />`
                  : "";
              }),
            )
          : ""
      }
      ${shown.map(({ at, on }) => {
        const [x, y] = place(at);
        return on
          ? svg`<circle class="on" cx=${x} cy=${y} r="5.5" />`
          : svg`<rect class="off" x=${x - 4.5} y=${y - 4.5} width="9" height="9" />`;
      })}
      <circle class="picked" cx=${sx} cy=${sy} r="11" />
    </svg>
    ${shown.map(({ at, on, index, c }) =>
      handle({
        name: `Contour ${c + 1}, ${on ? "point" : "handle"} ${index}`,
        kind: on ? "on" : "off",
        at,
        place,
        unplace,
        size: [editor.pictureWidth, height],
        box: /** @type {any} */ (box),
        step: editor.seen.units < CLOSE_UNITS ? 0.1 : 1,
        say: (value) => short(value, 1),
        move: (to) => (editor.outline = movePoint(editor.editor.state.outline, c, index, to)),
        done: () => editor.take(editor.outline),
        cancel: () => (editor.outline = editor.editor.state.outline),
        focus: () => (editor.chosen = { c, index }),
      }),
    )}
  `;
}
