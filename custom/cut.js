// Cuts a WebAssembly module: keeps some of its exports and what they need, and renumbers the rest.
//
// The module is one that `npm run build` has made. Functions are followed by their calls; which constants and which entries
// of the table of functions an export needs is known from the relocations of the linked module (xtask/src/liveness.rs).
// Format: WebAssembly core specification, 5 (binary format).

/**
 * What an export needs: addresses of constants as [start, length, start, length, …], and indices in the table of functions.
 *
 * @typedef {{ data: number[], table: number[] }} Needs
 */

/**
 * The needs of all exports, and the addresses of all constants that an export may need; other bytes are always kept. Where
 * they are not known (in a build for development), all constants and all entries of the table are kept.
 *
 * @typedef {{ data: number[], exports: Record<string, Needs> }} ModuleNeeds
 */

const SECTION = {
  type: 1,
  import: 2,
  function: 3,
  table: 4,
  memory: 5,
  global: 6,
  export: 7,
  start: 8,
  element: 9,
  code: 10,
  data: 11,
  dataCount: 12,
};

/** The kinds of imports, exports and references. */
const FUNCTION = 0;
const TABLE = 1;
const MEMORY = 2;
const GLOBAL = 3;
const TYPE = 4;

/** Two ranges of constants that are closer than this are one segment: another one would take as many bytes. */
const MIN_GAP = 8;

/** Reads numbers from bytes, one after the other. */
class Reader {
  /** @param {Uint8Array} bytes @param {number} [at] @param {number} [end] */
  constructor(bytes, at = 0, end = bytes.length) {
    this.bytes = bytes;
    this.at = at;
    this.end = end;
  }

  byte() {
    return this.bytes[this.at++];
  }

  /** An unsigned number of at most 32 bits (LEB128). */
  number() {
    let [value, factor] = [0, 1];
    for (;;) {
      const byte = this.byte();
      value += (byte & 127) * factor;
      if (byte < 128) return value;
      factor *= 128;
    }
  }

  /** A signed number of at most 53 bits. */
  signed() {
    let [value, factor] = [0, 1];
    for (;;) {
      const byte = this.byte();
      value += (byte & 127) * factor;
      factor *= 128;
      if (byte < 128) return byte & 64 ? value - factor : value;
    }
  }

  /** Skips a number of any size. */
  skip() {
    while (this.byte() >= 128);
  }

  /** @param {number} length */
  take(length) {
    this.at += length;
    return this.bytes.subarray(this.at - length, this.at);
  }

  name() {
    return new TextDecoder().decode(this.take(this.number()));
  }

  /** A list. @template T @param {(k: number) => T} read @returns {T[]} */
  list(read) {
    return Array.from({ length: this.number() }, (_, k) => read(k));
  }
}

/**
 * A number in the code that refers to a function, type, global or table.
 *
 * @typedef {{ at: number, end: number, kind: number, index: number }} Reference
 */

/**
 * The references in a sequence of instructions, up to its end.
 *
 * @param {Reader} reader at the first instruction; afterwards behind the last `end`
 * @returns {Reference[]}
 */
