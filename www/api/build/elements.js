// The custom elements: their attributes, properties, methods, events, slots, parts and CSS properties, from custom-elements.json.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const MANIFEST = fileURLToPath(new URL("../../../dist/custom-elements.json", import.meta.url));

/**
 * @typedef {{ name: string, type: string, doc: string, id: string }} Row
 * @typedef {{ tag: string, summary: string, tables: { title: string, rows: Row[] }[] }} ElementPage
 */

/** @returns {ElementPage[]} */
export function elementPages() {
  const { modules } = JSON.parse(readFileSync(MANIFEST, "utf8"));
  const declarations = modules.flatMap((/** @type {any} */ module) => module.declarations ?? []);
  return declarations.filter((/** @type {any} */ item) => item.tagName).map(elementPage);
}

/** @param {any} item @returns {ElementPage} */
function elementPage(item) {
  const tag = item.tagName;
  const rows = (/** @type {string} */ kind, /** @type {any[]} */ list = []) =>
    list.map((row) => ({
      name: row.name || "(default)",
      type: typeOf(row),
      doc: row.description ?? "",
      id: `${tag}-${kind}-${row.name || "default"}`,
    }));
  const visible = (item.members ?? []).filter(
    (/** @type {any} */ member) => member.privacy === "public" && !member.static,
  );
  const tables = [
    { title: "Attributes", rows: rows("attribute", item.attributes) },
    {
      title: "Properties",
      rows: rows(
        "property",
        visible.filter((/** @type {any} */ m) => m.kind === "field"),
      ),
    },
    {
      title: "Methods",
      rows: rows(
        "method",
        visible.filter((/** @type {any} */ m) => m.kind === "method"),
      ),
    },
    { title: "Events", rows: rows("event", item.events) },
    { title: "Slots", rows: rows("slot", item.slots) },
    { title: "CSS parts", rows: rows("part", item.cssParts) },
    { title: "CSS custom properties", rows: rows("css", item.cssProperties) },
  ];
  return { tag, summary: item.description ?? "", tables: tables.filter((table) => table.rows.length > 0) };
}

/** @param {any} row */
function typeOf(row) {
  if (row.kind !== "method") return row.type?.text ?? "";
  const parameters = (row.parameters ?? []).map(
    (/** @type {any} */ p) => `${p.name}${p.optional ? "?" : ""}: ${p.type?.text ?? "unknown"}`,
  );
  return `(${parameters.join(", ")}): ${row.return?.type?.text ?? "void"}`;
}
