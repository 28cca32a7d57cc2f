// Surfaces from files, and meshes to files.
import { Mesh, Surface } from "../../surfaces.js";

/** Longer files are refused unread: a browser would stand still over them. */
const MAX_BYTES = 16e6;
/** More cannot be drawn at sixty frames a second. */
const MAX_PATCHES = 20_000;
const MEGABYTE = 1e6;

/**
 * The surface in a file.
 *
 * @throws {RangeError} says what is wrong with the file
 */
export async function surfaceIn(file: File): Promise<Surface> {
  if (file.size > MAX_BYTES) {
    throw new RangeError(`expected at most ${MAX_BYTES / MEGABYTE} MB, got ${(file.size / MEGABYTE).toFixed(1)} MB`);
  }
  const surface = Surface.parse(await file.text());
  if (surface.patchCount === 0) throw new RangeError("expected patches, got none");
  if (surface.patchCount > MAX_PATCHES)
    throw new RangeError(`expected at most ${MAX_PATCHES} patches, got ${surface.patchCount}`);
  return surface;
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
  const turn = (numbers: Float32Array | Float64Array) =>
    numbers.map((x, i) => (i % 3 === 0 ? x : i % 3 === 1 ? numbers[i + 1] : -numbers[i - 1]));
  return new Mesh({ ...mesh, positions: turn(mesh.positions), normals: turn(mesh.normals) });
}
