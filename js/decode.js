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
  const rank = new Uint8Array(128);
  for (let i = 0; i < alphabet.length; i++) rank[alphabet.charCodeAt(i)] = i;
  const rest = otherBytes(frequent);
  const bytes = new Uint8Array(length);
  for (let i = 0, k = 0; i < length; i++) {
    const first = rank[text.charCodeAt(k++)];
    bytes[i] =
      first < frequent.length
        ? frequent[first]
        : rest[(first - frequent.length) * alphabet.length + rank[text.charCodeAt(k++)]];
  }
  return bytes;
}

/**
 * The byte values that are not frequent, in ascending order.
 *
 * @param {ArrayLike<number>} frequent
 * @returns {number[]}
 */
function otherBytes(frequent) {
  const taken = new Set(Array.from(frequent));
  return Array.from({ length: 256 }, (_, byte) => byte).filter((byte) => !taken.has(byte));
}
