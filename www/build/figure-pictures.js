// Pictures of the small figures (www/figures/fig-….js) for the grid of /figures/: their own templates, written as text.
import { escapeHtml } from "./highlight.js";

/** How wide a picture is, in the CSS pixels for which a figure is drawn. */
const WIDTH = 400;

/** A value of a template of Lit as HTML. @param {any} value @returns {string} */
function textOf(value) {
  if (value === null || value === undefined || value === false || typeof value === "symbol") return "";
  if (Array.isArray(value)) return value.map(textOf).join("");
  if (value._$litType$) return templateOf(value);
  if (value._$litDirective$) return textOf(value.values[0]); // live() and the like
  return escapeHtml(String(value));
}

/** A template of Lit as HTML, without listeners and properties. @param {{ strings: readonly string[], values: unknown[] }} template */
function templateOf({ strings, values }) {
  let html = strings[0];
  values.forEach((value, i) => {
    const bound = /\s([@.?]?)[\w-]+=$/.exec(html);
    if (bound?.[1]) html = html.slice(0, bound.index);
    else html += bound ? `"${textOf(value)}"` : textOf(value);
    html += strings[i + 1];
  });
  return html;
}

/** For a table of operation counts: a bar for each row. @param {string} html */
function barsOf(html) {
  const rows = Array.from(html.matchAll(/<tr data-way=.*?<\/tr>/gs), ([row]) => {
    const counts = row.match(/<td class="counts">[^<]*(?=<)/g)?.at(-1) ?? "";
    return {
      name: /<th[^>]*>([^<]*)/.exec(row)?.[1] ?? "",
      sum: (counts.match(/\d+/g) ?? []).reduce((sum, count) => sum + Number(count), 0),
    };
  }).filter(({ sum }) => sum > 0);
  if (rows.length === 0) throw new Error("expected an SVG or a table of operation counts");
  const most = Math.max(...rows.map(({ sum }) => sum));
  const step = 240 / rows.length;
  const bars = rows.map(({ name, sum }, i) => {
    const y = 12 + i * step;
    return `<text x="8" y="${y + 11}">${name}</text><rect class="bar" x="8" y="${y + 16}" width="${(340 * sum) / most}" height="10"/><text class="quiet" x="${14 + (340 * sum) / most}" y="${y + 26}">${sum}</text>`;
  });
  return `<svg viewBox="0 0 ${WIDTH} 256">${bars.join("")}</svg>`;
}

/**
 * The first picture of a figure as an SVG.
 *
 * @param {string} tag
 * @returns {Promise<string>}
 */
export async function figurePicture(tag) {
  await import(`../figures/${tag}.js`);
  const figure = new /** @type {any} */ (customElements.get(tag))();
  figure.wide = WIDTH;
  await figure.load?.();
  const html = textOf(figure.render());
  const [svg] = /<svg\b.*?<\/svg>/s.exec(html) ?? [barsOf(html)];
  return svg
    .replace(/<!--.*?-->/gs, "")
    .replace(/\s(?:role|tabindex|class|aria-[\w-]+)="[^"]*"(?=[^>]*>)/g, (attribute) =>
      attribute.startsWith(" class") ? attribute : "",
    )
    .replace("<svg", '<svg aria-hidden="true"')
    .replace(/\s+/g, " ");
}
