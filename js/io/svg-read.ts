// Parsing SVG path data; src/io/svg_read.rs gives the same messages and bit-identical paths.
import { CASE, CommandBuilder } from "./command-builder.js";
import { PathDataError, Scanner } from "./svg-number.js";

/** The number of arguments of a command, by the code of its letter; −1 for other characters. @internal */
export const ARGUMENT_COUNTS = argumentCounts();

function argumentCounts() {
  const counts = new Int8Array(128).fill(-1);
  for (const [letters, count] of [
    ["Z", 0],
    ["HV", 1],
    ["MLT", 2],
    ["SQ", 4],
    ["C", 6],
    ["A", 7],
  ] as [string, number][]) {
    for (const letter of letters + letters.toLowerCase()) counts[letter.charCodeAt(0)] = count;
  }
  return counts;
}

const [LINE, MOVE] = [76, 77];

/** The value of the CSS property `d` for no path. */
const NONE = /^[ \t\n\f\r]*none[ \t\n\f\r]*$/;

/**
 * Parses path data.
 *
 * @internal
 * @param tolerance the largest distance of cubics from the arcs; 0 for 1e-5 of the larger radius
 * @returns with an error, the path before it
 */
export function readSvg(
  d: string,
  tolerance: number,
): { packed: Float64Array; error: { offset: number; message: string } | null } {
  const scanner = new Scanner(d);
  const builder = new CommandBuilder(tolerance);
  let error: { offset: number; message: string } | null = null;
  try {
    if (!NONE.test(d)) read(scanner, builder);
  } catch (caught) {
    if (!(caught instanceof PathDataError)) throw caught;
    const { offset, expected } = caught;
    error = { offset, message: `d: expected ${expected} at offset ${offset}, got ${scanner.describe(offset)}` };
  }
  builder.end(false);
  return { packed: builder.packed(), error };
}

function read(scanner: Scanner, builder: CommandBuilder) {
  scanner.skipBlanks();
  for (let first = true; scanner.at < scanner.length; first = false) {
    const command = scanner.bytes[scanner.at];
    const count = command < 128 ? ARGUMENT_COUNTS[command] : -1;
    if (first && (command & ~CASE) !== MOVE) throw new PathDataError(scanner.at, '"M" or "m"');
    if (count < 0) throw new PathDataError(scanner.at, "a command");
    scanner.at++;
    scanner.skipBlanks();
    if (count > 0) readGroups(scanner, builder, command, count);
    else builder.close();
  }
}

/** Reads the arguments of a command, one or more groups of them. */
function readGroups(scanner: Scanner, builder: CommandBuilder, command: number, count: number) {
  const n = builder.args;
  do {
    const offset = scanner.at;
    for (let k = 0; k < count; k++) {
      if (k > 0) scanner.skipSeparator();
      n[k] = count === 7 && (k === 3 || k === 4) ? scanner.flag() : scanner.number();
    }
    if (!builder.draw(command)) throw new PathDataError(offset, "coordinates from -2^500 to 2^500");
    // Further groups after a moveto are linetos.
    if ((command & ~CASE) === MOVE) command -= MOVE - LINE;
  } while (scanner.skipSeparator() || scanner.atNumber());
}
