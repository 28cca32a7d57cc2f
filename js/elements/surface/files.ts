// Surfaces from files, and meshes to files.
import { Mesh, Surface } from "../../surfaces.js";
import { missing } from "../loading.js";
import type { Rational } from "./loading.js";

/** Longer files are refused unread: a browser would stand still over them. */
const MAX_BYTES = 16e6;
/** More cannot be drawn at sixty frames a second. */
const MAX_PATCHES = 20_000;
const MEGABYTE = 1e6;
/** A row of weights. */
const WEIGHTS = /^[ \t]*w[ \t]/m;

/**
 * The surface in a file.
 *
 * @param loadRational fetches what reads weights; null where it cannot be fetched
 * @throws {RangeError} says what is wrong with the file
 */
export async function surfaceIn(file: File, loadRational: () => Promise<Rational | null>): Promise<Surface> {
  if (file.size > MAX_BYTES) {
    throw new RangeError(`expected at most ${MAX_BYTES / MEGABYTE} MB, got ${(file.size / MEGABYTE).toFixed(1)} MB`);
  }
  const text = await file.text();
  const surface = WEIGHTS.test(text) ? withWeights(await loadRational(), text) : Surface.parse(text);
  if (surface.patchCount === 0) throw new RangeError("expected patches, got none");
  if (surface.patchCount > MAX_PATCHES)
    throw new RangeError(`expected at most ${MAX_PATCHES} patches, got ${surface.patchCount}`);
  return surface;
}

function withWeights(rational: Rational | null, text: string) {
  if (!rational) throw new Error(missing());
  return rational.parsedSurface(text);
}

/**
 * A mesh as a file.
 *
 * @param up of the mesh; readers of glTF take y as up
 */
export function meshFile(mesh: Mesh, kind: "obj" | "stl" | "glb", up: "z" | "y"): Blob {
  if (kind === "obj") return new Blob([mesh.toOBJ()], { type: "model/obj" });
  if (kind === "stl") return new Blob([mesh.toSTL()], { type: "model/stl" });
  return new Blob([(up === "z" ? raised(mesh) : mesh).toGLB()], { type: "model/gltf-binary" });
}

/** From z up to y up: (x, y, z) → (x, z, −y). */
function raised(mesh: Mesh) {
  const rotated = (numbers: Float32Array | Float64Array) =>
    numbers.map((x, i) => (i % 3 === 0 ? x : i % 3 === 1 ? numbers[i + 1] : -numbers[i - 1]));
  return new Mesh({ ...mesh, positions: rotated(mesh.positions), normals: rotated(mesh.normals) });
}