function references(reader) {
  /** @type {Reference[]} */
  const found = [];
  const refer = (/** @type {number} */ kind) => {
    const at = reader.at;
    const index = reader.number();
    found.push({ at, end: reader.at, kind, index });
  };
  const memoryArgument = () => {
    reader.skip(); // alignment
    reader.skip(); // offset
  };
  let depth = 1;
  while (depth > 0) {
    const opcode = reader.byte();
    if (opcode >= 0x45 && opcode <= 0xc4) continue; // arithmetic and conversions
    if (opcode >= 0x28 && opcode <= 0x3e) memoryArgument();
    else if (opcode >= 0x02 && opcode <= 0x04) {
      depth++;
      const { at } = reader;
      const type = reader.signed();
      if (type >= 0) found.push({ at, end: reader.at, kind: TYPE, index: type });
    } else if (opcode === 0x0b) depth--;
    else
      switch (opcode) {
        case 0x00: // unreachable
        case 0x01: // nop
        case 0x05: // else
        case 0x0f: // return
        case 0x1a: // drop
        case 0x1b: // select
        case 0xd1: // ref.is_null
          break;
        case 0x0c: // br
        case 0x0d: // br_if
        case 0x20: // local.get
        case 0x21: // local.set
        case 0x22: // local.tee
        case 0x3f: // memory.size
        case 0x40: // memory.grow
        case 0x41: // i32.const
        case 0x42: // i64.const
        case 0xd0: // ref.null
          reader.skip();
          break;
        case 0x0e: // br_table
          for (let count = reader.number(); count >= 0; count--) reader.skip();
          break;
        case 0x1c: // select with a type
          reader.take(reader.number());
          break;
        case 0x10: // call
        case 0x12: // return_call
        case 0xd2: // ref.func
          refer(FUNCTION);
          break;
        case 0x11: // call_indirect
        case 0x13: // return_call_indirect
          refer(TYPE);
          refer(TABLE);
          break;
        case 0x23: // global.get
        case 0x24: // global.set
          refer(GLOBAL);
          break;
        case 0x25: // table.get
        case 0x26: // table.set
          refer(TABLE);
          break;
        case 0x43: // f32.const
          reader.take(4);
          break;
        case 0x44: // f64.const
          reader.take(8);
          break;
        case 0xfc: {
          const code = reader.number();
          if (code < 8) break; // saturating conversions
          if (code === 10)
            reader.take(2); // memory.copy
          else if (code === 11)
            reader.take(1); // memory.fill
          else if (code === 14) {
            refer(TABLE); // table.copy
            refer(TABLE);
          } else if (code >= 15 && code <= 17) refer(TABLE);
          else throw unknown(`0xfc ${code}`);
          break;
        }
        case 0xfd: {
          const code = reader.number();
          if (code <= 11 || code === 92 || code === 93) memoryArgument();
          else if (code <= 13)
            reader.take(16); // v128.const, i8x16.shuffle
          else if (code >= 21 && code <= 34)
            reader.take(1); // lanes
          else if (code >= 84 && code <= 91) {
            memoryArgument();
            reader.take(1);
          } else if (code > 255) throw unknown(`0xfd ${code}`);
          break;
        }
        default:
          throw unknown(`0x${opcode.toString(16)}`);
      }
  }
  return found;
}

/** @param {string} opcode */
const unknown = (opcode) => new Error(`cut: expected an instruction of WebAssembly 2.0, got ${opcode}`);

/** The bytes of a number (LEB128). @param {number} value */
function leb(value) {
  const bytes = [];
  do {
    bytes.push((value & 127) | (value > 127 ? 128 : 0));
    value >>>= 7;
  } while (value > 0);
  return bytes;
}

/** The bytes of a signed number of 32 bits. @param {number} value */
function signedLeb(value) {
  const bytes = [];
  for (;;) {
    const byte = value & 127;
    value >>= 7;
    const isLast = value === (byte & 64 ? -1 : 0);
    bytes.push(isLast ? byte : byte | 128);
    if (isLast) return bytes;
  }
}

/** @typedef {{ kind: number, module: string, name: string, type: number, bytes: Uint8Array }} Import */
/** @typedef {{ kind: number, name: string, index: number }} Export */
/** @typedef {{ locals: Uint8Array, at: number, end: number, references: Reference[] }} Body the code between two positions */
/** @typedef {{ at: number, end: number, references: Reference[] }} Expression */

/** A module whose functions are decoded, so that it can be cut several times. */
export class Module {
  /** The types of functions, as bytes. @type {Uint8Array[]} */
  types = [];
  /** @type {Import[]} */
  imports = [];
  /** The types of all functions: first those that are imported. @type {number[]} */
  functionTypes = [];
  /** @type {Uint8Array[]} */
  tables = [];
  /** @type {Uint8Array} */
  memory = new Uint8Array();
  /** @type {{ type: Uint8Array, init: Expression }[]} */
  globals = [];
  /** @type {Export[]} */
  exports = [];
  /** @type {number | undefined} */
  start;
  /** The functions in the table 0, by their index in the table. @type {Map<number, number>} */
  table = new Map();
  /** @type {Body[]} */
  bodies = [];
  /** @type {{ address: number, bytes: Uint8Array }[]} */
  data = [];

