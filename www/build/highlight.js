// Code in colours, by Shiki while the site is built: classes, whose colours site.css gives for light and dark.
import { createCssVariablesTheme, createHighlighter } from "shiki";

const LANGUAGES = ["js", "rust", "html", "css", "sh"];
/** Names of languages as pages write them. @type {Record<string, string>} */
const ALIASES = { rs: "rust", "": "text", javascript: "js" };
/**
 * Class names by Shiki's kinds of tokens, and which tokens of a kind have it. All others have the colour of the text: it keeps
 * the pages small.
 *
 * @type {Record<string, { name: string, pattern: RegExp }>}
 */
const CLASSES = {
  "token-comment": { name: "comment", pattern: /\S/ },
  "token-keyword": { name: "keyword", pattern: /^\s*[a-z]/ }, // not operators
  "token-string": { name: "string", pattern: /\S/ },
  "token-string-expression": { name: "string", pattern: /\S/ },
  "token-constant": { name: "number", pattern: /^\s*\d/ },
};

/** @param {string} text */
export const escapeHtml = (text) =>
  text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c] ?? c);

/** A part of the code that gets a `<span>` with an attribute. @typedef {{ start: number, end: number, attribute: string }} Mark */

/** @returns {Promise<(code: string, language: string, marks?: Mark[]) => string>} code as HTML, with `<span class="comment">` … */
export async function codeHighlighter() {
  const theme = createCssVariablesTheme({ name: "site", variablePrefix: "--" });
  const highlighter = await createHighlighter({ themes: [theme], langs: LANGUAGES });
  return (code, language, marks = []) => {
    const lang = ALIASES[language] ?? language;
    const { tokens } = highlighter.codeToTokens(code, { lang: /** @type {any} */ (lang), theme: "site" });
    return tokens.map((line) => markedLine(line, marks)).join("\n");
  };
}

/** @typedef {{ content: string, offset: number, color?: string }} Token */
/** @typedef {{ kind: string, content: string }} Word */

/** @param {readonly Token[]} line @param {Mark[]} marks */
function markedLine(line, marks) {
  const pieces = line.flatMap((token) => cut(token, marks));
  let html = "";
  for (let i = 0; i < pieces.length; ) {
    const mark = marks.find((each) => isInside(pieces[i], each));
    let end = i + 1;
    while (end < pieces.length && marks.find((each) => isInside(pieces[end], each)) === mark) end++;
    const words = joined(pieces.slice(i, end)).map(spanOf).join("");
    html += mark ? `<span ${mark.attribute}>${words}</span>` : words;
    i = end;
  }
  return html;
}

/** @param {Token} token @param {Mark} mark */
const isInside = ({ offset }, { start, end }) => offset >= start && offset < end;

/** A token cut where marks begin and end. @param {Token} token @param {Mark[]} marks @returns {Token[]} */
function cut(token, marks) {
  const ends = marks.flatMap(({ start, end }) => [start - token.offset, end - token.offset]);
  const inner = ends.filter((at) => at > 0 && at < token.content.length).sort((a, b) => a - b);
  const bounds = [0, ...inner, token.content.length];
  return bounds.slice(1).map((end, k) => ({
    ...token,
    content: token.content.slice(bounds[k], end),
    offset: token.offset + bounds[k],
  }));
}

/** Neighbours of one kind in one. @param {readonly { content: string, color?: string }[]} line */
function joined(line) {
  const words = /** @type {Word[]} */ ([]);
  for (const { content, color } of line) {
    const known = CLASSES[color?.match(/var\(--([\w-]+)\)/)?.[1] ?? ""];
    const kind = known?.pattern.test(content) ? known.name : "";
    const last = words.at(-1);
    if (last && (last.kind === kind || content.trim() === "")) last.content += content;
    else words.push({ kind, content });
  }
  return words;
}

/** @param {Word} word */
const spanOf = ({ kind, content }) =>
  kind ? `<span class="${kind}">${escapeHtml(content)}</span>` : escapeHtml(content);
