// The ways to the module of surfaces, by the names that the ways to that of curves have.
import * as init from "./init.js";
import * as refusal from "./errors.js";
import { surfaces } from "./surfaces-module.js";
import * as transfer from "./transfer.js";

/**
 * @internal
 */
export const core = () => init.core(surfaces);

/**
 * @internal
 * @param {number} count
 */
export const done = (count) => refusal.done(count, surfaces);

/**
 * @internal
 * @param {Float64Array} flat
 * @param {number} [extra]
 */
export const load = (flat, extra) => transfer.load(flat, extra, surfaces);

/**
 * @internal
 * @param {number} from
 * @param {number} to
 */
export const take = (from, to) => transfer.take(from, to, surfaces);

/**
 * @internal
 */
export const trim = () => transfer.trim(surfaces);
