// Reads the public interface from the declarations in dist/types: every exported class, function and type with its signatures, its
// documentation and its members. The compiler API of TypeScript 6 is used because TypeScript 7 has none.
import { fileURLToPath } from "node:url";
import ts from "typescript-api";
import { docOf, fieldsIn } from "./jsdoc.js";

const TYPES = fileURLToPath(new URL("../../../dist/types/", import.meta.url));

/**
 * @typedef {{ name: string, type: string, optional: boolean, doc: string, fields: Field[] }} Parameter
 * @typedef {{ name: string, type: string, doc: string }} Field
 * @typedef {{ text: string, parameters: Parameter[], result?: { type: string, doc: string }, throws: string[] }} Signature
 * @typedef {{ name: string, kind: "constructor" | "static" | "method" | "property" | "function", summary: string, details: string[], signatures: Signature[] }} Member
 * @typedef {{ name: string, summary: string, details: string[], members: Member[] }} ClassDoc
 * @typedef {{ name: string, text: string, summary: string, details: string[], fields: Field[] }} TypeDoc
 */

/**
 * What some modules export.
 *
 * @template {string} M
 * @param {M[]} modules "index", "core", "applet/index" …
 * @returns {Record<M, { classes: ClassDoc[], functions: Member[], types: TypeDoc[] }>}
 */
export function extract(modules) {
  const files = modules.map((name) => `${TYPES}${name}.d.ts`);
  const options = { module: ts.ModuleKind.NodeNext, target: ts.ScriptTarget.ES2022, types: [] };
  const program = ts.createProgram(files, options);
  const exports = modules.map((name, k) => [name, exportsOf(program, files[k])]);
  return /** @type {any} */ (Object.fromEntries(exports));
}

/** @param {ts.Program} program @param {string} file */
function exportsOf(program, file) {
  const checker = program.getTypeChecker();
  const source = program.getSourceFile(file);
  if (!source) throw new Error(`expected declarations in ${file}: run npm run build`);
  const found = { classes: [], functions: [], types: [] };
  const module = checker.getSymbolAtLocation(source);
  for (const exported of module ? checker.getExportsOfModule(module) : []) {
    const symbol = exported.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(exported) : exported;
    addExport(found, exported.name, symbol, checker);
  }
  return found;
}

/** @param {any} found @param {string} name @param {ts.Symbol} symbol @param {ts.TypeChecker} checker */
function addExport(found, name, symbol, checker) {
  const declaration = symbol.declarations?.[0];
  if (!declaration) return;
  if (ts.isClassDeclaration(declaration)) found.classes.push(classDoc(name, symbol, checker));
  else if (ts.isFunctionDeclaration(declaration)) found.functions.push(member(symbol, "function", name));
  else if (ts.isVariableDeclaration(declaration)) found.functions.push(variable(name, declaration, checker));
  else if (isTypeDeclaration(declaration)) found.types.push(typeDoc(name, declaration, checker));
}

/** @param {string} name @param {ts.Symbol} symbol @param {ts.TypeChecker} checker @returns {ClassDoc} */
function classDoc(name, symbol, checker) {
  const declaration = /** @type {ts.ClassDeclaration} */ (symbol.declarations?.[0]);
  const statics = checker.getPropertiesOfType(checker.getTypeOfSymbol(symbol)).filter((s) => s.name !== "prototype");
  const instance = baseClassesFirst(checker.getPropertiesOfType(checker.getDeclaredTypeOfSymbol(symbol)));
  const { summary, details } = docOf(declaration);
  const own = constructorOf(declaration, name, checker);
  const members = [
    ...(own ? [own] : []),
    ...baseClassesFirst(statics.filter(isPublic)).map((s) => member(s, "static", `${name}.${s.name}`)),
    ...instance.filter(isPublic).map((s) => member(s, isMethod(s) ? "method" : "property", s.name)),
  ];
  return { name, summary, details, members };
}

