// Makes the mathematics font of the site: Noto Sans Math (OFL 1.1) with the characters that the formulas use. The table MATH is
// kept, by which browsers stretch brackets and sums.
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import subsetFont from "subset-font";

const FONT = "@fontsource/noto-sans-math/files/noto-sans-math-latin-400-normal.woff2";
export const MATH_FONT = new URL("../../target/site/math.woff2", import.meta.url); // site.css refers to it
/** Figures with formulas of their own (bezier-equation) use these. */
const ALWAYS = "0123456789.()+-−=·BPtij√"; // and roots, which are elements

/** @param {Iterable<string>} pages HTML */
export async function makeMathFont(pages) {
  const font = await readFile(createRequire(import.meta.url).resolve(FONT));
  await mkdir(new URL(".", MATH_FONT), { recursive: true });
  await writeFile(MATH_FONT, await subsetFont(font, charactersOf(pages), { targetFormat: "woff2" }));
}

/** A plugin for Vite: the license has to accompany the font. @type {import("vite").Plugin} */
export const mathFontLicense = {
  name: "math-font-license",
  async generateBundle() {
    const file = createRequire(import.meta.url).resolve("@fontsource/noto-sans-math/LICENSE");
    this.emitFile({ type: "asset", fileName: "assets/noto-sans-math-license.txt", source: await readFile(file) });
  },
};

/** All characters of formulas; single letters as browsers show them in `<mi>`: italic. @param {Iterable<string>} pages */
export function charactersOf(pages) {
  const characters = new Set(ALWAYS);
  for (const html of pages) {
    for (const [formula] of html.matchAll(/<math.*?<\/math>/gs))
      for (const character of formula.replace(/<[^>]*>/g, "").replace(/&\w+;/g, "")) characters.add(character);
  }
  return [...characters, ...[...characters].map(italic)].join("");
}

/** The italic form of a letter (Mathematical Alphanumeric Symbols). @param {string} letter */
function italic(letter) {
  if (letter === "h") return "ℎ";
  const code = letter.codePointAt(0) ?? 0;
  if (/^[A-Z]$/.test(letter)) return String.fromCodePoint(0x1d434 + code - 0x41);
  if (/^[a-z]$/.test(letter)) return String.fromCodePoint(0x1d44e + code - 0x61);
  if (/^[α-ω]$/.test(letter)) return String.fromCodePoint(0x1d6fc + code - 0x3b1);
  return letter;
}
