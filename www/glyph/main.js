// The page is the editor; this starts it and keeps the outline in the address.
import "../parts/page.js";
import { keepInAddress } from "../figures/lib/address.js";
import { GlyphEditor } from "./glyph-editor.js";
import { fromSvg, MODES, pathOf } from "./outline.js";

customElements.define("glyph-editor", GlyphEditor);
const editor = /** @type {GlyphEditor} */ (document.querySelector("glyph-editor"));

keepInAddress(editor, {
  read: (state) => {
    const { d, modes } = /** @type {{ d: string, modes: string[][] }} */ (state);
    const outline = fromSvg(d);
    const known = (/** @type {unknown} */ mode) => /** @type {readonly unknown[]} */ (MODES).includes(mode);
    editor.take(
      outline.map((contour, c) => {
        const given = modes?.[c];
        const fits = Array.isArray(given) && given.length === contour.modes.length && given.every(known);
        return fits ? { ...contour, modes: /** @type {any} */ (given) } : contour;
      }),
    );
  },
  write: () => ({ d: pathOf(editor.outline).toSVG({ precision: 2 }), modes: editor.outline.map(({ modes }) => modes) }),
});
