// The program of tests/generator, which makes the cases for both languages.
import { execFileSync } from "node:child_process";

const MOST_BYTES = 2 ** 30;

/** Builds the program and gives its path. CASTELJAU_GENERATOR may name one that is built already. */
export function generatorPath() {
  if (process.env.CASTELJAU_GENERATOR) return process.env.CASTELJAU_GENERATOR;
  const build = [
    "build",
    "--quiet",
    "--profile",
    "xtask",
    "--package",
    "casteljau-generator",
    "--message-format",
    "json",
  ];
  const messages = execFileSync("cargo", build, {
    encoding: "utf8",
    maxBuffer: MOST_BYTES,
    stdio: ["ignore", "pipe", "inherit"],
  });
  const paths = messages
    .split("\n")
    .filter(Boolean)
    .map((line) => JSON.parse(line).executable);
  const path = paths.filter(Boolean).at(-1);
  if (!path) throw new Error("cargo built no program casteljau-generator");
  return path;
}

/** The lines of some cases. @param {string} path @param {(string | number)[]} request seed, function, first, count */
export function lines(path, ...request) {
  const text = execFileSync(path, request.map(String), { encoding: "utf8", maxBuffer: MOST_BYTES });
  return text.split("\n").filter(Boolean);
}

/** The name of a function in the generator's table. */
export const rowOf = (name) =>
  name
    .replace("constructor", "new")
    .replace(/\.equals$/, ".approx_eq")
    .replace(/^easing$/, "Easing.eval")
    .replace(/^Easing\.toLinear$/, "Easing.to_linear");
