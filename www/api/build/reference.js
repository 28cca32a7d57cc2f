// The model of the reference: one page for each class, with an entry for every public name, from the declarations (extract.js) and the
// texts in www/api/entries (entries.js).
import { elementPages } from "./elements.js";
import { entryFolders, readEntries } from "./entries.js";
import { extract } from "./extract.js";
import { NURBS_NAMES } from "./sample.js";

/**
 * @import { ClassDoc, Member, TypeDoc } from "./extract.js"
 * @import { Entry } from "./entries.js"
 * @typedef {Member & { id: string, entry?: Entry }} Item
 * @typedef {{ slug: string, title: string, summary: string, details: string[], items: Item[] }} Page
 * @typedef {{ pages: Page[], types: TypeDoc[], elements: ReturnType<typeof elementPages> }} Reference
 */

const MODULES = /** @type {const} */ (["index", "nurbs", "applet/index", "geometry/easing"]);

/** @type {Reference | undefined} */
let model;

/** The model, made at the first call. */
export const reference = () => {
  model ??= makeReference();
  return model;
};

/** @returns {Reference} */
function makeReference() {
  const found = extract([...MODULES]);
  const { functions } = found.index;
  const classes = [...found.index.classes, ...found.nurbs.classes.filter(({ name }) => NURBS_NAMES.includes(name))];
  const types = [...found.index.types, ...found.nurbs.types.filter(isMissing(found.index.types))];
  const folders = entryFolders();
  const entries = (/** @type {string} */ folder) => (folders.includes(folder) ? readEntries(folder) : new Map());
  const named = (/** @type {string} */ name) => functions.filter((item) => item.name === name);
  const pages = [
    ...classes.map((item) => classPage(item, entries(item.name.toLowerCase()))),
    {
      slug: "easing",
      title: "easing",
      summary: "CSS timing functions: cubic-bezier(), steps() and linear(), evaluated, read and written.",
      details: [],
      items: items([...named("easing"), ...easingMembers(found["geometry/easing"].types)], entries("easing")),
    },
    {
      slug: "package",
      title: "The package",
      summary: "Loading of the WebAssembly module.",
      details: [],
      items: items(named("init"), entries("package")),
    },
    appletPage(found["applet/index"], entries("applet")),
  ];
  return { pages, types, elements: elementPages() };
}

/** Whether no type of a list has the name of another. @param {TypeDoc[]} types @returns {(type: TypeDoc) => boolean} */
const isMissing = (types) => (type) => !types.some(({ name }) => name === type.name);

/** What `easing` and a timing function have besides being called. @param {TypeDoc[]} types @returns {Member[]} */
function easingMembers(types) {
  const named = ["EasingStatics", "EasingMembers"].map((name) => types.find((type) => type.name === name));
  const fields = named.flatMap((type) => type?.fields ?? []);
  return fields.map(({ name, type, doc }) => {
    const signature = { text: `${name}: ${type}`, parameters: [], result: { type, doc: "" }, throws: [] };
    return { name, kind: "property", summary: doc, details: [], signatures: [signature] };
  });
}

/** @param {ClassDoc} item @param {Map<string, Entry>} entries @returns {Page} */
function classPage(item, entries) {
  return {
    slug: item.name.toLowerCase(),
    title: item.name,
    summary: item.summary,
    details: item.details,
    items: items(item.members, entries),
  };
}

/** @param {{ classes: ClassDoc[], functions: Member[] }} applet @param {Map<string, Entry>} entries @returns {Page} */
function appletPage({ classes, functions }, entries) {
  const members = [...functions, ...classes.flatMap((item) => item.members)];
  const summary = "Two cubic Bézier curves with seven control points to drag, on a canvas.";
  return { slug: "applet", title: "The applet", summary, details: [], items: items(members, entries) };
}

/** @param {Member[]} members @param {Map<string, Entry>} entries @returns {Item[]} */
function items(members, entries) {
  return members.map((member) => {
    const id = member.kind === "constructor" ? "constructor" : member.name;
    return { ...member, id, entry: entries.get(id) };
  });
}
