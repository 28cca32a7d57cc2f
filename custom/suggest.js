// The names of the package that a program uses, found by the types of its expressions.
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";

/** @typedef {import("./module.js").PublicName} PublicName */
/** @typedef {typeof import("typescript-api")} TypeScript */

/** The beginning of a module that this command has made. */
export const GENERATED = "/*! npx casteljau custom ";

/** Whether the nearest package.json above a file is that of this package. @param {string} path @returns {boolean} */
function isOfPackage(path) {
  for (let folder = dirname(path); ; folder = dirname(folder)) {
    const description = join(folder, "package.json");
    if (existsSync(description)) return JSON.parse(readFileSync(description, "utf8")).name === "casteljau";
    if (dirname(folder) === folder) return false;
  }
}

const ENDINGS = [".ts", ".tsx", ".mts", ".cts", ".js", ".jsx", ".mjs", ".cjs"];

/**
 * @param {Record<string, PublicName>} names of the package
 * @param {string} folder with the sources of the program
 * @returns {string[]} names such as "Curve.length", sorted
 * @throws {Error} if TypeScript is not installed there
 */
export function suggestedList(names, folder) {
  const path = resolve(folder);
  if (!existsSync(path)) throw new Error(`--from: expected a folder, got ${folder}`);
  const ts = typescriptAt(path);
  const files = ts.sys.readDirectory(path, ENDINGS, ["**/node_modules"]);
  const program = ts.createProgram(files, compilerOptions(ts, path));
  const own = program
    .getSourceFiles()
    .filter((file) => !file.isDeclarationFile && !/[\\/]node_modules[\\/]/.test(file.fileName));
  return namesIn(names, ts, program, own);
}

/**
 * The names of the package in some files of a program.
 *
 * @param {Record<string, PublicName>} names
 * @param {TypeScript} ts
 * @param {import("typescript-api").Program} program
 * @param {readonly import("typescript-api").SourceFile[]} files
 */
export function namesIn(names, ts, program, files) {
  const checker = program.getTypeChecker();
  /** @type {Set<string>} */
  const found = new Set();
  /** @type {Map<string, boolean>} */
  const known = new Map();
  const isDeclaration = (/** @type {import("typescript-api").SourceFile} */ { fileName, isDeclarationFile }) => {
    if (!known.has(fileName)) known.set(fileName, isDeclarationFile && isOfPackage(fileName));
    return known.get(fileName) === true;
  };
  /** The public name of a class or a function of the package. @param {import("typescript-api").Symbol | undefined} symbol */
  const publicName = (symbol) => {
    const file = symbol?.declarations?.[0]?.getSourceFile();
    if (!file || !(isDeclaration(file) || file.text.startsWith(GENERATED))) return undefined;
    // CoreCurve is the base class of the class Curve of all entry points.
    const name = symbol?.name ?? "";
    return [name, name.replace(/^Core/, "")].find((each) => Object.hasOwn(names, each));
  };
  /** @param {import("typescript-api").Type} type @param {string} member */
  const use = (type, member) => {
    const apparent = checker.getApparentType(checker.getNonNullableType(type));
    for (const each of apparent.isUnionOrIntersection() ? apparent.types : [apparent]) {
      const name = publicName(each.symbol);
      if (name && Object.hasOwn(names[name].members ?? {}, member)) found.add(`${name}.${member}`);
    }
  };
  const visit = (/** @type {import("typescript-api").Node} */ node) => {
    if (ts.isPropertyAccessExpression(node)) use(checker.getTypeAtLocation(node.expression), node.name.text);
    else if (ts.isElementAccessExpression(node) && ts.isStringLiteralLike(node.argumentExpression))
      use(checker.getTypeAtLocation(node.expression), node.argumentExpression.text);
    else if (ts.isObjectBindingPattern(node)) {
      const type = checker.getTypeAtLocation(node);
      for (const { propertyName, name } of node.elements) use(type, (propertyName ?? name).getText());
    } else if (ts.isIdentifier(node)) {
      const symbol = checker.getSymbolAtLocation(node);
      const isImport = symbol && symbol.flags & ts.SymbolFlags.Alias && !ts.isTypeNode(node.parent);
      const name = isImport ? publicName(checker.getAliasedSymbol(symbol)) : undefined;
      if (name && name !== "init") found.add(name);
    }
    ts.forEachChild(node, visit);
  };
  for (const file of files) if (!file.text.startsWith(GENERATED)) visit(file);
  // A class is there with each of its members.
  return [...found].filter((name) => ![...found].some((other) => other.startsWith(`${name}.`))).sort();
}

/** @param {string} folder @returns {TypeScript} */
function typescriptAt(folder) {
  const require = createRequire(join(folder, "index.js"));
  /** @type {any} */
  let ts;
  try {
    ts = require("typescript");
  } catch {}
  if (typeof ts?.createProgram === "function") return ts;
  const got = ts ? `version ${ts.version} without one` : "none";
  throw new Error(`--from: expected TypeScript with a compiler API (npm install --save-dev typescript@6), got ${got}`);
}

/** @param {TypeScript} ts @param {string} folder @returns {import("typescript-api").CompilerOptions} */
function compilerOptions(ts, folder) {
  const path = ts.findConfigFile(folder, (name) => existsSync(name));
  const own = path
    ? ts.parseJsonConfigFileContent(
        ts.readConfigFile(path, (name) => readFileSync(name, "utf8")).config,
        ts.sys,
        dirname(path),
      ).options
    : {};
  return {
    target: ts.ScriptTarget.ESNext,
    module: ts.ModuleKind.ESNext,
    moduleResolution: ts.ModuleResolutionKind.Bundler,
    jsx: ts.JsxEmit.Preserve,
    types: [],
    ...own,
    allowJs: true,
    checkJs: true,
    noEmit: true,
    skipLibCheck: true,
  };
}
