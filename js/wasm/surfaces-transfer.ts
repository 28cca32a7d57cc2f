// The functions of transfer.js, init.js and errors.js, applied to the module of surfaces.
import * as errors from "./errors.js";
import * as init from "./init.js";
import { surfacesModule } from "./surfaces-module.js";
import * as transfer from "./transfer.js";

/**
 * The functions of the module of surfaces, see `core` in init.ts.
 *
 * @internal
 */
export const core = () => init.core(surfacesModule);

/**
 * See `unwrapCount` in errors.ts.
 *
 * @internal
 */
export const unwrapCount = (count: number) => errors.unwrapCount(count, surfacesModule);

/**
 * See `writeArguments` in transfer.ts.
 *
 * @internal
 */
export const writeArguments = (numbers: Float64Array, extra?: number) =>
  transfer.writeArguments(numbers, extra, surfacesModule);

/**
 * See `readResult` in transfer.ts.
 *
 * @internal
 */
export const readResult = (from: number, to: number) => transfer.readResult(from, to, surfacesModule);

/**
 * See `releaseMemory` in transfer.ts.
 *
 * @internal
 */
export const releaseMemory = () => transfer.releaseMemory(surfacesModule);
