// Makes an ES module with some of the classes' methods, its wasm module and its types, from the pieces of the package
// (xtask/pieces.js). It runs without files and without Node.
import { Module } from "./cut.js";
import { encode } from "./encode.js";

/**
 * A declaration at the top level, or a member of a class.
 *
 * @typedef {object} Piece
 * @property {string} text
 * @property {number[]} refs the pieces that it refers to: declarations are added, members only to classes that are there
 * @property {number[]} [direct] members that it calls on `super`
 * @property {string[]} [exports] the functions of the wasm module that it calls
 * @property {number[]} [members] of a class, whose text is what stands before them
 * @property {number} [base] the class that a class extends
 * @property {number} [of] the class of a member
 * @property {boolean} [always] whether the member is in the class whenever the class is: the constructor
 * @property {number[]} [overrides] the members of base classes that a member overrides
 */

/**
 * A public name: its piece, and the pieces of each public member of a class; inherited ones are in a base class.
 *
 * @typedef {{ piece: number, members?: Record<string, number[]>, statics?: string[] }} PublicName
 */

/**
 * @typedef {object} Pieces
 * @property {string} version
 * @property {string} license
 * @property {Piece[]} pieces
 * @property {Record<string, PublicName>} names
 * @property {string[]} nurbs the classes of casteljau/nurbs, which these modules cannot have
 * @property {Record<string, { piece: number, name: string }>} imports the functions that the wasm module imports: a piece each, and its name there
 * @property {TypePieces} types
 */

/**
 * Declarations: a class has members, each of which is of one public member or, without a name, always there.
 *
 * @typedef {object} TypePiece
 * @property {string} text
 * @property {number[]} refs
 * @property {string} [name] under which the package exports it
 * @property {number[]} [members]
 * @property {number} [base]
 * @property {string} [member] the name of a member
 * @property {number} [of]
 */

/** @typedef {{ pieces: TypePiece[], names: Record<string, number> }} TypePieces */

/**
 * What a module is made of: the contents of dist/custom/pieces.json, dist/custom/needs.json and dist/casteljau.wasm.
 *
 * @typedef {{ pieces: Pieces, needs: import("./cut.js").ModuleNeeds | null, wasm: Module }} Source
 */

/** @param {Pieces} pieces @param {import("./cut.js").ModuleNeeds | null} needs @param {Uint8Array} wasm @returns {Source} */
export const sourceOf = (pieces, needs, wasm) => ({ pieces, needs, wasm: new Module(wasm) });

/**
 * Makes a module.
 *
 * @param {Source} source
 * @param {readonly string[]} list names such as "Curve.length", "Curve" (the class with its constructor only), "easing";
 *   `checkedList` checks them
 * @param {string} command that makes the module, for its first line and for messages
 * @returns {{ code: string, types: string, wasm: Uint8Array<ArrayBuffer> | null }} `wasm` is null if nothing of the list calls
 *   the core; then there is no `init` either
 */
export function customModule(source, list, command) {
  const { pieces, names, imports, version, license } = source.pieces;
  const needed = new Closure(pieces);
  for (const item of list) {
    const [name, member] = item.split(".");
    needed.add(names[name].piece);
    if (member) for (const index of names[name].members?.[member] ?? []) needed.add(index);
  }
  const usesCore = needed.exports().size > 0;
  if (usesCore) needed.add(names.init.piece);
  const wasm = usesCore ? cutWasm(source, needed) : null;
  const firstLine = `/*! ${command.replaceAll("*/", "* /")} | casteljau ${version} | ${license} */`;
  const isIncluded = (/** @type {string} */ name) => needed.has(names[name].piece);
  const { exported, text: types } = typesOf(source.pieces, usesCore ? [...list, "init"] : list, firstLine, isIncluded);
  const declarations = pieces.flatMap(({ of }, index) =>
    of === undefined && needed.has(index) ? [textOf(pieces, index, needed)] : [],
  );
  const linked = (wasm?.imports ?? []).map((name) => `${JSON.stringify(name)}:${imports[name].name}`);
  const lines = [
    firstLine,
    ...(wasm ? [`const $wasm=${wasmLiteral(wasm.bytes)};`] : []),
    ...declarations,
    ...(wasm ? [`const $imports={"./casteljau_bg.js":{${linked}}};`] : []),
    ...missingMembers(source.pieces, exported, needed, command),
    `export{${exported}};`,
    "",
  ];
  return { code: lines.join("\n"), types, wasm: wasm?.bytes ?? null };
}

