// Writes dist/custom-elements.json: what the elements have, for editors and for pages about them. Called by
// `cargo xtask build` after the bundles; runs from the repository's root. What there is comes from the sources and from the
// built classes; what is said about it comes from JSDoc: of js/elements/**/types.js for properties and methods, of
// @fires, @csspart, @cssprop and @slot for the rest, wherever they stand among an element's sources. With --check it fails where a
// public member of an element is not described.
import { create, ts } from "@custom-elements-manifest/analyzer/index.js";
import { existsSync } from "node:fs";
import { readFile, writeFile } from "node:fs/promises";
import { dirname, relative, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const INDEX = resolve("js/elements/index.js");
const TYPES = ["js/elements/types.js", "js/elements/companions/types.js"];
const MODULE = "dist/elements.js";
const TAGS = { fires: "events", csspart: "cssParts", cssprop: "cssProperties", slot: "slots" };

/** Each file's text, read once. @type {Map<string, Promise<string>>} */
const texts = new Map();
const textOf = (path) => texts.get(path) ?? texts.set(path, readFile(path, "utf8")).get(path);

/** All views of companions are one file; an element's own stands beside it. */
const VIEWS = resolve("js/elements/companions/views.js");

/** A file and all that it imports, of the elements' own. */
async function reach(path, known = new Set()) {
  if (known.has(path) || path === VIEWS) return known;
  known.add(path);
  const view = path.replace(/\.js$/, "-view.js");
  if (existsSync(view)) await reach(view, known);
  for (const [, target] of (await textOf(path)).matchAll(/(?:from |^import |import\()"(\.[^"]+)"/gm)) {
    const file = resolve(dirname(path), target);
    if (/[\\/]js[\\/](elements|applet)[\\/]/.test(file) && file !== INDEX) await reach(file, known);
  }
  return known;
}

/** Tag name, class and module of each element, as the index defines them. */
async function elementsOf() {
  const text = await textOf(INDEX);
  const imports = Object.fromEntries(
    [...text.matchAll(/import \{ (\w+) as (\w+) \} from "([^"]+)"/g)].map(([, name, local, path]) => [
      local,
      { name, path: resolve(dirname(INDEX), path) },
    ]),
  );
  return [...text.matchAll(/defined\("(bezier-[\w-]+)", (\w+)\)/g)].map(([, tagName, local]) => ({
    tagName,
    ...imports[local],
  }));
}

const words = (comment) =>
  (typeof comment === "string" ? comment : (ts.getTextOfJSDocComment(comment) ?? "")).replace(/\s+/g, " ").trim();

/** The JSDoc of a file: every comment, parsed. */
async function commentsOf(path) {
  const source = ts.createSourceFile(path, await textOf(path), ts.ScriptTarget.ES2022, true, ts.ScriptKind.JS);
  const found = [];
  const visit = (node) => {
    found.push(...(node.jsDoc ?? []));
    ts.forEachChild(node, visit);
  };
  visit(source);
  found.push(...(source.endOfFileToken.jsDoc ?? []));
  return [...new Set(found)];
}

/** The typedefs of the types: name, words, type, properties. */
async function typedefs() {
  const all = (await Promise.all(TYPES.map((path) => commentsOf(resolve(path))))).flat();
  return Object.fromEntries(
    all.flatMap((comment) =>
      (comment.tags ?? [])
        .filter(ts.isJSDocTypedefTag)
        .map((tag) => [tag.name.getText(), { words: words(comment.comment), ...shape(tag.typeExpression) }]),
    ),
  );
}

function shape(expression) {
  if (!expression || !ts.isJSDocTypeLiteral(expression)) return { type: expression?.getText() ?? "", members: [] };
  const member = ({ name, typeExpression, comment }) => ({
    name: name.getText(),
    type: typeExpression.type.getText().replace(/\s+/g, " "),
    words: words(comment),
  });
  return { type: "", members: (expression.jsDocPropertyTags ?? []).map(member) };
}

/** What the typedefs say of a class, by `<class>Element`. */
function described(types, name) {
  const parts = types[`${name}Element`].type.match(/\w+Properties/g).map((each) => types[each]);
  return { words: parts.at(-1).words, members: parts.flatMap(({ members }) => members) };
}

/** @fires, @csspart, @cssprop and @slot of an element's sources. */
async function taggedIn(files) {
  const found = Object.fromEntries(Object.values(TAGS).map((kind) => [kind, new Map()]));
  for (const path of files) {
    for (const comment of await commentsOf(path)) {
      for (const [, tag, name, said] of comment.getText().matchAll(/@(fires|csspart|cssprop|slot) (\S+) - ([^\n]+)/g))
        found[TAGS[tag]].set(name, { name: name === "default" ? "" : name, description: said.trim() });
    }
  }
  return Object.fromEntries(Object.entries(found).map(([kind, entries]) => [kind, [...entries.values()]]));
}

const isMethod = (type) => type.startsWith("(") && type.includes("=>");

