#!/usr/bin/env node
// The command `npx casteljau custom`, which writes a module with some of the package's methods.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";
import { checkedList } from "./list.js";
import { customModule, sourceOf } from "./module.js";
import { GENERATED, suggestedList } from "./suggest.js";

const USAGE = `npx casteljau custom NAME … --out FILE

Writes an ES module with only the named methods, and what they need, and its types (.d.ts).

  NAME           a method (Curve.length, Path.fromSVG), a class with its constructor only (Curve), all methods of a class
                 ('Curve.*'), or a function (easing)
  --out FILE     the module, ending in .js or .mjs
  --list FILE    names from a file, separated by spaces and line ends; # starts a comment
  --from FOLDER  the names that the program in a folder uses, found with its own TypeScript; without --out they are printed

  npx casteljau custom Curve.length Path.fromSVG Path.pointAtLength --out src/bezier.js`;

/** With more names, it takes too long to make a module without each of them. */
const MAX_MEASURED = 40;
const MAX_SHOWN = 5;

/** @param {string} name @returns {Buffer} */
const file = (name) => readFileSync(new URL(name, import.meta.url));
/** @param {string} name @returns {any} */
const json = (name) => JSON.parse(file(name).toString());
/** @param {string | Uint8Array} data */
const gzip = (data) => gzipSync(data, { level: 9 }).length;
/** @param {number} bytes */
const kB = (bytes) => `${(bytes / 1000).toFixed(1)} kB`;
/** A word of the command, quoted if a shell would change it. @param {string} word */
const quoted = (word) => (/^[\w./:@\\-]+$/.test(word) ? word : `'${word}'`);

/** @param {string[]} args */
function run(args) {
  const [command, ...rest] = args;
  if (command === undefined || args.includes("--help") || command === "help") return void console.log(USAGE);
  if (command !== "custom") throw new RangeError(`expected the command custom, got ${command}`);
  const { values, positionals } = parseArgs({
    args: rest,
    allowPositionals: true,
    options: { out: { type: "string" }, list: { type: "string" }, from: { type: "string" } },
  });
  const pieces = json("pieces.json");
  const words = [
    ...positionals,
    ...(values.list === undefined ? [] : wordsOf(values.list)),
    ...(values.from === undefined ? [] : suggestedList(pieces.names, values.from)),
  ];
  const list = checkedList(pieces.names, words, pieces.nurbs);
  if (list.length === 0) throw new RangeError(`expected names such as Curve.length, got none\n\n${USAGE}`);
  const { out } = values;
  // What was found is listed, so that the module does not depend on the sources.
  const repeated = values.from === undefined ? positionals : [...new Set([...positionals, ...words])];
  const named = [...repeated.map(quoted), ...(values.list === undefined ? [] : ["--list", quoted(values.list)])].join(
    " ",
  );
  if (out === undefined) {
    if (values.from === undefined) throw new RangeError("--out: expected a file for the module, got none");
    return void console.log(`npx casteljau custom ${named} --out ${quoted("src/bezier.js")}`);
  }
  const types = typesFile(out);
  if (existsSync(out) && !readFileSync(out, "utf8").startsWith(GENERATED))
    throw new RangeError(`--out: expected a new file, or one that this command has made, got ${out}`);
  const source = sourceOf(pieces, json("needs.json"), file("../casteljau.wasm"));
  const make = (/** @type {readonly string[]} */ some) =>
    customModule(source, some, `npx casteljau custom ${named} --out ${quoted(out)}`);
  const result = make(list);
  mkdirSync(dirname(out), { recursive: true });
  writeFileSync(out, result.code);
  writeFileSync(types, result.types);
  const size = gzip(result.code);
  console.log(`${out}: ${kB(Buffer.byteLength(result.code))}, ${kB(size)} with gzip; types: ${types}`);
  if (list.length < 2 || list.length > MAX_MEASURED) return;
  const shares = list
    .map((name) => ({ name, bytes: size - gzip(make(list.filter((other) => other !== name)).code) }))
    .sort((a, b) => b.bytes - a.bytes)
    .slice(0, MAX_SHOWN);
  console.log("With gzip, it would be smaller without");
  for (const { name, bytes } of shares) console.log(`  ${name.padEnd(28)}${kB(bytes).padStart(9)}`);
}

/** @param {string} path */
function wordsOf(path) {
  if (!existsSync(path)) throw new RangeError(`--list: expected a file, got ${path}`);
  return readFileSync(path, "utf8")
    .replace(/#.*$/gm, "")
    .split(/\s+/)
    .filter((word) => word !== "");
}

/** The file of the declarations of a module. @param {string} out */
function typesFile(out) {
  const [, name, letter] = /^(.*)\.(m?)js$/.exec(out) ?? [];
  if (name === undefined) throw new RangeError(`--out: expected a file that ends in .js or .mjs, got ${out}`);
  return `${name}.d.${letter}ts`;
}

try {
  run(process.argv.slice(2));
} catch (error) {
  console.error(`casteljau: ${/** @type {Error} */ (error).message}`);
  process.exitCode = 1;
}
