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

/** @returns {Promise<(code: string, language: string) => string>} code as HTML, with `<span class="comment">` … */
export async function codeHighlighter() {
  const theme = createCssVariablesTheme({ name: "site", variablePrefix: "--" });
  const highlighter = await createHighlighter({ themes: [theme], langs: LANGUAGES });
  return (code, language) => {
    const lang = ALIASES[language] ?? language;
    const { tokens } = highlighter.codeToTokens(code, { lang: /** @type {any} */ (lang), theme: "site" });
    return tokens.map((line) => joined(line).map(spanOf).join("")).join("\n");
  };
}

/** @typedef {{ kind: string, content: string }} Word */

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
