/**
 * Turns text back into the bytes it was made from; `xtask/src/encode.rs` is the other half and explains the form.
 *
 * @internal
 * @param {string} text
 * @param {string} alphabet the characters of the text, by rank
 * @param {ArrayLike<number>} frequent the byte values that take one character, by rank
 * @param {number} length the number of bytes
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function decode(text, alphabet, frequent, length) {
  const { rank, value, rest } = tables(alphabet, frequent);
  // The loop runs cold, so it is short, and reads bytes rather than characters.
  const codes = new TextEncoder().encode(text);
  const bytes = new Uint8Array(length);
  for (let i = 0, k = 0; i < length; i++) {
    const byte = value[codes[k++]];
    bytes[i] = byte >= 0 ? byte : rest[~byte + rank[codes[k++]]];
  }
  return bytes;
}

/**
 * For each character: its rank, and its byte where it is one; of a prefix the complement of the first place in `rest`
 * that it leads to. `rest` are the byte values that take two characters, in ascending order.
 *
 * @param {string} alphabet
 * @param {ArrayLike<number>} frequent
 */
function tables(alphabet, frequent) {
  const [rank, value] = [new Uint8Array(128), new Int32Array(128)];
  for (let i = 0; i < alphabet.length; i++) {
    const code = alphabet.charCodeAt(i);
    rank[code] = i;
    value[code] = i < frequent.length ? frequent[i] : ~((i - frequent.length) * alphabet.length);
  }
  const taken = new Set(Array.from(frequent));
  const rest = Array.from({ length: 256 }, (_, byte) => byte).filter((byte) => !taken.has(byte));
  return { rank, value, rest };
}
