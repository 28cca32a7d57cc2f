// Writes dist/custom: the command `casteljau custom`, and pieces.json, of which it makes modules with some of the package's
// methods. A piece is a declaration at the top level, or a member of a class; it has its minified text and what it
// refers to. Members are found by types, so `points.length` is no reference to the method `length` of curves. Called by
// scripts/build.js after the types are built; runs from the repository's root.
import { build, transform } from "esbuild";
import { copyFile, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { relative, resolve, sep } from "node:path";
import ts from "typescript-api";
import { Module } from "../custom/cut.js";

/** @typedef {import("../custom/module.js").Piece} Piece */
/** @typedef {import("../custom/module.js").Pieces} Pieces */

/** The interface whose functions are the exports of the wasm module. */
const GLUE = resolve("js/glue/casteljau.d.ts");
const MODULE_FILE = /[\\/]js[\\/]wasm[\\/](curves|surfaces|regions)-module\.ts$/;
/** The names under which custom/module.js defines the wasm module as text and the functions that it imports. */
const WASM_TEXT = "$wasm";
const WASM_IMPORTS = "$imports";

const glue = await readFile("js/glue/casteljau.js", "utf8");
/** The wasm module: that all of its instructions are known to custom/cut.js shows here. */
const wasm = new Module(await readFile("js/glue/casteljau.wasm"));

/** A file that exists only here; see `linkSource`. */
const LINK_FILE = resolve("js/glue/link.ts");

/**
 * The source of a file of js/, with three changes: there is one wasm module, Node shows no contents of values (which would need
 * `toJSON` and `toSVG` everywhere), and lists of constants are single ones.
 *
 * @param {string} path
 * @param {string | undefined} text
 */
function sourceOf(path, text) {
  if (path === LINK_FILE) return linkSource();
  const [, name] = MODULE_FILE.exec(path) ?? [];
  if (name === "curves")
    return `import { registerModule } from "./wasm-module.js"; import { link } from "../glue/link.js";
      declare const ${WASM_TEXT}: any;
      export const curvesModule = registerModule(link, ${WASM_TEXT});`;
  if (name) return `export { curvesModule as ${name}Module } from "./curves-module.js";`;
  return text
    ?.replace(/^ *if \(!isShown\) show\(\);$/m, "")
    .replace(/^const \[([\w, ]+)\] = \[([^\]]*)\];$/gm, (_, names, values) => {
      const numbers = values.split(", ");
      return names
        .split(", ")
        .map((/** @type {string} */ each, /** @type {number} */ k) => `const ${each} = ${numbers[k]};`)
        .join(" ");
    });
}

/** The part of wasm-bindgen's glue that the imports use, and a linker. */
function linkSource() {
  const helpers = glue.slice(glue.indexOf("function getArray"), glue.indexOf("let wasmModule,"));
  return `// @ts-nocheck
    declare const ${WASM_IMPORTS}: any;
    let wasm: any;
    export function link({ module }: { module: WebAssembly.Module }) {
      wasm = new WebAssembly.Instance(module, ${WASM_IMPORTS}).exports;
      wasm.__wbindgen_start?.();
      return wasm;
    }
    ${helpers}
    ${importFunctions()
      .map(({ name, text }) => `export const import_${name} = ${text};`)
      .join("\n")}`;
}

/** The functions that the wasm module imports. */
function importFunctions() {
  const file = ts.createSourceFile("glue.js", glue, ts.ScriptTarget.ES2022, true);
  /** @type {{ name: string, text: string }[]} */
  const found = [];
  const visit = (/** @type {ts.Node} */ node) => {
    if (ts.isVariableDeclaration(node) && node.name.getText() === "import0" && node.initializer) {
      for (const property of /** @type {ts.ObjectLiteralExpression} */ (node.initializer).properties)
        if (ts.isPropertyAssignment(property) && ts.isFunctionExpression(property.initializer))
          found.push({ name: property.name.getText(), text: property.initializer.getText() });
    } else ts.forEachChild(node, visit);
  };
  visit(file);
  return found;
}

const isSource = (/** @type {string} */ path) =>
  resolve(path).startsWith(resolve("js") + sep) && path.endsWith(".ts") && !path.endsWith(".d.ts");