/** Parameters and result of a method, of its type in words. */
function method({ name, type, words }) {
  const source = ts.createSourceFile("type.ts", `type T = ${type}`, ts.ScriptTarget.ES2022, true);
  const { parameters, type: result } = source.statements[0].type;
  const parameter = (each) => ({
    name: each.name.getText(),
    type: { text: each.type.getText() },
    ...(each.questionToken && { optional: true }),
  });
  return {
    kind: "method",
    name,
    privacy: "public",
    ...(words && { description: words }),
    parameters: parameters.map(parameter),
    return: { type: { text: result.getText() } },
  };
}

/** The class's declaration, made whole by what its types, its tags and the built class say. */
async function completed(declaration, { tagName, name, path }, types, built) {
  const { words, members } = described(types, name);
  const tags = await taggedIn(await reach(path));
  const member = Object.fromEntries(members.map((each) => [each.name, each]));
  const attributes = new Map(
    [...built.observedAttributes].map((attribute) => [attribute, propertyOf(built, attribute, member)]),
  );
  const field = (each) => ({
    kind: "field",
    name: each.name,
    privacy: "public",
    type: { text: each.type },
    ...(each.words && { description: each.words }),
    ...attributeOf(attributes, each.name),
  });
  const attribute = ([attribute, property]) => ({
    name: attribute,
    fieldName: property,
    type: { text: member[property]?.type ?? "string" },
    ...(member[property]?.words && { description: member[property].words }),
  });
  return {
    kind: "class",
    name,
    tagName,
    customElement: true,
    description: words,
    superclass: { name: "HTMLElement" },
    ...(declaration.formAssociated && { formAssociated: true }),
    attributes: [...attributes].map(attribute),
    members: members.map((each) => (isMethod(each.type) ? method(each) : field(each))),
    ...tags,
  };
}

/** The property of an attribute: mostly its namesake. */
function propertyOf(built, attribute, member) {
  const [property] = [...built.elementProperties].find(([, options]) => options.attribute === attribute) ?? [attribute];
  return member[property] ? property : attribute;
}

function attributeOf(attributes, property) {
  const found = [...attributes].find(([, each]) => each === property);
  return found ? { attribute: found[0] } : {};
}

/** Public members that the sources have, by the analyzer: every one of them has to be described. */
function undescribed(manifest, { name }, declaration) {
  const classes = Object.fromEntries(
    manifest.modules
      .flatMap(({ declarations }) => declarations)
      .filter(({ kind }) => kind === "class")
      .map((each) => [each.name, each]),
  );
  const chain = [];
  for (let at = classes[name]; at; at = classes[at.superclass?.name]) chain.push(at);
  const known = new Set(declaration.members.map((each) => each.name));
  const open = chain
    .flatMap(({ members = [] }) => members)
    .filter(
      (each) =>
        !each.static && each.privacy !== "private" && each.privacy !== "protected" && !each.name.startsWith("#"),
    );
  return [...new Set(open.map((each) => each.name).filter((each) => !known.has(each) && !LIFE.has(each)))];
}

/** Called by the browser or by Lit. */
const LIFE = new Set([
  "connectedCallback",
  "disconnectedCallback",
  "attributeChangedCallback",
  "formDisabledCallback",
  "formResetCallback",
  "formStateRestoreCallback",
  "createRenderRoot",
  "shouldUpdate",
  "willUpdate",
  "update",
  "updated",
  "firstUpdated",
  "render",
]);

async function main() {
  const elements = await elementsOf();
  const types = await typedefs();
  const files = [...new Set((await Promise.all(elements.map(({ path }) => reach(path)))).flatMap((set) => [...set]))];
  const modules = await Promise.all(
    files.map(async (path) =>
      ts.createSourceFile(relative(".", path), await textOf(path), ts.ScriptTarget.ES2022, true, ts.ScriptKind.JS),
    ),
  );
  const analysed = create({ modules });
  globalThis.CSSStyleSheet ??= class {
    replaceSync() {}
  }; // Lit makes the sheets when it is asked for the attributes
  const built = await import(pathToFileURL(resolve(MODULE)).href);
  const declarations = [];
  for (const element of elements) {
    const declaration = await completed(
      { formAssociated: built[element.name].formAssociated === true },
      element,
      types,
      built[element.name],
    );
    const missing = undescribed(analysed, element, declaration);
    for (const each of missing)
      console.error(
        `${element.name}: ${each}: describe it in ${TYPES.join(" or ")}, or mark it @protected or @internal`,
      );
    if (missing.length && process.argv.includes("--check")) process.exitCode = 1;
    declarations.push(declaration);
  }
  const exports = declarations.flatMap(({ name, tagName }) => [
    { kind: "js", name, declaration: { name, module: MODULE } },
    { kind: "custom-element-definition", name: tagName, declaration: { name, module: MODULE } },
  ]);
  const manifest = {
    schemaVersion: "2.1.0",
    readme: "README.md",
    modules: [{ kind: "javascript-module", path: MODULE, declarations, exports }],
  };
  await writeFile("dist/custom-elements.json", `${JSON.stringify(manifest, null, 2)}\n`);
}

await main();
