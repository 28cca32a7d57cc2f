/**
 * Decodes the bytes of a wasm module from text. The encoder is `xtask/src/encode.rs`, which describes the format.
 *
 * @internal
 * @param alphabet the characters of the text, by rank
 * @param frequent the byte values that are encoded as one character, by rank
 * @param length the number of bytes
 */
export function decodeBytes(
  text: string,
  alphabet: string,
  frequent: ArrayLike<number>,
  length: number,
): Uint8Array<ArrayBuffer> {
  const { rank, value, rest } = decodingTables(alphabet, frequent);
  // This code runs once, before it is optimised: a short loop over bytes is faster than one over characters.
  const codes = new TextEncoder().encode(text);
  const bytes = new Uint8Array(length);
  for (let i = 0, k = 0; i < length; i++) {
    const byte = value[codes[k++]];
    bytes[i] = byte >= 0 ? byte : rest[~byte + rank[codes[k++]]];
  }
  return bytes;
}

/**
 * For each character its rank and its value: the byte that it encodes or, for a prefix, the complement of the first
 * index in `rest` that the prefix selects. `rest` holds the byte values that are encoded as two characters, in
 * ascending order.
 */
function decodingTables(alphabet: string, frequent: ArrayLike<number>) {
  const [rank, value] = [new Uint8Array(128), new Int32Array(128)];
  for (let i = 0; i < alphabet.length; i++) {
    const code = alphabet.charCodeAt(i);
    rank[code] = i;
    value[code] = i < frequent.length ? frequent[i] : ~((i - frequent.length) * alphabet.length);
  }
  const frequentBytes = new Set(Array.from(frequent));
  const rest = Array.from({ length: 256 }, (_, byte) => byte).filter((byte) => !frequentBytes.has(byte));
  return { rank, value, rest };
}