  /** @param {Uint8Array} bytes of the module */
  constructor(bytes) {
    this.bytes = bytes;
    const reader = new Reader(bytes, 8);
    while (reader.at < bytes.length) {
      const id = reader.byte();
      const length = reader.number();
      this.#readSection(id, new Reader(bytes, reader.at, reader.at + length));
      reader.take(length);
    }
  }

  /** @param {number} id @param {Reader} reader */
  #readSection(id, reader) {
    switch (id) {
      case SECTION.type:
        this.types = reader.list(() => {
          const at = reader.at;
          if (reader.byte() !== 0x60) throw new Error("cut: expected types of functions");
          reader.take(reader.number());
          reader.take(reader.number());
          return reader.bytes.subarray(at, reader.at);
        });
        break;
      case SECTION.import:
        this.imports = reader.list(() => {
          const [module, name, kind] = [reader.name(), reader.name(), reader.byte()];
          if (kind !== FUNCTION) throw new Error(`cut: expected imports of functions, got ${module} ${name}`);
          const type = reader.number();
          return { kind, module, name, type, bytes: new Uint8Array() };
        });
        this.functionTypes = this.imports.map(({ type }) => type);
        break;
      case SECTION.function:
        this.functionTypes = [...this.functionTypes, ...reader.list(() => reader.number())];
        break;
      case SECTION.table:
        this.tables = reader.list(() => {
          const at = reader.at;
          reader.byte(); // type of the references
          const flags = reader.byte();
          reader.skip();
          if (flags & 1) reader.skip();
          return reader.bytes.subarray(at, reader.at);
        });
        break;
      case SECTION.memory:
        this.memory = reader.bytes.subarray(reader.at, reader.end);
        break;
      case SECTION.global:
        this.globals = reader.list(() => ({ type: reader.take(2), init: this.#expression(reader) }));
        break;
      case SECTION.export:
        this.exports = reader.list(() => ({ name: reader.name(), kind: reader.byte(), index: reader.number() }));
        break;
      case SECTION.start:
        this.start = reader.number();
        break;
      case SECTION.element:
        reader.list(() => {
          const flags = reader.number();
          if (flags !== 0) throw new Error(`cut: expected active segments of table 0, got ${flags}`);
          const first = this.#address(reader);
          reader.list((k) => this.table.set(first + k, reader.number()));
        });
        break;
      case SECTION.code:
        this.bodies = reader.list(() => {
          const end = reader.number() + reader.at;
          const { at: start } = reader;
          for (let groups = reader.number(); groups > 0; groups--) {
            reader.skip();
            reader.byte();
          }
          const at = reader.at;
          const body = { locals: reader.bytes.subarray(start, at), at, end, references: references(reader) };
          if (reader.at !== end) throw new Error("cut: expected the end of a function");
          return body;
        });
        break;
      case SECTION.data:
        this.data = reader.list(() => {
          const flags = reader.number();
          if (flags !== 0) throw new Error(`cut: expected active segments of memory 0, got ${flags}`);
          const address = this.#address(reader);
          return { address, bytes: reader.take(reader.number()) };
        });
        break;
      case SECTION.dataCount:
      case 0: // names and other remarks
        break;
      default:
        throw new Error(`cut: expected a known section, got ${id}`);
    }
  }

  /** @param {Reader} reader @returns {Expression} */
  #expression(reader) {
    const { at } = reader;
    const found = references(reader);
    return { at, end: reader.at, references: found };
  }

  /** The constant at which a segment starts. @param {Reader} reader */
  #address(reader) {
    if (reader.byte() !== 0x41) throw new Error("cut: expected a segment at a constant address");
    const address = reader.signed();
    if (reader.byte() !== 0x0b) throw new Error("cut: expected a segment at a constant address");
    return address;
  }

