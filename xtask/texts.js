// Writes dist/texts.json: the English texts of the elements and the applet, which `setTranslations` replaces. Called by
// scripts/build.js; runs from the repository's root. A text that is not a literal is an error, and so is one in a
// template that is not in the table.
import ts from "typescript-api";
import { readdir, readFile, writeFile } from "node:fs/promises";

const FOLDERS = ["applet", "editor", "elements", "layers", "ui"].map((name) => `js/${name}`);
/** Where the functions are defined. */
const OWN = "js/editor/translations.ts";

async function sources() {
  const names = await Promise.all(
    FOLDERS.map(async (folder) =>
      (await readdir(folder, { recursive: true }))
        .map((name) => `${folder}/${name}`)
        .filter((name) => name.endsWith(".ts") && name !== OWN),
    ),
  );
  const read = async (name) => ts.createSourceFile(name, await readFile(name, "utf8"), ts.ScriptTarget.ES2022, true);
  return Promise.all(names.flat().sort().map(read));
}

function visited(node, visit) {
  visit(node);
  ts.forEachChild(node, (child) => visited(child, visit));
}

function textsIn(source) {
  const texts = [];
  visited(source, (node) => {
    const name = ts.isCallExpression(node) && ts.isIdentifier(node.expression) ? node.expression.text : "";
    if (name === "translated" || name === "translatedParts") texts.push(literal(node.arguments[0]));
    if (name === "translatedTable")
      texts.push(...node.arguments[0].properties.map(({ initializer }) => literal(initializer)));
  });
  return texts;
}

/** The value of a text, which may be a sum of texts. */
function literal(node) {
  if (ts.isStringLiteral(node)) return node.text;
  if (ts.isBinaryExpression(node) && node.operatorToken.kind === ts.SyntaxKind.PlusToken)
    return literal(node.left) + literal(node.right);
  throw new TypeError(`${node.getSourceFile().fileName}: expected a text, got ${node.getText()}`);
}

/** What is the same in every language: letters of formulas, entities, units, signs, formats. */
const SAME = /^(&\w+;|[a-zA-Z]|ms|px|PNG|[^a-zA-Z]*)$/;

/** The words that stand in the templates of a source. */
function wordsIn(source) {
  const words = [];
  visited(source, (node) => {
    if (!ts.isTaggedTemplateExpression(node) || !/^(html|svg)$/.test(node.tag.getText())) return;
    const { template } = node;
    const pieces = ts.isNoSubstitutionTemplateLiteral(template)
      ? [template.text]
      : [template.head.text, ...template.templateSpans.map(({ literal }) => literal.text)];
    const tags = /<[^>]*>/g;
    const whole = pieces.join("{}");
    const attributes = [...whole.matchAll(/\b(?:aria-label|title|placeholder)="([^"]*)"/g)].map(([, value]) => value);
    words.push(...[whole.replace(tags, " "), ...attributes].flatMap((part) => part.split(/\s|\{\}/)));
  });
  return words.filter((word) => !SAME.test(word)).map((word) => `${source.fileName}: ${word}`);
}

const all = await sources();
const untranslated = all.flatMap(wordsIn);
if (untranslated.length) throw new Error(`texts that are not in the table:\n${untranslated.join("\n")}`);
const texts = [...new Set(all.flatMap(textsIn))].sort();
await writeFile(
  "dist/texts.json",
  `${JSON.stringify(Object.fromEntries(texts.map((text) => [text, text])), null, 2)}\n`,
);