/** The pieces that a list needs, directly and indirectly. */
class Closure {
  /** @type {Set<number>} */
  #pieces = new Set();
  /** Members that are called: they, and those that override them, belong to their classes as soon as these are there. @type {Set<number>} */
  #called = new Set();
  /** Members that are called on `super`. @type {Set<number>} */
  #direct = new Set();
  /** The members that override a member. @type {Map<number, number[]>} */
  #overriding = new Map();

  /** @param {Piece[]} pieces */
  constructor(pieces) {
    this.pieces = pieces;
    pieces.forEach(({ overrides = [] }, index) => {
      for (const base of overrides) this.#overriding.set(base, [...(this.#overriding.get(base) ?? []), index]);
    });
  }

  /** @param {number} index */
  has(index) {
    return this.#pieces.has(index);
  }

  /** @param {number} index of a declaration or a member */
  add(index) {
    const { of, base, members = [] } = this.pieces[index];
    if (of !== undefined) {
      if (this.#called.has(index)) return;
      this.#called.add(index);
      for (const each of [index, ...(this.#overriding.get(index) ?? [])]) this.#includeMember(each);
      return;
    }
    if (this.#pieces.has(index)) return;
    this.#include(index);
    if (base !== undefined) this.add(base);
    for (const member of members) {
      const { always, overrides = [] } = this.pieces[member];
      const isCalled = [member, ...overrides].some((each) => this.#called.has(each));
      if (always || isCalled || this.#direct.has(member)) this.#include(member);
    }
  }

  /** @param {number} index */
  #includeMember(index) {
    if (this.#pieces.has(/** @type {number} */ (this.pieces[index].of))) this.#include(index);
  }

  /** @param {number} index */
  #include(index) {
    if (this.#pieces.has(index)) return;
    this.#pieces.add(index);
    const { refs, direct = [] } = this.pieces[index];
    for (const each of refs) this.add(each);
    for (const each of direct) {
      this.#direct.add(each);
      this.#includeMember(each);
    }
  }

  /** The functions of the wasm module that the pieces call. */
  exports() {
    return new Set([...this.#pieces].flatMap((index) => this.pieces[index].exports ?? []));
  }
}

/** The exports of wasm-bindgen that prepare values of JavaScript which the module refers to. */
const REFERENCES = ["__wbindgen_start", "__wbindgen_externrefs"];

/** Cuts the wasm module, and adds the pieces that its imports need. @param {Source} source @param {Closure} needed */
function cutWasm({ pieces, needs, wasm }, needed) {
  for (;;) {
    const exports = needed.exports();
    let result = wasm.cut(exports, needs);
    if (result.hasReferences) result = wasm.cut(new Set([...exports, ...REFERENCES]), needs);
    for (const name of result.imports) needed.add(pieces.imports[name].piece);
    if (needed.exports().size === exports.size) return result;
  }
}

/** @param {Uint8Array} bytes */
function wasmLiteral(bytes) {
  const { alphabet, frequent, length, text } = encode(bytes);
  return `{alphabet:"${alphabet}",frequent:[${frequent}],length:${length},text:\n"${text}"}`;
}

/** The text of a declaration: of a class, with the members that are needed. @param {Piece[]} pieces @param {number} index @param {Closure} needed */
function textOf(pieces, index, needed) {
  const { text, members } = pieces[index];
  if (!members) return text;
  const inside = members.filter((each) => needed.has(each)).map((each) => pieces[each].text);
  return `${[text, ...inside].join("\n")}}`;
}

/**
 * Code that defines an error for each public member that is not in the module.
 *
 * @param {Pieces} pieces
 * @param {readonly string[]} exported
 * @param {Closure} needed
 * @param {string} command
 */
function missingMembers({ names }, exported, needed, command) {
  const calls = exported.flatMap((name) => {
    const { members = {}, statics = [] } = names[name];
    const missing = Object.keys(members).filter((member) => !members[member].some((index) => needed.has(index)));
    const [own, inherited] = [true, false].map((isStatic) =>
      missing.filter((member) => statics.includes(member) === isStatic).join(" "),
    );
    return [
      own && `$missing(${name},"${name}","${own}");`,
      inherited && `$missing(${name}.prototype,"${name}","${inherited}");`,
    ];
  });
  if (calls.length === 0) return [];
  const message = `type+"."+name+${JSON.stringify(` is not in this build; add it: ${command}`)}`;
  const property = `{configurable:true,get(){throw new TypeError(${message})}}`;
  const define = `for(const name of names.split(" "))Object.defineProperty(target,name,${property})`;
  return [`const $missing=(target,type,names)=>{${define}};`, ...calls.filter(Boolean)];
}

/**
 * The declarations of a module: of its classes, with the members of the list, and of all types that these refer to. It exports
 * the classes of the list and those of which these give values.
 *
 * @param {Pieces} pieces
 * @param {readonly string[]} list
 * @param {string} firstLine
 * @param {(name: string) => boolean} isIncluded whether the module has a class or function
 */
function typesOf({ names: values, types: { pieces, names } }, list, firstLine, isIncluded) {
  /** @type {Set<number>} */
  const needed = new Set();
  const bases = new Set(pieces.flatMap(({ base }) => base ?? []));
  const listable = new Set([...bases, ...Object.keys(values).map((name) => names[name])]);
  const add = (/** @type {number} */ index) => {
    if (needed.has(index)) return;
    needed.add(index);
    const { refs, base, members = [], of } = pieces[index];
    for (const each of refs) add(each);
    if (base !== undefined) add(base);
    if (of !== undefined) add(of);
    for (const each of members) if (!pieces[each].member || !listable.has(index)) add(each);
  };
  /** A member, in the class itself or in the nearest base class that has it. @param {number} type @param {string} member */
  const addMember = (type, member) => {
    for (let at = /** @type {number | undefined} */ (type); at !== undefined; at = pieces[at].base) {
      const found = (pieces[at].members ?? []).filter((index) => pieces[index].member === member);
      found.forEach(add);
      if (found.length > 0) return;
    }
  };
  for (const item of list) {
    const [name, member] = item.split(".");
    add(names[name]);
    if (member) addMember(names[name], member);
  }
  /** @type {string[]} */
  const exported = [];
  for (;;) {
    const next = Object.keys(values).find(
      (name) => needed.has(names[name]) && isIncluded(name) && !exported.includes(name),
    );
    if (next === undefined) break;
    exported.push(next);
    addMember(names[next], "constructor");
  }
  const lines = [firstLine];
  pieces.forEach(({ text, members, of }, index) => {
    if (!needed.has(index) || of !== undefined) return;
    const inside = (members ?? []).filter((each) => needed.has(each)).map((each) => `    ${pieces[each].text}`);
    lines.push(members ? [text, ...inside, "}"].join("\n") : text);
  });
  const types = Object.keys(names).filter((name) => needed.has(names[name]) && !exported.includes(name));
  lines.push(`export { ${[...exported, ...types.map((name) => `type ${name}`)].join(", ")} };`, "");
  return { exported, text: lines.join("\n") };
}