  /**
   * The module with some of its exports and what they need.
   *
   * @param {ReadonlySet<string>} names of the exports; the memory is always kept
   * @param {ModuleNeeds | null} needs
   * @returns {{ bytes: Uint8Array<ArrayBuffer>, imports: string[], hasReferences: boolean }} the names of the imports that
   *   are left, and whether it has a table of references to values of JavaScript
   */
  cut(names, needs) {
    const exports = this.exports.filter(({ name, kind }) => kind === MEMORY || names.has(name));
    const slots = needs ? new Set(exports.flatMap(({ name }) => needs.exports[name]?.table ?? [])) : undefined;
    const table = new Map([...this.table].filter(([slot]) => !slots || slots.has(slot)));
    const used = this.#used(exports, table);
    const ranges = needs && {
      known: needs.data,
      wanted: mergeRanges(exports.map(({ name }) => needs.exports[name]?.data ?? [])),
    };
    const bytes = this.#write(exports, table, used, ranges);
    const imports = this.imports.filter((_, k) => used[FUNCTION].has(k)).map(({ name }) => name);
    return { bytes, imports, hasReferences: [...used[TABLE].keys()].some((index) => index > 0) };
  }

  /**
   * The used functions, tables, globals and types, each with its new index.
   *
   * @param {Export[]} exports
   * @param {Map<number, number>} table
   */
  #used(exports, table) {
    /** @type {Set<number>[]} */
    const used = [new Set(), new Set(), new Set(), new Set(), new Set()];
    /** @type {number[]} */
    const waiting = [];
    const use = (/** @type {number} */ kind, /** @type {number} */ index) => {
      if (used[kind].has(index)) return;
      used[kind].add(index);
      if (kind === FUNCTION) {
        used[TYPE].add(this.functionTypes[index]);
        waiting.push(index);
      }
      if (kind === GLOBAL) for (const each of this.globals[index].init.references) use(each.kind, each.index);
      if (kind === TABLE && index === 0) for (const each of table.values()) use(FUNCTION, each);
    };
    for (const { kind, index } of exports) use(kind, index);
    if (this.start !== undefined) use(FUNCTION, this.start);
    for (let index = waiting.pop(); index !== undefined; index = waiting.pop()) {
      const body = this.bodies[index - this.imports.length];
      if (body) for (const each of body.references) use(each.kind, each.index);
    }
    return used.map((set) => new Map([...set].sort((a, b) => a - b).map((index, k) => [index, k])));
  }

  /**
   * @param {Export[]} exports
   * @param {Map<number, number>} table
   * @param {Map<number, number>[]} used
   * @param {{ known: number[], wanted: number[] } | null} ranges
   */
  #write(exports, table, used, ranges) {
    const [functions, tables, , globals, types] = used;
    const renumbered = (/** @type {number} */ kind, /** @type {number} */ index) =>
      /** @type {number} */ (used[kind].get(index));
    /** Code with the new numbers. @param {Expression} code */
    const rewritten = ({ at, end, references }) => {
      /** @type {number[]} */
      const out = [];
      let from = at;
      for (const each of references) {
        for (let k = from; k < each.at; k++) out.push(this.bytes[k]);
        out.push(...leb(renumbered(each.kind, each.index)));
        from = each.end;
      }
      for (let k = from; k < end; k++) out.push(this.bytes[k]);
      return out;
    };
    const local = [...functions.keys()].filter((index) => index >= this.imports.length);
    const imports = this.imports.filter((_, k) => functions.has(k));
    /** @type {number[]} */
    const out = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0];
    /** @param {number} id @param {ArrayLike<number>[]} items */
    const section = (id, items) => {
      if (items.length > 0) addSection(out, id, [leb(items.length), ...items]);
    };
    section(
      SECTION.type,
      [...types.keys()].map((index) => this.types[index]),
    );
    section(
      SECTION.import,
      imports.map(({ module, name, type }) => [
        ...text(module),
        ...text(name),
        FUNCTION,
        ...leb(renumbered(TYPE, type)),
      ]),
    );
    section(
      SECTION.function,
      local.map((index) => leb(renumbered(TYPE, this.functionTypes[index]))),
    );
    section(
      SECTION.table,
      [...tables.keys()].map((index) => this.tables[index]),
    );
    if (this.memory.length > 0) addSection(out, SECTION.memory, [this.memory]);
    section(
      SECTION.global,
      [...globals.keys()].map((index) => [...this.globals[index].type, ...rewritten(this.globals[index].init)]),
    );
    section(
      SECTION.export,
      exports.map(({ name, kind, index }) => [
        ...text(name),
        kind,
        ...leb(kind === MEMORY ? index : renumbered(kind, index)),
      ]),
    );
    if (this.start !== undefined) addSection(out, SECTION.start, [leb(renumbered(FUNCTION, this.start))]);
    if (tables.has(0))
      section(
        SECTION.element,
        runs(table).map(({ first, values }) => {
          const entries = values.flatMap((index) => leb(renumbered(FUNCTION, index)));
          return [0, 0x41, ...signedLeb(first), 0x0b, ...leb(values.length), ...entries];
        }),
      );
    section(
      SECTION.code,
      local.map((index) => {
        const body = this.bodies[index - this.imports.length];
        const code = rewritten(body);
        return [...leb(body.locals.length + code.length), ...body.locals, ...code];
      }),
    );
    section(
      SECTION.data,
      this.data.flatMap((segment) =>
        keptParts(segment, ranges).map(({ address, bytes }) => [
          ...[0, 0x41, ...signedLeb(address), 0x0b, ...leb(bytes.length)],
          ...bytes,
        ]),
      ),
    );
    return Uint8Array.from(out);
  }
}