/** Members of the class that all others extend come first: they are the most basic ones. @param {ts.Symbol[]} members */
function baseClassesFirst(members) {
  const parents = [...new Set(members.map((member) => member.declarations?.[0].parent))].reverse();
  return parents.flatMap((parent) => members.filter((member) => member.declarations?.[0].parent === parent));
}

/** @param {ts.Symbol} symbol */
const isPublic = (symbol) => !/^(_|#)/.test(symbol.name) && !symbol.declarations?.every(isHidden);

/** @param {ts.Declaration} declaration */
const isHidden = (declaration) =>
  Boolean(ts.getCombinedModifierFlags(declaration) & ts.ModifierFlags.Private) ||
  !declaration.getSourceFile().fileName.startsWith(TYPES); // what classes inherit from the browser

/** @param {ts.Symbol} symbol */
const isMethod = (symbol) => Boolean(symbol.flags & ts.SymbolFlags.Method);

/**
 * The constructor of a class or, if it has none of its own, of the nearest class it extends.
 *
 * @param {ts.ClassDeclaration} declaration @param {string} name @param {ts.TypeChecker} checker @returns {Member | undefined}
 */
function constructorOf(declaration, name, checker) {
  const own = declaration.members.find(ts.isConstructorDeclaration);
  if (own) {
    const { summary, details } = docOf(own);
    const signature = signatureOf(own, `new ${name}`);
    return {
      name: `new ${name}`,
      kind: "constructor",
      summary,
      details,
      signatures: [{ ...signature, result: undefined }],
    };
  }
  const parent = declaration.heritageClauses?.[0]?.types[0];
  const base = parent && checker.getTypeAtLocation(parent.expression).symbol?.declarations?.find(ts.isClassDeclaration);
  return base && constructorOf(base, name, checker);
}

/** @param {ts.Symbol} symbol @param {Member["kind"]} kind @param {string} title @returns {Member} */
function member(symbol, kind, title) {
  const declarations = /** @type {any[]} */ (symbol.declarations ?? []);
  const { summary, details, returns } = docOf(declarations[0]);
  if (kind === "property" || !declarations.some((d) => d.parameters && !ts.isGetAccessor(d))) {
    const type = cleanType(declarations[0].type?.getText() ?? "unknown");
    const result = { type, doc: returns };
    const text = `${symbol.name}: ${type}`;
    return { name: symbol.name, kind, summary, details, signatures: [{ text, parameters: [], result, throws: [] }] };
  }
  const signatures = declarations.map((d) => signatureOf(d, title));
  return { name: symbol.name, kind, summary, details, signatures };
}

/** An exported constant that can be called, as `easing`. @param {string} name @param {ts.VariableDeclaration} declaration @param {ts.TypeChecker} checker @returns {Member} */
function variable(name, declaration, checker) {
  const statement = declaration.parent.parent;
  const { summary, details } = docOf(statement);
  const calls = checker.getTypeAtLocation(declaration).getCallSignatures();
  const signatures = calls.map((call) => signatureOf(/** @type {any} */ (call.getDeclaration()), name));
  return { name, kind: "function", summary, details, signatures };
}

/** @param {ts.SignatureDeclaration} declaration @param {string} title @returns {Signature} */
function signatureOf(declaration, title) {
  const doc = docOf(declaration);
  const parameters = declaration.parameters
    .filter((parameter) => parameter.name.getText() !== "this") // the class, which is in the title
    .map((parameter) => parameterOf(parameter, doc.parameters.get(parameter.name.getText()) ?? ""));
  const ofClass = declaration.parameters.some((parameter) => parameter.name.getText() === "this");
  const written = cleanType(declaration.type?.getText() ?? "void");
  const type = ofClass
    ? written.replace(/\bP\b/, title.split(".")[0]).replace("PathBuilder<Path>", "PathBuilder")
    : written;
  const shown = parameters.map((p) => `${p.name}${p.optional ? "?" : ""}: ${p.type}`).join(", ");
  const text = `${title}(${shown})${ts.isConstructorDeclaration(declaration) ? "" : `: ${type}`}`;
  return { text, parameters, result: { type, doc: doc.returns }, throws: doc.throws };
}

/** @param {ts.ParameterDeclaration} parameter @param {string} doc @returns {Parameter} */
function parameterOf(parameter, doc) {
  const rest = parameter.dotDotDotToken ? "..." : "";
  const type = cleanType(parameter.type?.getText() ?? "unknown");
  const named = fieldsIn(doc);
  const fields = parameter.type ? fieldsOf(parameter.type, named.fields) : [];
  const optional = Boolean(parameter.questionToken || parameter.initializer);
  return { name: rest + parameter.name.getText(), type, optional, doc: fields.length > 0 ? named.rest : doc, fields };
}

/**
 * The fields of an object type: of a literal in place, or of a type alias of this package that is an object.
 *
 * @param {ts.TypeNode | ts.InterfaceDeclaration} node @param {Map<string, string>} documented @returns {Field[]}
 */
function fieldsOf(node, documented) {
  if (!ts.isTypeLiteralNode(node) && !ts.isInterfaceDeclaration(node)) return [];
  return node.members.filter(ts.isPropertySignature).map((field) => {
    const name = field.name.getText() + (field.questionToken ? "?" : "");
    const doc = docOf(field).text || (documented.get(field.name.getText()) ?? "");
    return { name, type: cleanType(field.type?.getText() ?? "unknown"), doc };
  });
}

/** @param {ts.Node} node @returns {node is ts.TypeAliasDeclaration | ts.InterfaceDeclaration} */
const isTypeDeclaration = (node) => ts.isTypeAliasDeclaration(node) || ts.isInterfaceDeclaration(node);

/** The members of an interface, in braces. @param {ts.InterfaceDeclaration} node */
const bodyOf = (node) => `{ ${node.members.map((each) => each.getText()).join(" ")} }`;

/** @param {string} name @param {ts.TypeAliasDeclaration | ts.InterfaceDeclaration} alias @param {ts.TypeChecker} checker @returns {TypeDoc} */
function typeDoc(name, alias, checker) {
  const target = targetOf(alias, checker);
  const { summary, details } = docOf(target);
  const parameters = target.typeParameters?.map((p) => p.getText()).join(", ");
  const text = `type ${name}${parameters ? `<${parameters}>` : ""} = ${cleanType(ts.isInterfaceDeclaration(target) ? bodyOf(target) : target.type.getText())}`;
  return {
    name,
    text,
    summary,
    details,
    fields: ts.isInterfaceDeclaration(target) ? fieldsOf(target, new Map()) : fieldsOf(target.type, new Map()),
  };
}

/**
 * Follows `type A = import("…").A` to the declaration that says what A is.
 *
 * @param {ts.TypeAliasDeclaration | ts.InterfaceDeclaration} alias @param {ts.TypeChecker} checker @returns {ts.TypeAliasDeclaration | ts.InterfaceDeclaration}
 */
function targetOf(alias, checker) {
  if (ts.isInterfaceDeclaration(alias) || !ts.isImportTypeNode(alias.type) || !alias.type.qualifier) return alias;
  const symbol = checker.getSymbolAtLocation(alias.type.qualifier);
  const next = symbol?.declarations?.find(isTypeDeclaration);
  return next ? targetOf(next, checker) : alias;
}

/** A type as it is shown: without comments and imports, on one line. @param {string} text */
function cleanType(text) {
  return text
    .replace(/\/\*[\s\S]*?\*\//g, "")
    .replace(/import\("[^"]*"\)\./g, "")
    .replace("M & Complete<M>", "TransformLike") // for the compiler
    .replace(/\s+/g, " ")
    .replace(/; }/g, " }")
    .trim();
}
