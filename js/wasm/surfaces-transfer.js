// The functions of transfer.js, init.js and errors.js, applied to the module of surfaces.
import * as errors from "./errors.js";
import * as init from "./init.js";
import { surfacesModule } from "./surfaces-module.js";
import * as transfer from "./transfer.js";

/**
 * @internal
 */
export const core = () => init.core(surfacesModule);

/**
 * @internal
 * @param {number} count
 */
export const unwrapCount = (count) => errors.unwrapCount(count, surfacesModule);

/**
 * @internal
 * @param {Float64Array} numbers
 * @param {number} [extra]
 */
export const writeArguments = (numbers, extra) => transfer.writeArguments(numbers, extra, surfacesModule);

/**
 * @internal
 * @param {number} from
 * @param {number} to
 */
export const readResult = (from, to) => transfer.readResult(from, to, surfacesModule);

/**
 * @internal
 */
export const releaseMemory = () => transfer.releaseMemory(surfacesModule);