/** @param {string} entry @param {ts.CompilerOptions} options */
function createProgram(entry, options) {
  const host = ts.createCompilerHost(options);
  const { fileExists, readFile: read } = host;
  host.fileExists = (path) => resolve(path) === LINK_FILE || fileExists(path);
  host.readFile = (path) => (isSource(path) ? sourceOf(resolve(path), read(path)) : read(path));
  host.getSourceFile = (path, version) => {
    const text = host.readFile(path);
    return text === undefined ? undefined : ts.createSourceFile(path, text, version, true);
  };
  return ts.createProgram([entry], options, host);
}

const { options } = ts.parseJsonConfigFileContent(
  ts.readConfigFile("tsconfig.json", ts.sys.readFile).config,
  ts.sys,
  resolve("."),
);

/**
 * The source files that a file imports, directly and indirectly, in the order in which they are evaluated.
 *
 * @param {ts.Program} program
 * @param {string} entry
 * @param {boolean} types whether imports of types count
 */
function modulesOf(program, entry, types) {
  const checker = program.getTypeChecker();
  /** @type {Set<ts.SourceFile>} */
  const visited = new Set();
  /** @type {ts.SourceFile[]} */
  const order = [];
  const visit = (/** @type {ts.SourceFile} */ file) => {
    if (visited.has(file)) return;
    visited.add(file);
    for (const statement of file.statements) {
      if (!ts.isImportDeclaration(statement) && !ts.isExportDeclaration(statement)) continue;
      const isType = ts.isImportDeclaration(statement)
        ? statement.importClause?.phaseModifier === ts.SyntaxKind.TypeKeyword
        : statement.isTypeOnly;
      if (!statement.moduleSpecifier || (isType && !types)) continue;
      const imported = checker.getSymbolAtLocation(statement.moduleSpecifier)?.declarations?.[0];
      if (imported && ts.isSourceFile(imported)) visit(imported);
    }
    order.push(file);
  };
  const file = program.getSourceFile(entry);
  if (!file) throw new Error(`expected ${entry}`);
  visit(file);
  return order;
}

/** @param {ts.Node} node */
const placeOf = (node) => {
  const file = node.getSourceFile();
  const { line } = file.getLineAndCharacterOfPosition(node.getStart());
  return `${relative(".", file.fileName).split(sep).join("/")}:${line + 1}`;
};

/** Names for declarations at the top level: short ones, none of them a word of the language. */
function* shortNames() {
  const letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  const rest = `${letters}0123456789`;
  for (let length = 1; ; length++) {
    const count = letters.length * rest.length ** (length - 1);
    for (let k = 0; k < count; k++) {
      let [name, left] = [letters[k % letters.length], Math.floor(k / letters.length)];
      for (let i = 1; i < length; i++, left = Math.floor(left / rest.length)) name += rest[left % rest.length];
      if (!/^(as|do|if|in|is|of|for|let|new|try|var)$/.test(name)) yield name;
    }
  }
}

/**
 * A declaration in the sources.
 *
 * @typedef {{ node: ts.Statement | ts.VariableDeclaration, name: string, members: ts.ClassElement[], first: number }} Declaration
 */

/** The members of a class that exist in JavaScript. @param {ts.ClassDeclaration} node */
const membersOf = (node) =>
  node.members.filter(
    (member) =>
      ts.isPropertyDeclaration(member) ||
      ((ts.isMethodDeclaration(member) || ts.isConstructorDeclaration(member) || ts.isAccessor(member)) && member.body),
  );

/** @param {ts.Node} node */
const isInternal = (node) => ts.getJSDocTags(node).some(({ tagName }) => tagName.text === "internal");
/** @param {ts.ClassElement} member */
const isStatic = (member) => (ts.getCombinedModifierFlags(member) & ts.ModifierFlags.Static) !== 0;
/** @param {ts.ClassElement} member */
const isPublic = (member) =>
  member.name !== undefined && ts.isIdentifier(member.name) && !member.name.text.startsWith("_") && !isInternal(member);

