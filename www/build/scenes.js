// A rule for markdown-it that makes scenes of the sections of a chapter: a figure with the text and the tasks that belong to it. The style
// puts the figure beside them, or above them on narrow screens, so that it stays in view (parts/scenes.css).
//
// A scene begins with the text that leads to its figure. The text below a figure belongs to it up to its last task; without a task, up
// to the next heading of the third level, and otherwise it leads to the next figure. A task stands in the scene of the figure that it
// names, also where the text has it further below.

/** @typedef {import("markdown-it").Token} Token */
/** @typedef {{ kind: string, tokens: Token[], ids: string[], target: string }} Block */
/** @typedef {{ before: Block[], figure: Block | undefined, after: Block[] }} Scene */

/** The top-level blocks of a section. @param {readonly Token[]} tokens @returns {Block[]} */
function blocksOf(tokens) {
  const blocks = /** @type {Block[]} */ ([]);
  let depth = 0;
  for (const token of tokens) {
    if (depth === 0) {
      const [, kind = token.type === "heading_open" ? token.tag : "text"] =
        /^container_(\w+)_open$/.exec(token.type) ?? [];
      blocks.push({ kind, tokens: [], ids: [], target: token.meta?.for ?? "" });
    }
    const block = /** @type {Block} */ (blocks.at(-1));
    block.tokens.push(token);
    for (const [, id] of token.content.matchAll(/\sid="([^"]+)"/g)) block.ids.push(id);
    depth += token.nesting;
  }
  return blocks;
}

/** The end of the text that belongs to a figure, in the blocks between it and the next one. @param {readonly Block[]} blocks */
function endOfText(blocks) {
  const task = blocks.findLastIndex(({ kind }) => kind === "task");
  if (task >= 0) return task + 1;
  return Math.max(
    0,
    blocks.findIndex(({ kind }) => kind === "h3"),
  );
}

/** @param {readonly Block[]} blocks of a section, without its samples @returns {Scene[]} */
function scenesOf(blocks) {
  const figures = blocks.filter(({ kind }) => kind === "figure");
  /** The figure of a task that stands below a later one. */
  const remote = new Map(
    blocks.flatMap((block, i) => {
      const own = block.kind === "task" && figures.find(({ ids }) => ids.includes(block.target));
      const last = blocks.findLast(({ kind }, k) => k < i && kind === "figure");
      return own && own !== last ? [[block, own]] : [];
    }),
  );
  const rest = blocks.filter((block) => !remote.has(block));
  const places = rest.flatMap(({ kind }, i) => (kind === "figure" ? [i] : []));
  const scenes = /** @type {Scene[]} */ ([]);
  let start = 0;
  places.forEach((at, k) => {
    const next = places[k + 1] ?? rest.length;
    const between = rest.slice(at + 1, next);
    const tasks = [...remote].filter(([, figure]) => figure === rest[at]).map(([task]) => task);
    const heading = between.findIndex(({ kind }) => kind === "h3");
    const whole =
      next === rest.length
        ? between.length
        : tasks.length === 0
          ? endOfText(between)
          : heading < 0
            ? between.length
            : heading;
    scenes.push({ before: rest.slice(start, at), figure: rest[at], after: [...between.slice(0, whole), ...tasks] });
    start = at + 1 + whole;
  });
  if (scenes.length === 0) scenes.push({ before: [...rest], figure: undefined, after: [] });
  return scenes;
}

/** @param {import("markdown-it").default} md */
export function scenes(md) {
  md.core.ruler.push("scenes", (state) => {
    if (state.env.chapter === undefined) return;
    /** @param {string} className @param {readonly Token[]} tokens @returns {Token[]} */
    const division = (className, tokens) => {
      if (tokens.length === 0) return [];
      const [open, close] = [new state.Token("div_open", "div", 1), new state.Token("div_close", "div", -1)];
      open.block = close.block = true;
      open.attrs = [["class", className]];
      return [open, ...tokens, close];
    };
    const tokensOf = (/** @type {readonly Block[]} */ blocks) => blocks.flatMap(({ tokens }) => tokens);
    const out = /** @type {Token[]} */ ([]);
    let tokens = state.tokens;
    for (;;) {
      const start = tokens.findIndex(({ type }) => type === "section_open");
      if (start < 0) break;
      const end = tokens.findIndex(({ type }) => type === "section_close");
      const blocks = blocksOf(tokens.slice(start + 1, end));
      const samples = blocks.filter(({ kind }) => kind === "sample");
      const parts = scenesOf(blocks.filter(({ kind }) => kind !== "sample"));
      out.push(...tokens.slice(0, start + 1));
      for (const { before, figure, after } of parts)
        out.push(
          ...division("scene", [
            ...division("before", tokensOf(before)),
            ...division("side", figure?.tokens ?? []),
            ...division("after", tokensOf(after)),
          ]),
        );
      out.push(...tokensOf(samples), tokens[end]);
      tokens = tokens.slice(end + 1);
    }
    state.tokens = [...out, ...tokens];
    numberTasks(state.tokens);
  });
}

/** Tasks that have been moved are numbered in their new order. @param {readonly Token[]} tokens */
function numberTasks(tokens) {
  const tasks = tokens.filter(({ type, meta }) => type === "container_task_open" && meta?.number);
  const place = (/** @type {string} */ number) => Number(number.split(".")[1]);
  const numbers = tasks.map(({ meta }) => meta.number).sort((a, b) => place(a) - place(b));
  tasks.forEach(({ meta }, i) => (meta.number = numbers[i]));
}
