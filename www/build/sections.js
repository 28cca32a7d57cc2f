// Rules for markdown-it about the structure of a page: sections around second-level headings, numbers, and elements that
// stand alone.

/** @typedef {import("markdown-it").default} MarkdownIt */
/** @typedef {import("markdown-it").StateCore} StateCore */
/** @typedef {import("markdown-it").Token} Token */

/** Every heading of the second level begins a `<section>`, which takes its id. @param {MarkdownIt} md */
export function sections(md) {
  md.core.ruler.push("sections", (state) => {
    const tokens = [];
    let open = false;
    for (const token of state.tokens) {
      if (token.type === "heading_open" && token.tag === "h2") {
        if (open) tokens.push(tag(state, "section", -1));
        const section = tag(state, "section", 1);
        section.attrs = [["id", token.attrGet("id") ?? ""]];
        token.attrs = token.attrs?.filter(([name]) => name !== "id") ?? null;
        tokens.push(section);
        open = true;
      }
      tokens.push(token);
    }
    if (open) tokens.push(tag(state, "section", -1));
    state.tokens = tokens;
  });
}

/** @param {StateCore} state @param {string} name @param {1 | -1} nesting */
function tag(state, name, nesting) {
  const token = new state.Token(`${name}_${nesting === 1 ? "open" : "close"}`, name, nesting);
  token.block = true;
  return token;
}

/** A custom element on lines of its own is not wrapped in a paragraph. @param {MarkdownIt} md */
export function standaloneElements(md) {
  md.core.ruler.push("standalone_elements", ({ tokens }) => {
    tokens.forEach((token, i) => {
      const children = token.type === "inline" && tokens[i - 1].type === "paragraph_open" ? token.children : null;
      if (!children?.length || !/^<[a-z]+-/.test(children[0].content)) return;
      if (!children.every(({ type, content }) => type === "html_inline" || content.trim() === "")) return;
      tokens[i - 1].hidden = true;
      tokens[i + 1].hidden = true;
    });
  });
}

/**
 * Numbers of sections, figures and tasks, in pages with `chapter` in their front matter. A link without text, `[](#figure-net)`,
 * gets the text “Figure 2.3”.
 *
 * @param {MarkdownIt} md
 */
export function numbers(md) {
  md.core.ruler.before("captions", "numbers", ({ tokens, env, Token }) => {
    const { chapter } = env;
    if (chapter === undefined) return;
    const counts = { section: 0, figure: 0, task: 0 };
    tokens.forEach((token, i) => {
      if (token.type === "heading_open" && token.tag === "h2") {
        const number = new Token("html_inline", "", 0);
        number.content = `<span class="nr">${chapter}.${++counts.section}</span> `;
        tokens[i + 1].children?.unshift(number);
      }
      if (token.type === "container_figure_open") token.meta.number = `${chapter}.${++counts.figure}`;
      if (token.type === "container_task_open") token.meta.number = `${chapter}.${++counts.task}`;
    });
    const figures = tokens.filter(({ type }) => type === "container_figure_open");
    const byId = new Map(figures.map(({ meta }) => [`#figure-${meta.name}`, meta.number]));
    for (const { children } of tokens) if (children) nameReferences(children, byId, Token);
  });
}

/** @param {Token[]} children @param {Map<string, string>} figures numbers by address @param {StateCore["Token"]} Token */
function nameReferences(children, figures, Token) {
  for (let i = children.length - 2; i >= 0; i--) {
    const address = children[i].type === "link_open" ? children[i].attrGet("href") : null;
    if (!address || children[i + 1].type !== "link_close") continue;
    const text = new Token("text", "", 0);
    if (!figures.has(address))
      throw new Error(`expected a figure of the page in the link without text, got ${address}`);
    text.content = `Figure\u00a0${figures.get(address)}`;
    children.splice(i + 1, 0, text);
  }
}
