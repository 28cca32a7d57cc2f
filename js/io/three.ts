// Meshes, paths and curves as objects of three.js. The caller passes its namespace, so this package does not depend on
// three.js.
import * as check from "../geometry/check.js";
import type { Point } from "../geometry/points.js";
import type { MeshArrays } from "./mesh-file.js";

/** The classes of three.js that are used: the namespace of three.js, or an object with these two. */
export interface Three<GeometryClass extends { new (): any; prototype: any } = { new (): any; prototype: any }> {
  /** Whose `prototype` is an instance for any type parameters (`InstanceType` would be one for their constraints) */
  BufferGeometry: GeometryClass;
  BufferAttribute: new (array: any, itemSize: number) => any;
}

/**
 * See `Mesh.toThree`.
 *
 * @internal
 */
export function meshToThree<GeometryClass extends { new (): any; prototype: any }>(
  { positions, normals, uvs, indices }: MeshArrays,
  THREE: Three<GeometryClass>,
): GeometryClass["prototype"] {
  requireClasses(THREE, ["BufferGeometry", "BufferAttribute"]);
  const geometry = new THREE.BufferGeometry();
  // WebGL has no f64 attributes.
  const floats = (list: Float32Array | Float64Array) => (list instanceof Float32Array ? list : Float32Array.from(list));
  geometry.setAttribute("position", new THREE.BufferAttribute(floats(positions), 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(floats(normals), 3));
  if (uvs) geometry.setAttribute("uv", new THREE.BufferAttribute(uvs, 2));
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  return geometry;
}

/** The classes of three.js that `Path.toThree` uses: the namespace of three.js, or an object with these two. */
export interface ThreeShapes<ShapeClass extends { new (): any; prototype: any } = { new (): any; prototype: any }> {
  Shape: ShapeClass;
  Path: { new (): any };
}

/**
 * The classes of three.js that `toThree` of a curve and a spline uses: the namespace of three.js, or an object with
 * these three.
 */
export interface ThreeCurves<CurveClass extends { prototype: any } = { prototype: any }> {
  Curve: CurveClass;
  Vector2: { new (x: number, y: number): any };
  Vector3: { new (x: number, y: number, z: number): any };
}

function requireClasses(THREE: any, names: readonly string[]) {
  if (names.every((name) => typeof THREE?.[name] === "function")) return;
  throw new TypeError(`THREE: expected the namespace of three.js, got ${check.describe(THREE)}`);
}

/**
 * The shapes of simple contours, each outer one followed by its holes.
 *
 * @internal
 */
export function contoursToThree<ShapeClass extends { new (): any; prototype: any }>(
  contours: readonly { area: () => number; trace: (target: any) => void }[],
  THREE: ThreeShapes<ShapeClass>,
): ShapeClass["prototype"][] {
  requireClasses(THREE, ["Shape", "Path"]);
  const shapes: ShapeClass["prototype"][] = [];
  for (const contour of contours) {
    const isOuter = contour.area() >= 0;
    const target = isOuter ? new THREE.Shape() : new THREE.Path();
    contour.trace(target);
    if (isOuter) shapes.push(target);
    else shapes.at(-1)?.holes.push(target);
  }
  return shapes;
}

/** What `toThree` needs of a curve or a spline. */
export interface Curved {
  dimension: 2 | 3;
  eval: (t: number) => Point;
  tangent: (t: number) => Point;
  length: () => number;
  timeAtLength: (s: number) => number;
}

/**
 * A curve of three.js with the points of a curve of this package.
 *
 * @internal
 * @param end the parameter of the end
 */
export function curveToThree<CurveClass extends { prototype: any }>(
  curve: Curved,
  end: number,
  THREE: ThreeCurves<CurveClass>,
): CurveClass["prototype"] {
  requireClasses(THREE, ["Curve", "Vector2", "Vector3"]);
  const vector = ({ x, y, z = 0 }: { x: number; y: number; z?: number }, target: any) =>
    target ? target.set(x, y, z) : curve.dimension === 2 ? new THREE.Vector2(x, y) : new THREE.Vector3(x, y, z);
  return Object.assign(new (THREE.Curve as any)(), {
    getPoint: (t: number, target: any) => vector(curve.eval(t * end), target),
    getTangent: (t: number, target: any) => vector(curve.tangent(t * end), target),
    getLength: () => curve.length(),
    getUtoTmapping: (u: number, distance: number | null | undefined) =>
      curve.timeAtLength(distance ?? u * curve.length()) / end,
  });
}
