// /migration/: docs/migration.md, whose samples the tests run.
import { readFileSync } from "node:fs";
import { codeHighlighter } from "../build/highlight.js";
import { markdown } from "../build/markdown.js";
import { scrollable } from "../build/tables.js";

const file = new URL("../../docs/migration.md", import.meta.url);

export const data = {
  permalink: "/migration/index.html",
  title: "Migration from bezier-js, paper.js, svg-path-properties and three.js · casteljau",
  description:
    "What the methods of bezier-js, paper.js, svg-path-properties and the curves of three.js are called in casteljau, and what differs.",
  heading: "Migration from other libraries",
  script: "main.js",
};

/** The file below its title. */
export async function render() {
  const md = markdown(await codeHighlighter());
  const html = md.render(readFileSync(file, "utf8").replace(/^# .*\n/, ""));
  return html.replace(/<table>.*?<\/table>/gs, (table) => {
    const heads = Array.from(table.matchAll(/<th>(.*?)<\/th>/g), ([, head]) => head.replaceAll(/<[^>]*>/g, ""));
    return scrollable(table.replace("<table>", '<table class="names">'), `Names in ${heads.join(", ")}`);
  });
}
