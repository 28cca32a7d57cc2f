// Bytes as text that gzip compresses well; js/wasm/decode-bytes.ts is the decoder, and xtask/src/encode.rs, which gives the
// same text, describes the format.

/** Printable characters that need no escape in any JavaScript string literal or in a script element. */
const ALPHABET = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789!#%&()*+,-./:;=>?@[]^_{|}~";
/** The number of byte values that are encoded as one character; the characters after the first 60 are prefixes. */
const SINGLES = 60;

/**
 * @param {Uint8Array} bytes
 * @returns {{ alphabet: string, frequent: number[], length: number, text: string }} what the decoder takes
 */
export function encode(bytes) {
  const counts = new Uint32Array(256);
  for (const byte of bytes) counts[byte]++;
  const ranked = Array.from(counts.keys()).sort((a, b) => counts[b] - counts[a] || a - b);
  const frequent = ranked.slice(0, SINGLES);
  const rest = ranked.slice(SINGLES).sort((a, b) => a - b);
  /** @type {string[]} */
  const codes = [];
  frequent.forEach((byte, rank) => {
    codes[byte] = ALPHABET[rank];
  });
  rest.forEach((byte, k) => {
    codes[byte] = ALPHABET[SINGLES + Math.floor(k / ALPHABET.length)] + ALPHABET[k % ALPHABET.length];
  });
  return {
    alphabet: ALPHABET,
    frequent,
    length: bytes.length,
    text: Array.from(bytes, (byte) => codes[byte]).join(""),
  };
}
