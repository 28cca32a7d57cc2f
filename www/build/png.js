// Writes small pictures as PNG with a palette.
import { crc32, deflateSync } from "node:zlib";

const SIGNATURE = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
const MAX_COLOURS = 256;
const [DEPTH, INDEXED] = [8, 3];

/** @param {string} type @param {Uint8Array} content */
function chunk(type, content) {
  const named = Buffer.concat([Buffer.from(type, "latin1"), content]);
  const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(content.length);
  sum.writeUInt32BE(crc32(named));
  return Buffer.concat([length, named, sum]);
}

/**
 * @param {Uint8Array} pixels RGB
 * @param {number} width
 * @param {number} height
 * @param {{ step: number, exact: number[] }} options channels are rounded to multiples of `step`, except those of the colour `exact`
 */
export function indexedPng(pixels, width, height, { step, exact }) {
  const key = (/** @type {number} */ r, /** @type {number} */ g, /** @type {number} */ b) => (r << 16) | (g << 8) | b;
  const exactKey = key(exact[0], exact[1], exact[2]);
  const rounded = (/** @type {number} */ x) => Math.min(255, step * Math.round(x / step));
  const keys = Uint32Array.from({ length: width * height }, (_, i) => {
    const [r, g, b] = pixels.subarray(3 * i, 3 * i + 3);
    return key(r, g, b) === exactKey ? exactKey : key(rounded(r), rounded(g), rounded(b));
  });
  /** @type {Map<number, number>} */
  const counts = new Map();
  for (const each of keys) counts.set(each, (counts.get(each) ?? 0) + 1);
  const palette = [...counts.keys()].sort((a, b) => (counts.get(b) ?? 0) - (counts.get(a) ?? 0)).slice(0, MAX_COLOURS);
  const channels = (/** @type {number} */ colour) => [colour >> 16, (colour >> 8) & 255, colour & 255];
  const nearest = (/** @type {number} */ colour) => {
    const at = channels(colour);
    const distances = palette.map((other) => Math.hypot(...channels(other).map((x, k) => x - at[k])));
    return distances.indexOf(Math.min(...distances));
  };
  const indices = new Map([...counts.keys()].map((colour) => [colour, nearest(colour)]));
  const rows = new Uint8Array(height * (width + 1)); // each row begins with its filter, 0
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) rows[y * (width + 1) + x + 1] = indices.get(keys[y * width + x]) ?? 0;
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([DEPTH, INDEXED], 8);
  return Buffer.concat([
    SIGNATURE,
    chunk("IHDR", header),
    chunk("PLTE", Uint8Array.from(palette.flatMap(channels))),
    chunk("IDAT", deflateSync(rows, { level: 9 })),
    chunk("IEND", new Uint8Array()),
  ]);
}
