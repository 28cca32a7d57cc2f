// Writes dist/custom-elements.json, the custom elements manifest, for editors and documentation. Called by
// scripts/build.js after the bundles; runs from the repository's root. The members come from the sources and from the
// built classes; the descriptions come from comments: of js/elements/**/types.ts for properties and methods, and of the tags
// @fires, @csspart, @cssprop and @slot in the sources of an element for the rest. With --check it fails if a public member
// of an element has no description.
import ts from "typescript-api";
import { readFile, writeFile } from "node:fs/promises";
import { basename, dirname, relative, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const LOADERS = resolve("js/elements/on-demand.ts");
const TYPES = ["js/elements/types.ts", "js/elements/companions/types.ts"];
const TAGS = { fires: "events", csspart: "cssParts", cssprop: "cssProperties", slot: "slots" };

/** The text of each file, read once. @type {Map<string, Promise<string>>} */
const texts = new Map();
const textOf = (path) => texts.get(path) ?? texts.set(path, readFile(path, "utf8")).get(path);

/** The source of what a file imports. */
const sourceOf = (file, path) => resolve(dirname(file), path).replace(/\.js$/, ".ts");

/** A file and all files of the elements, the applet and what they share that it imports. */
async function importedFiles(path, known = new Set()) {
  if (known.has(path)) return known;
  known.add(path);
  for (const [, target] of (await textOf(path)).matchAll(/(?:from |^import |import\()"(\.[^"]+)"/gm)) {
    const file = sourceOf(path, target);
    const isView = /[\\/]js[\\/](elements|applet|editor|layers|ui)[\\/]/.test(file);
    if (isView) await importedFiles(file, known);
  }
  return known;
}

/** Tag name, class, file and built module of each element that casteljau/elements loads. */
async function elementsOf() {
  const files = [...(await textOf(LOADERS)).matchAll(/import\("(\.\/define\/[^"]+)"\)/g)].map(([, path]) =>
    sourceOf(LOADERS, path),
  );
  const element = async (file) => {
    const text = await textOf(file);
    const [, name, path] = text.match(/import \{ (\w+) as \w+ \} from "([^"]+)"/);
    const tagName = text.match(/define\("(bezier-[\w-]+)"/)[1];
    return { tagName, name, path: sourceOf(file, path), module: `dist/elements/${basename(file, ".ts")}.js` };
  };
  return Promise.all(files.map(element));
}

const descriptionOf = (comment) =>
  (typeof comment === "string" ? comment : (ts.getTextOfJSDocComment(comment) ?? "")).replace(/\s+/g, " ").trim();

/** All JSDoc comments of a file, parsed. */
async function commentsOf(path) {
  const source = ts.createSourceFile(path, await textOf(path), ts.ScriptTarget.ES2022, true, ts.ScriptKind.TS);
  const found = [];
  const visit = (node) => {
    found.push(...(node.jsDoc ?? []));
    ts.forEachChild(node, visit);
  };
  visit(source);
  found.push(...(source.endOfFileToken.jsDoc ?? []));
  return [...new Set(found)];
}

/** The types of TYPES: description, text of the type and members, by name. */
async function declaredTypes() {
  const all = [];
  for (const path of TYPES) {
    const source = ts.createSourceFile(path, await textOf(resolve(path)), ts.ScriptTarget.ES2022, true);
    for (const node of source.statements) {
      if (!ts.isInterfaceDeclaration(node) && !ts.isTypeAliasDeclaration(node)) continue;
      const description = documentedAs(node);
      const members = (node.members ?? []).map((member) => ({
        name: member.name.getText(),
        type: member.type.getText().replace(/\s+/g, " "),
        description: documentedAs(member),
      }));
      all.push([node.name.text, { description, type: node.type?.getText() ?? "", members }]);
    }
  }
  return Object.fromEntries(all);
}

const documentedAs = (node) => descriptionOf(node.jsDoc?.at(-1)?.comment);

/** The description and the members of a class: the types that `<class>Element` combines. */
function documentationOf(types, name) {
  const parts = types[`${name}Element`].type.match(/\w+Properties/g).map((each) => types[each]);
  return { description: parts.at(-1).description, members: parts.flatMap(({ members }) => members) };
}

/** The tags @fires, @csspart, @cssprop and @slot of an element's sources. */
async function taggedIn(files) {
  const found = Object.fromEntries(Object.values(TAGS).map((kind) => [kind, new Map()]));
  for (const path of files) {
    for (const comment of await commentsOf(path)) {
      for (const [, tag, name, description] of comment
        .getText()
        .matchAll(/@(fires|csspart|cssprop|slot) (\S+) - ([^\n]+)/g))
        found[TAGS[tag]].set(name, { name: name === "default" ? "" : name, description: description.trim() });
    }
  }
  return Object.fromEntries(Object.entries(found).map(([kind, entries]) => [kind, [...entries.values()]]));
}

const isMethod = (type) => type.startsWith("(") && type.includes("=>");

/** The declaration of a method, whose parameters and result are parsed from the text of its type. */
function method({ name, type, description }) {
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
    ...(description && { description }),
    parameters: parameters.map(parameter),
    return: { type: { text: result.getText() } },
  };
}