/** The pieces of JavaScript. @returns {Promise<Pick<Pieces, "pieces" | "names" | "imports">>} */
async function pieces() {
  const entry = resolve("js/index.ts");
  const program = createProgram(entry, options);
  const checker = program.getTypeChecker();
  const modules = modulesOf(program, entry, false);
  /** The index of the piece of each declaration: of functions, classes, variables and members. @type {Map<ts.Node, number>} */
  const indices = new Map();
  /** @type {Declaration[]} */
  const declarations = [];
  let count = 0;
  const declare = (/** @type {Declaration["node"]} */ node, /** @type {ts.Node | undefined} */ name) => {
    if (!name || !ts.isIdentifier(name)) throw new Error(`${placeOf(node)}: expected a declaration with a name`);
    const members = ts.isClassDeclaration(node) ? membersOf(node) : [];
    declarations.push({ node, name: name.text, members, first: count });
    indices.set(node, count++);
    for (const member of members) indices.set(member, count++);
  };
  for (const file of modules)
    for (const statement of file.statements) {
      if (ts.isFunctionDeclaration(statement) && !statement.body) continue; // a signature
      if (ts.isFunctionDeclaration(statement) || ts.isClassDeclaration(statement)) declare(statement, statement.name);
      else if (ts.isVariableStatement(statement)) {
        if (ts.getCombinedModifierFlags(statement.declarationList.declarations[0]) & ts.ModifierFlags.Ambient) continue;
        for (const each of statement.declarationList.declarations) declare(each, each.name);
      } else if (
        ![
          ts.SyntaxKind.ImportDeclaration,
          ts.SyntaxKind.ExportDeclaration,
          ts.SyntaxKind.InterfaceDeclaration,
          ts.SyntaxKind.TypeAliasDeclaration,
        ].includes(statement.kind)
      )
        throw new Error(`${placeOf(statement)}: expected a declaration without effects`);
    }
  // Signatures of overloaded functions and methods stand for their implementations.
  for (const { node, members } of declarations) {
    const all = /** @type {ts.Node[]} */ ([node, ...members]).flatMap((each) =>
      (checker.getSymbolAtLocation(/** @type {any} */ (each).name ?? each)?.declarations ?? []).map((signature) => ({
        signature,
        each,
      })),
    );
    for (const { signature, each } of all)
      if (!indices.has(signature)) indices.set(signature, /** @type {number} */ (indices.get(each)));
  }
  const classes = declarations.filter(({ node }) => ts.isClassDeclaration(node));
  const exported = checker.getExportsOfModule(
    /** @type {ts.Symbol} */ (checker.getSymbolAtLocation(/** @type {ts.SourceFile} */ (program.getSourceFile(entry)))),
  );
  /** The value of a symbol: what an import stands for. @param {ts.Symbol | undefined} symbol */
  const original = (symbol) =>
    symbol && symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol;
  const pieceOf = (/** @type {ts.Symbol | undefined} */ symbol) => {
    const found = original(symbol)?.declarations?.find((each) => indices.has(each));
    return found && indices.get(found);
  };
  /** The names at the top level. @type {Map<number, string>} */
  const names = new Map();
  for (const symbol of exported) {
    const index = pieceOf(symbol);
    const value = original(symbol);
    if (index !== undefined && value && value.flags & ts.SymbolFlags.Value && !isTypeOnly(symbol))
      names.set(index, symbol.name);
  }
  const publicNames = new Map(names);
  const short = shortNames();
  for (const { first } of declarations) if (!names.has(first)) names.set(first, short.next().value ?? "");

  if (!program.getSourceFile(GLUE)) throw new Error(`expected ${GLUE}`);
  const wasmNames = new Set(wasm.exports.map(({ name }) => name));

  /** The members of classes with a name. @type {Map<string, { declaration: Declaration, member: ts.ClassElement }[]>} */
  const byName = new Map();
  for (const declaration of classes)
    for (const member of declaration.members) {
      const name = member.name?.getText();
      if (name) byName.set(name, [...(byName.get(name) ?? []), { declaration, member }]);
    }
  /** The names of all members of a class, also of inherited ones. @param {Declaration} declaration @returns {Set<string>} */
  const memberNames = (declaration) => {
    const type = checker.getTypeAtLocation(declaration.node);
    return new Set(type.getProperties().map(({ name }) => name));
  };

  /**
   * What a node refers to, and the edits that give names at the top level their new ones.
   *
   * @param {ts.Node} root a declaration or a member
   * @param {readonly ts.Node[]} [parts] by default all but its name
   */
  function analyse(root, parts) {
    /** @type {Set<number>} */
    const refs = new Set();
    /** Members that are called on `super`: not those of subclasses. @type {Set<number>} */
    const direct = new Set();
    /** @type {Set<string>} */
    const exports = new Set();
    /** @type {{ from: number, to: number, text: string }[]} */
    const edits = [];
    const edit = (/** @type {ts.Node} */ node, /** @type {string} */ text) =>
      edits.push({ from: node.getStart(), to: node.end, text });
    const refer = (/** @type {number} */ index) => {
      refs.add(index);
      return names.get(index) ?? "";
    };
    /** @param {ts.Symbol | undefined} symbol @param {string} name @param {ts.Type} type @param {ts.Node} at @param {boolean} isSuper */
    const referToMember = (symbol, name, type, at, isSuper) => {
      const found = (symbol?.declarations ?? []).flatMap((each) => indices.get(each) ?? []);
      for (const index of found) (isSuper ? direct : refs).add(index);
      if (found.length > 0) return;
      const declaration = symbol?.declarations?.[0];
      if (declaration?.getSourceFile().fileName === GLUE) {
        exports.add(name);
        return;
      }
      const namesakes = byName.get(name) ?? [];
      if (!declaration) {
        if (wasmNames.has(name)) exports.add(name);
        if (!(type.flags & (ts.TypeFlags.Any | ts.TypeFlags.Unknown))) return;
        const isCalled = ts.isCallExpression(at.parent) && at.parent.expression === at;
        for (const { member } of namesakes) {
          if (ts.isMethodDeclaration(member) && !isCalled) continue;
          refs.add(/** @type {number} */ (indices.get(member)));
        }
        return;
      }
      // A member of an interface: of all classes that have the members of the interface, with a method for a function.
      const valueType = checker.getNonNullableType(checker.getTypeOfSymbol(/** @type {ts.Symbol} */ (symbol)));
      const isMethod = valueType.getCallSignatures().length > 0;
      const owner = declaration.parent;
      if (!(ts.isInterfaceDeclaration(owner) || ts.isTypeLiteralNode(owner)) || isLibrary(owner)) return;
      const wanted = owner.members.flatMap((each) => (each.name && !each.questionToken ? [each.name.getText()] : []));
      for (const { declaration: owning, member } of namesakes) {
        if (ts.isMethodDeclaration(member) !== isMethod) continue;
        const subclasses = classes.filter(({ node }) => extendsClass(node, owning.node));
        if (![owning, ...subclasses].some((each) => wanted.every((word) => memberNames(each).has(word)))) continue;
        refs.add(/** @type {number} */ (indices.get(member)));
      }
    };
    const visit = (/** @type {ts.Node} */ node) => {
      if (ts.isExpressionWithTypeArguments(node)) {
        const clause = node.parent;
        if (ts.isHeritageClause(clause) && clause.token === ts.SyntaxKind.ImplementsKeyword) return;
        visit(node.expression);
        return;
      }
      if (ts.isTypeNode(node) || ts.isTypeParameterDeclaration(node)) return;
      if (ts.isPropertyAccessExpression(node)) {
        const { expression } = node;
        const symbol = checker.getSymbolAtLocation(node.name);
        if (ts.isIdentifier(expression) && isNamespace(checker.getSymbolAtLocation(expression))) {
          const index = pieceOf(symbol);
          if (index === undefined) throw new Error(`${placeOf(node)}: expected a function of this package`);
          edit(node, refer(index));
          return;
        }
        const isSuper = expression.kind === ts.SyntaxKind.SuperKeyword;
        referToMember(symbol, node.name.text, checker.getTypeAtLocation(expression), node, isSuper);
        visit(expression);
        return;
      }
      if (ts.isElementAccessExpression(node) && ts.isStringLiteral(node.argumentExpression)) {
        const type = checker.getTypeAtLocation(node.expression);
        const name = node.argumentExpression.text;
        referToMember(checker.getPropertyOfType(type, name), name, type, node, false);
      }
      if (ts.isObjectBindingPattern(node)) {
        const type = checker.getTypeAtLocation(node);
        for (const element of node.elements) {
          const name = (element.propertyName ?? element.name).getText();
          if (!element.dotDotDotToken) referToMember(checker.getPropertyOfType(type, name), name, type, element, false);
        }
      }
      if (ts.isShorthandPropertyAssignment(node)) {
        const index = pieceOf(checker.getShorthandAssignmentValueSymbol(node));
        if (index !== undefined) edit(node.name, `${node.name.text}: ${refer(index)}`);
        if (node.objectAssignmentInitializer) visit(node.objectAssignmentInitializer);
        return;
      }
      if (ts.isIdentifier(node)) {
        if (isPropertyName(node)) return;
        const symbol = checker.getSymbolAtLocation(node);
        if (isNamespace(symbol)) throw new Error(`${placeOf(node)}: expected a member of the namespace`);
        const index = pieceOf(symbol);
        if (index !== undefined) edit(node, refer(index));
        return;
      }
      ts.forEachChild(node, visit);
    };
    if (parts) parts.forEach(visit);
    else
      ts.forEachChild(root, (child) => {
        if (child !== /** @type {any} */ (root).name) visit(child);
      });
    return { refs, direct, exports, edits };
  }

  const isNamespace = (/** @type {ts.Symbol | undefined} */ symbol) =>
    symbol?.declarations?.some((each) => ts.isNamespaceImport(each)) ?? false;
  /** @param {ts.Node} node */
  const isLibrary = (node) => program.isSourceFileDefaultLibrary(node.getSourceFile());
  /** @param {ts.Node} node @param {ts.Node} base */
  const extendsClass = (node, base) => {
    for (let each = baseOf(node); each; each = baseOf(each)) if (each === base) return true;
    return false;
  };
  /** What a class extends. @param {ts.ClassDeclaration} node */
  const extended = (node) =>
    node.heritageClauses?.find(({ token }) => token === ts.SyntaxKind.ExtendsKeyword)?.types[0];
  /** @param {ts.Node} node */
  const baseOf = (node) => {
    const expression = ts.isClassDeclaration(node) ? extended(node)?.expression : undefined;
    return expression && original(checker.getSymbolAtLocation(expression))?.declarations?.find(ts.isClassDeclaration);
  };

  /** Classes that are public, but not by their names: what makes them gives all of their members, too. */
  const whole = new Set(
    exported.flatMap((symbol) => {
      const index = pieceOf(symbol);
      return index === undefined || publicNames.has(index) ? [] : [index];
    }),
  );

  /** @type {Piece[]} */
  const result = [];
  await Promise.all(
    declarations.map(async ({ node, members, first }) => {
      const name = /** @type {string} */ (names.get(first));
      const found = analyse(node);
      const named = /** @type {ts.Identifier} */ (/** @type {any} */ (node).name);
      const edits = [...found.edits, { from: named.getStart(), to: named.end, text: name }];
      const text = withEdits(node, edits).replace(/^export /, "");
      const prefix = ts.isVariableDeclaration(node) ? `${keywordOf(node)} ` : "";
      const code = (await minified(prefix + text, placeOf(node))).trim();
      if (!ts.isClassDeclaration(node)) {
        result[first] = pieceWith(code, found);
        return;
      }
      const file = ts.createSourceFile("class.js", code, ts.ScriptTarget.ES2022, true);
      const printed = /** @type {ts.ClassDeclaration} */ (file.statements[0]);
      const base = baseOf(node);
      const head = analyse(
        node,
        base ? [/** @type {ts.ExpressionWithTypeArguments} */ (extended(node)).expression] : [],
      );
      result[first] = {
        ...pieceWith(code.slice(0, code.indexOf("{") + 1), head),
        members: members.map((_, k) => first + 1 + k),
        ...(base ? { base: indices.get(base) } : {}),
      };
      if (printed.members.length !== members.length)
        throw new Error(`${placeOf(node)}: expected ${members.length} members, got ${printed.members.length}`);
      members.forEach((member, k) => {
        const shown = printed.members[k];
        const semicolon = ts.isPropertyDeclaration(shown) && !shown.getText().endsWith(";") ? ";" : "";
        const overridden = overriddenBy(member, base);
        result[first + 1 + k] = {
          ...pieceWith(shown.getText() + semicolon, analyse(member)),
          of: first,
          ...(ts.isConstructorDeclaration(member) || (whole.has(first) && isPublic(member)) ? { always: true } : {}),
          ...(overridden.length > 0 ? { overrides: overridden } : {}),
        };
      });
    }),
  );

  /** The members of base classes that a member overrides. @param {ts.ClassElement} member @param {ts.ClassDeclaration | undefined} base */
  function overriddenBy(member, base) {
    /** @type {number[]} */
    const overridden = [];
    for (let each = base; each && member.name; each = baseOf(each))
      for (const other of membersOf(each))
        if (other.name?.getText() === member.name.getText() && isStatic(other) === isStatic(member))
          overridden.push(/** @type {number} */ (indices.get(other)));
    return overridden;
  }

  /** @type {Pieces["names"]} */
  const publicList = {};
  for (const [index, name] of publicNames) {
    const declaration = classes.find(({ first }) => first === index);
    publicList[name] = { piece: index };
    if (!declaration) continue;
    /** @type {Record<string, number[]>} */
    const members = {};
    for (let each = /** @type {ts.ClassDeclaration | undefined} */ (declaration.node); each; each = baseOf(each)) {
      /** @type {Map<string, number[]>} */
      const own = new Map();
      for (const member of membersOf(each).filter(isPublic)) {
        const word = member.name?.getText() ?? "";
        own.set(word, [...(own.get(word) ?? []), /** @type {number} */ (indices.get(member))]);
      }
      for (const [word, list] of own) members[word] ??= list;
    }
    /** @type {string[]} */
    const statics = Object.entries(members).flatMap(([word, list]) =>
      list.some((k) => result[k].text.startsWith("static ")) ? [word] : [],
    );
    publicList[name] = { piece: index, members, statics };
  }
  const imports = Object.fromEntries(
    importFunctions().map(({ name }) => {
      const declaration = declarations.find((each) => each.name === `import_${name}`);
      if (!declaration) throw new Error(`expected the import ${name}`);
      return [name, { piece: declaration.first, name: names.get(declaration.first) ?? "" }];
    }),
  );
  return { pieces: result, names: publicList, imports };
}

