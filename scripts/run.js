// Running programs from the root of the repository. Within `logged` their output goes to a log, else to the terminal.
import { AsyncLocalStorage } from "node:async_hooks";
import { spawn } from "node:child_process";
import { mkdir, open, readFile, rm } from "node:fs/promises";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("..", import.meta.url)).replace(/[\\/]$/, "");

/** The output folder of cargo. */
export const target = fileURLToPath(
  new URL(`${process.env.CARGO_TARGET_DIR ?? "target"}/`, new URL("../", import.meta.url)),
).replace(/[\\/]$/, "");

/** What runs now. @type {Set<import("node:child_process").ChildProcess>} */
const children = new Set();
process.once("exit", () => {
  for (const child of children) child.kill();
});
for (const signal of /** @type {const} */ (["SIGINT", "SIGTERM"])) process.once(signal, () => process.exit(1));

/** @type {AsyncLocalStorage<string[]>} */
const logs = new AsyncLocalStorage();

/**
 * Runs `act`; the output of the programs that it starts is put into a list of texts.
 *
 * @template T
 * @param {string[]} log
 * @param {() => Promise<T>} act
 */
export const logged = (log, act) => logs.run(log, act);

/** Prints a line: into the log, if there is one. @param {string} line */
export function say(line) {
  const log = logs.getStore();
  if (log) log.push(`${line}\n`);
  else console.log(line);
}

/**
 * Runs a program and fails if it ends badly.
 *
 * @param {string} program
 * @param {readonly string[]} words
 * @param {{ env?: Record<string, string | undefined>, silence?: number }} [options] env: further variables, or undefined ones to
 *   remove; silence: milliseconds without output after which the program counts as one that hangs, in a log
 */
export async function run(program, words, { env = {}, silence } = {}) {
  const line = [program, ...words].join(" ");
  const log = logs.getStore();
  const child = spawn(program, words, {
    cwd: root,
    env: { ...process.env, ...env },
    stdio: log ? ["ignore", "pipe", "pipe"] : "inherit",
    shell: process.platform === "win32" && program === "npm",
  });
  children.add(child);
  let hangs = false;
  /** @type {NodeJS.Timeout | undefined} */
  let timer;
  const listen = () => {
    clearTimeout(timer);
    if (silence) timer = setTimeout(() => (hangs = child.kill("SIGKILL")), silence);
  };
  for (const stream of log ? [child.stdout, child.stderr] : [])
    stream?.setEncoding("utf8").on("data", (text) => {
      log?.push(text);
      listen();
    });
  if (log) listen();
  try {
    const [code, signal] = await new Promise((resolve, reject) => {
      child.once("error", (cause) => reject(new Error(`could not start ${program}`, { cause })));
      child.once("close", (...ended) => resolve(ended));
    });
    if (hangs) throw new Error(`${line}: no output for ${(silence ?? 0) / 1000} s`);
    if (code !== 0) throw new Error(`${line} ended with ${code ?? signal}`);
  } finally {
    clearTimeout(timer);
    children.delete(child);
  }
}

/**
 * The output of a program, trimmed; undefined if it cannot be started or ends badly.
 *
 * @param {string} program
 * @param {readonly string[]} words
 * @param {Record<string, string>} [env]
 * @returns {Promise<string | undefined>}
 */
export function outputOf(program, words, env = {}) {
  return new Promise((resolve) => {
    const child = spawn(program, words, {
      cwd: root,
      env: { ...process.env, ...env },
      stdio: ["ignore", "pipe", "ignore"],
    });
    let text = "";
    child.stdout.setEncoding("utf8").on("data", (part) => (text += part));
    child.once("error", () => resolve(undefined));
    child.once("close", (code) => resolve(code === 0 ? text.trim() : undefined));
  });
}

export const node = (/** @type {string[]} */ ...words) => run(process.execPath, words);
export const cargo = (/** @type {string[]} */ ...words) => run("cargo", words);

/** Runs all of these, also after a failure; fails with the messages of all. @param {(() => Promise<unknown>)[]} acts */
export async function runAll(acts) {
  /** @type {string[]} */
  const messages = [];
  for (const act of acts)
    await act().catch((/** @type {Error} */ error) => {
      messages.push(error.message);
    });
  if (messages.length > 0) throw new Error(messages.join("; "));
}

/**
 * Waits until no other script has this lock, runs `act` and releases it.
 *
 * @template T
 * @param {string} name
 * @param {() => Promise<T>} act
 */
export async function alone(name, act) {
  const path = `${target}/scripts/${name}.lock`;
  await mkdir(`${target}/scripts`, { recursive: true });
  for (;;) {
    const file = await open(path, "wx").catch(() => undefined);
    if (file) {
      await file.writeFile(String(process.pid));
      await file.close();
      break;
    }
    const owner = Number(await readFile(path, "utf8").catch(() => "")) || 0;
    if (owner && !isRunning(owner)) await rm(path, { force: true });
    await new Promise((done) => setTimeout(done, 200));
  }
  try {
    return await act();
  } finally {
    await rm(path, { force: true });
  }
}

/** @param {number} pid */
function isRunning(pid) {
  try {
    return process.kill(pid, 0);
  } catch {
    return false;
  }
}
