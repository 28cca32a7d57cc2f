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
 */
export const unwrapCount = (count: number) => errors.unwrapCount(count, surfacesModule);

/**
 * @internal
 */
export const writeArguments = (numbers: Float64Array, extra?: number) =>
  transfer.writeArguments(numbers, extra, surfacesModule);

/**
 * @internal
 */
export const readResult = (from: number, to: number) => transfer.readResult(from, to, surfacesModule);

/**
 * @internal
 */
export const releaseMemory = () => transfer.releaseMemory(surfacesModule);
