// A rule for markdown-it: an inline formula stays on one line with the punctuation before and after it.

/** Opening punctuation at the end of a text, and closing punctuation at its start. */
const [OPENING, CLOSING] = [/[(“]+$/, /^[.,;:!?)”]+/];

/** @param {import("markdown-it").default} md */
export function unbrokenPunctuation(md) {
  md.core.ruler.push("unbroken_punctuation", ({ tokens, Token }) => {
    const token = (/** @type {string} */ type, /** @type {string} */ content) =>
      Object.assign(new Token(type, "", 0), { content });
    for (const inline of tokens) {
      const children = inline.children ?? [];
      inline.children = children.flatMap((child, k) => {
        if (child.type !== "math_inline") return [child];
        const before = take(children[k - 1], OPENING);
        const after = take(children[k + 1], CLOSING);
        if (!before && !after) return [child];
        return [
          token("html_inline", '<span class="unbroken">'),
          token("text", before),
          child,
          token("text", after),
          token("html_inline", "</span>"),
        ];
      });
    }
  });
}

/**
 * Removes the punctuation that matches from a text and returns it.
 *
 * @param {{ type: string, content: string } | undefined} text
 * @param {RegExp} pattern
 */
function take(text, pattern) {
  const found = text?.type === "text" ? pattern.exec(text.content) : null;
  if (!text || !found) return "";
  text.content = text.content.replace(pattern, "");
  return found[0];
}