/** @param {string} code @param {{ refs: Set<number>, direct: Set<number>, exports: Set<string> }} found @returns {Piece} */
const pieceWith = (code, { refs, direct, exports }) => ({
  text: code,
  refs: [...refs].sort((a, b) => a - b),
  ...(direct.size > 0 ? { direct: [...direct] } : {}),
  ...(exports.size > 0 ? { exports: [...exports] } : {}),
});

/** @param {ts.VariableDeclaration} node */
const keywordOf = (node) => (node.parent.flags & ts.NodeFlags.Const ? "const" : "let");

/** Whether a symbol is exported by `export type`. @param {ts.Symbol} symbol */
const isTypeOnly = (symbol) => symbol.declarations?.some((each) => ts.isTypeOnlyExportDeclaration(each)) ?? false;

/** Whether an identifier is the name of a property, a member or a label, not a reference. @param {ts.Identifier} node */
function isPropertyName(node) {
  const { parent } = node;
  return (
    (ts.isPropertyAssignment(parent) && parent.name === node) ||
    (ts.isBindingElement(parent) && parent.propertyName === node) ||
    (ts.isMethodDeclaration(parent) && parent.name === node) ||
    (ts.isAccessor(parent) && parent.name === node) ||
    (ts.isPropertyDeclaration(parent) && parent.name === node)
  );
}