/** @param {number[]} out @param {number} id @param {ArrayLike<number>[]} parts */
function addSection(out, id, parts) {
  const length = parts.reduce((sum, part) => sum + part.length, 0);
  out.push(id, ...leb(length));
  for (const part of parts) for (let k = 0; k < part.length; k++) out.push(part[k]);
}

/** The bytes of a name. @param {string} name */
function text(name) {
  const bytes = new TextEncoder().encode(name);
  return [...leb(bytes.length), ...bytes];
}

/** Consecutive entries of a table. @param {Map<number, number>} table */
function runs(table) {
  /** @type {{ first: number, values: number[] }[]} */
  const found = [];
  for (const [slot, value] of [...table].sort(([a], [b]) => a - b)) {
    const last = found.at(-1);
    if (last && last.first + last.values.length === slot) last.values.push(value);
    else found.push({ first: slot, values: [value] });
  }
  return found;
}

/**
 * Lists of ranges as one, ascending, without overlaps.
 *
 * @param {number[][]} lists [start, length, start, length, …]
 * @returns {number[]}
 */
export function mergeRanges(lists) {
  const starts = lists.flatMap((list) =>
    list.flatMap((start, k) => (k % 2 === 0 ? [[start, start + list[k + 1]]] : [])),
  );
  /** @type {number[]} */
  const merged = [];
  let end = -1;
  for (const [start, stop] of starts.sort(([a], [b]) => a - b)) {
    if (start > end) merged.push(start, stop - start);
    else if (stop > end) merged[merged.length - 1] += stop - end;
    end = Math.max(end, stop);
  }
  return merged;
}

/**
 * The parts of a segment that are kept: the others are zero in the memory, as they are before the segment is copied there.
 *
 * @param {{ address: number, bytes: Uint8Array }} segment
 * @param {{ known: number[], wanted: number[] } | null} ranges
 */
function keptParts({ address, bytes }, ranges) {
  if (!ranges) return [{ address, bytes }];
  const kept = Uint8Array.from(bytes); // a copy, also of a Buffer
  const each = (/** @type {number[]} */ list, /** @type {(from: number, to: number) => void} */ act) => {
    for (let k = 0; k < list.length; k += 2) {
      const [from, to] = [Math.max(list[k] - address, 0), Math.min(list[k] + list[k + 1] - address, bytes.length)];
      if (from < to) act(from, to);
    }
  };
  each(ranges.known, (from, to) => kept.fill(0, from, to));
  each(ranges.wanted, (from, to) => kept.set(bytes.subarray(from, to), from));
  /** @type {{ address: number, bytes: Uint8Array }[]} */
  const parts = [];
  let from = 0;
  while (from < kept.length) {
    while (from < kept.length && kept[from] === 0) from++;
    let [to, at] = [from, from];
    while (at < kept.length && at - to < MIN_GAP) if (kept[at++] !== 0) to = at;
    if (to > from) parts.push({ address: address + from, bytes: kept.subarray(from, to) });
    from = at;
  }
  return parts;
}