/** The declaration of a class, from its types, its tags and the built class. */
async function completeDeclaration(declaration, { tagName, name, path }, types, built) {
  const { description, members } = documentationOf(types, name);
  const tags = await taggedIn(await importedFiles(path));
  const member = Object.fromEntries(members.map((each) => [each.name, each]));
  const attributes = new Map(
    [...built.observedAttributes].map((attribute) => [attribute, propertyOf(built, attribute, member)]),
  );
  const field = (each) => ({
    kind: "field",
    name: each.name,
    privacy: "public",
    type: { text: each.type },
    ...(each.description && { description: each.description }),
    ...attributeOf(attributes, each.name),
  });
  const attribute = ([attribute, property]) => ({
    name: attribute,
    fieldName: property,
    type: { text: member[property]?.type ?? "string" },
    ...(member[property]?.description && { description: member[property].description }),
  });
  return {
    kind: "class",
    name,
    tagName,
    customElement: true,
    description,
    superclass: { name: "HTMLElement" },
    ...(declaration.formAssociated && { formAssociated: true }),
    attributes: [...attributes].map(attribute),
    members: members.map((each) => (isMethod(each.type) ? method(each) : field(each))),
    ...tags,
  };
}

/** The property of an attribute, usually with the same name in camelCase. */
function propertyOf(built, attribute, member) {
  const [property] = [...built.elementProperties].find(([, options]) => options.attribute === attribute) ?? [attribute];
  const camelCase = property.replace(/-(.)/g, (_, letter) => letter.toUpperCase());
  return member[camelCase] ? camelCase : attribute;
}

function attributeOf(attributes, property) {
  const found = [...attributes].find(([, each]) => each === property);
  return found ? { attribute: found[0] } : {};
}

/** The public members, according to the analyzer, that have no description. */
function undescribed(manifest, { name }, declaration) {
  const classes = Object.fromEntries(
    manifest.modules
      .flatMap(({ declarations }) => declarations)
      .filter(({ kind }) => kind === "class")
      .map((each) => [each.name, each]),
  );
  const ancestors = [];
  for (let at = classes[name]; at; at = classes[at.superclass?.name]) ancestors.push(at);
  const known = new Set(declaration.members.map((each) => each.name));
  const publicMembers = ancestors
    .flatMap(({ members = [] }) => members)
    .filter(
      (each) =>
        !each.static && each.privacy !== "private" && each.privacy !== "protected" && !each.name.startsWith("#"),
    );
  return [
    ...new Set(
      publicMembers.map((each) => each.name).filter((each) => !known.has(each) && !LIFECYCLE_METHODS.has(each)),
    ),
  ];
}

/** Methods that the browser or Lit calls. */
const LIFECYCLE_METHODS = new Set([
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

/** What the analyzer finds in the sources of the elements. It is one of the packages that only tests need. */
async function analysis(elements) {
  const { create, ts: own } = await import("@custom-elements-manifest/analyzer/index.js");
  const files = new Set(
    (await Promise.all(elements.map(({ path }) => importedFiles(path)))).flatMap((set) => [...set]),
  );
  const parsed = async (path) =>
    own.createSourceFile(relative(".", path), await textOf(path), own.ScriptTarget.ES2022, true, own.ScriptKind.TS);
  return create({ modules: await Promise.all([...files].map(parsed)) });
}

async function main() {
  const elements = await elementsOf();
  const types = await declaredTypes();
  const analysed = process.argv.includes("--check") ? await analysis(elements) : undefined;
  globalThis.CSSStyleSheet ??= class {
    replaceSync() {}
  }; // Lit creates style sheets when observedAttributes is read
  const modules = [];
  for (const element of elements) {
    const { name, tagName, module } = element;
    const built = (await import(pathToFileURL(resolve(module)).href))[name];
    const declaration = await completeDeclaration(
      { formAssociated: built.formAssociated === true },
      element,
      types,
      built,
    );
    const missing = analysed ? undescribed(analysed, element, declaration) : [];
    for (const each of missing)
      console.error(`${name}: ${each}: describe it in ${TYPES.join(" or ")}, or mark it @protected or @internal`);
    if (missing.length) process.exitCode = 1;
    const exports = [
      { kind: "js", name, declaration: { name, module } },
      { kind: "custom-element-definition", name: tagName, declaration: { name, module } },
    ];
    modules.push({ kind: "javascript-module", path: module, declarations: [declaration], exports });
  }
  const manifest = {
    schemaVersion: "2.1.0",
    readme: "README.md",
    modules,
  };
  await writeFile("dist/custom-elements.json", `${JSON.stringify(manifest, null, 2)}\n`);
}

await main();