/** @param {ts.Node} node @param {{ from: number, to: number, text: string }[]} edits */
function withEdits(node, edits) {
  const source = node.getSourceFile().text;
  let [text, at] = ["", node.getStart()];
  for (const edit of [...edits].sort((a, b) => a.from - b.from)) {
    if (edit.from < at) continue; // the name of a class that is found twice
    text += source.slice(at, edit.from) + edit.text;
    at = edit.to;
  }
  return text + source.slice(at, node.end);
}

/** @param {string} code @param {string} place */
async function minified(code, place) {
  try {
    const options = {
      loader: /** @type {const} */ ("ts"),
      minify: true,
      target: "es2022",
      charset: /** @type {const} */ ("utf8"),
    };
    return (await transform(code, options)).code;
  } catch (cause) {
    throw new Error(`${place}: expected TypeScript, got ${code}`, { cause });
  }
}

/** The pieces of the declarations. @returns {Pieces["types"]} */
function typePieces() {
  const entry = resolve("dist/types/index.d.ts");
  const program = ts.createProgram([entry], { ...options, noEmit: true, rootDir: undefined });
  const checker = program.getTypeChecker();
  /** @type {Map<ts.Node, number>} */
  const indices = new Map();
  /** @type {{ node: ts.DeclarationStatement | ts.VariableDeclaration, statement: ts.Statement, name: string, first: number }[]} */
  const declarations = [];
  /** @type {Map<string, number>} */
  const counts = new Map();
  let count = 0;
  /** @param {any} node @param {ts.Statement} statement */
  const declare = (node, statement) => {
    const word = node.name.text;
    const used = (counts.get(word) ?? 0) + (indices.has(node) ? 0 : 1);
    counts.set(word, used);
    declarations.push({ node, statement, name: used === 1 ? word : `${word}${used}`, first: count });
    indices.set(node, count++);
    if (ts.isClassDeclaration(node)) for (const member of node.members) indices.set(member, count++);
  };
  const modules = modulesOf(program, entry, true);
  // The names that the package exports stay as they are.
  const exported = checker.getExportsOfModule(
    /** @type {ts.Symbol} */ (checker.getSymbolAtLocation(/** @type {ts.SourceFile} */ (program.getSourceFile(entry)))),
  );
  const original = (/** @type {ts.Symbol | undefined} */ symbol) =>
    symbol && symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol;
  for (const file of modules)
    for (const statement of file.statements)
      if (ts.isVariableStatement(statement))
        for (const each of statement.declarationList.declarations) declare(each, statement);
      else if (!ts.isImportDeclaration(statement) && !ts.isExportDeclaration(statement)) declare(statement, statement);
  const pieceOf = (/** @type {ts.Symbol | undefined} */ symbol) => {
    const found = original(symbol)?.declarations?.find((each) => indices.has(each));
    return found && indices.get(found);
  };
  const names = new Map(declarations.map(({ first, name }) => [first, name]));

  /** @param {ts.Node} root @param {readonly ts.Node[]} [parts] */
  function analyse(root, parts) {
    /** @type {Set<number>} */
    const refs = new Set();
    /** @type {{ from: number, to: number, text: string }[]} */
    const edits = [];
    const visit = (/** @type {ts.Node} */ node) => {
      if (ts.isImportTypeNode(node) || ts.isQualifiedName(node)) {
        const name = ts.isImportTypeNode(node) ? node.qualifier : node.right;
        const index = name && pieceOf(checker.getSymbolAtLocation(name));
        if (index === undefined && ts.isQualifiedName(node)) return; // WebAssembly.Module
        if (index === undefined) throw new Error(`${placeOf(node)}: expected a type of this package`);
        refs.add(index);
        const argumentsAt = ts.isImportTypeNode(node) ? node.typeArguments : undefined;
        edits.push({
          from: node.getStart(),
          to: argumentsAt ? argumentsAt.pos - 1 : node.end,
          text: names.get(index) ?? "",
        });
        argumentsAt?.forEach(visit);
        return;
      }
      if (ts.isIndexedAccessTypeNode(node) && ts.isLiteralTypeNode(node.indexType)) {
        const name = ts.isStringLiteral(node.indexType.literal) ? node.indexType.literal.text : "";
        const property = checker.getPropertyOfType(checker.getTypeAtLocation(node.objectType), name);
        for (const each of property?.declarations ?? []) {
          const index = indices.get(each);
          if (index !== undefined) refs.add(index);
        }
      }
      if (ts.isIdentifier(node)) {
        const index = pieceOf(checker.getSymbolAtLocation(node));
        const isName = /** @type {any} */ (node.parent).name === node;
        if (index === undefined || (isName && !indices.has(node.parent))) return;
        if (isName && ts.isClassElement(node.parent)) return;
        if (!isName) refs.add(index);
        const name = names.get(index);
        if (name && name !== node.text) edits.push({ from: node.getStart(), to: node.end, text: name });
        return;
      }
      ts.forEachChild(node, visit);
    };
    if (parts) parts.forEach(visit);
    else ts.forEachChild(root, visit);
    return { refs: [...refs].sort((a, b) => a - b), edits };
  }

  /** @param {ts.Node} node @param {number} end @param {{ from: number, to: number, text: string }[]} edits */
  const textOf = (node, end, edits) => {
    const source = node.getSourceFile().text;
    let [text, at] = ["", node.getStart(undefined, true)];
    for (const edit of [...edits].sort((a, b) => a.from - b.from)) {
      text += source.slice(at, edit.from) + edit.text;
      at = edit.to;
    }
    return (text + source.slice(at, end)).replace(/^export (?=declare|type|interface)/m, "");
  };

  /** @type {import("../custom/module.js").TypePiece[]} */
  const result = [];
  for (const { node, statement, first } of declarations) {
    if (!ts.isClassDeclaration(node)) {
      const { refs, edits } = analyse(statement);
      result[first] = { text: textOf(statement, statement.end, edits), refs };
      continue;
    }
    const brace = node.members.pos;
    const head = analyse(node, [
      .../** @type {ts.Node[]} */ (node.name ? [node.name] : []),
      ...(node.typeParameters ?? []),
      ...(node.heritageClauses ?? []),
    ]);
    const [extended] = node.heritageClauses ?? [];
    const base = extended && pieceOf(checker.getSymbolAtLocation(extended.types[0].expression));
    result[first] = {
      text: textOf(node, brace, head.edits),
      refs: head.refs.filter((index) => index !== first),
      members: node.members.map((_, k) => first + 1 + k),
      ...(base === undefined ? {} : { base }),
    };
    node.members.forEach((member, k) => {
      const { refs, edits } = analyse(member);
      const name = member.name?.getText();
      const word = ts.isConstructorDeclaration(member) ? "constructor" : name?.startsWith("#") ? undefined : name;
      result[first + 1 + k] = {
        text: textOf(member, member.end, edits),
        refs,
        of: first,
        ...(word ? { member: word } : {}),
      };
    });
  }
  /** @type {Record<string, number>} */
  const publicNames = {};
  for (const symbol of exported) {
    const index = pieceOf(symbol);
    if (index === undefined) throw new Error(`expected a declaration of ${symbol.name}`);
    publicNames[symbol.name] = index;
    if (names.get(index) !== symbol.name) throw new Error(`${symbol.name}: expected one declaration of this name`);
  }
  return { pieces: result, names: publicNames };
}

const { version, license } = JSON.parse(await readFile("package.json", "utf8"));
await rm("dist/custom", { recursive: true, force: true });
await mkdir("dist/custom", { recursive: true });
const main = await pieces();
/** The classes of casteljau/nurbs that `casteljau` does not have: they have a module of their own. */
const nurbs = [...(await readFile("js/nurbs.ts", "utf8")).matchAll(/^export \{([^}]*)\}/gm)]
  .flatMap(([, list]) => list.split(",").map((each) => each.trim().split(" as ").at(-1) ?? ""))
  .filter((name) => name && !(name in main.names));
await writeFile("dist/custom/pieces.json", JSON.stringify({ version, license, ...main, nurbs, types: typePieces() }));
await copyFile("js/glue/needs.json", "dist/custom/needs.json");
await build({
  entryPoints: ["custom/command.js"],
  outdir: "dist/custom",
  bundle: true,
  format: "esm",
  platform: "node",
  target: "node20",
  charset: "utf8",
});
