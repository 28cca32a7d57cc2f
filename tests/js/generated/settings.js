// What the environment asks for; tests/generated/runner.rs reads the same variables.

/** Those after the 2,000 of tests/generated, so that both together make different calls. */
const FIRST = 2_000;
const CASES = 50;
const FEW_CASES = 6;
const DEEP_CASES = 500;

const { CASTELJAU_SEED, CASTELJAU_CASES, CASTELJAU_DEEP, CASTELJAU_FEW, CASTELJAU_ONLY } = process.env;
const [, only, number] = CASTELJAU_ONLY?.match(/^(.*?)(?::(\d+))?$/) ?? [];
const plain = (name) => name.replace(/[^a-z0-9]/gi, "").toLowerCase();

export const seed = Number(CASTELJAU_SEED ?? 11);
/** The first case and their number. */
export const range =
  number === undefined
    ? [FIRST, Number(CASTELJAU_CASES ?? (CASTELJAU_DEEP ? DEEP_CASES : CASTELJAU_FEW ? FEW_CASES : CASES))]
    : [Number(number), 1];
/** Whether a function is asked for. @param {string} row */
export const isWanted = (row) => only === undefined || plain(only) === plain(row);
