// Draws every <bezier-applet …></bezier-applet> into the page while the site is built: the picture that is there before the
// element starts, without JavaScript, and on paper. By the same layers that draw it later.
import { FONT_FAMILY } from "#js/ui/tokens.js";
import { FIELDS } from "#js/editor/schema.js";
import { attributeName } from "#js/elements/attribute-text.js";
import { figureOf } from "#js/editor/figure.js";
import { svgFigure } from "#js/layers/svg.js";
import { RATIONAL_LAYERS } from "#js/layers/rational.js";
import { firstState, weightsOf } from "#js/editor/state.js";
import { RationalCurve } from "#js/nurbs.js";

/** The page's own colours where it has them: they follow dark and light. */
const THEME = { ink: "var(--ink)", quiet: "var(--quiet)", paper: "var(--stage)" };

/**
 * The attributes of a tag; those without a value are "".
 *
 * @param {string} tag
 * @returns {Record<string, string>}
 */
const attributesOf = (tag) =>
  Object.fromEntries(Array.from(tag.matchAll(/\s([\w-]+)(?:="([^"]*)")?/g), ([, name, value = ""]) => [name, value]));

/**
 * The picture of an applet with these attributes.
 *
 * @param {Record<string, string>} attributes
 * @returns {string} SVG
 */
export function posterOf(attributes) {
  const state = Object.entries(FIELDS).reduce((now, [name, { parse, put }]) => {
    const given = attributes[attributeName(name)];
    return given === undefined ? now : put(now, parse(given));
  }, firstState());
  const layers = weightsOf(state) ? RATIONAL_LAYERS : undefined;
  return svgFigure(state, figureOf(state, RationalCurve), { theme: THEME, label: attributes.label, layers });
}

/** Attributes that most shapes have: site.css gives them by class, which keeps the pages small. */
const SHORTER = [
  [' xmlns="http://www.w3.org/2000/svg"', ""],
  [` font-family="${FONT_FAMILY.replaceAll('"', "&quot;")}"`, ""], // as on the page around it
  [
    ' font-weight="600" font-size="13" stroke="var(--stage)" stroke-width="4" paint-order="stroke" fill="var(--ink)"',
    ' class="l"',
  ],
  [
    ' font-weight="450" font-size="12" stroke="var(--stage)" stroke-width="4" paint-order="stroke" fill="var(--ink)"',
    ' class="s"',
  ],
  [' fill="#0072b2" stroke="var(--stage)" stroke-width="1.5"', ' class="d"'],
  [' fill="#d55e00" stroke="var(--stage)" stroke-width="1.5"', ' class="h"'],
];

/** @param {string} svg */
const shortened = (svg) => SHORTER.reduce((text, [from, to]) => text.replaceAll(from, to), svg);

/** Draws the picture into every empty `<bezier-applet>` of a page. @param {string} html */
export const addAppletPosters = (html) =>
  html.replace(
    /<bezier-applet\b([^>]*)>\s*(?=<\/bezier-applet>)/g,
    (tag, attributes) => tag + shortened(posterOf(attributesOf(attributes))),
  );
