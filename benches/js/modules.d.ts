// The peers have no types, or none of the entry points that the benchmarks use.

declare module "bezier-js" {
  type Point = { x: number; y: number };

  export class Bezier {
    constructor(coordinates: number[]);
    readonly points: Point[];
    readonly order: number;
    get(t: number): Point;
    getLUT(steps: number): Point[];
    split(t: number): { left: Bezier; right: Bezier };
    length(): number;
    offset(distance: number): Bezier[];
    project(point: Point): Point & { t: number; d: number };
    intersects(curve: Bezier): (string | number)[];
  }
}

declare module "paper/dist/paper-core.js" {
  class Size {
    constructor(width: number, height: number);
  }
  class Point {
    constructor(x: number, y: number);
    readonly x: number;
    readonly y: number;
    subtract(point: Point): Point;
  }
  class Curve {
    constructor(start: Point, handle1: Point, handle2: Point, end: Point);
    getIntersections(curve: Curve): { time: number }[];
  }
  class CompoundPath {
    constructor(pathData: string);
    readonly bounds: { left: number; top: number; right: number; bottom: number };
    readonly length: number;
    readonly area: number;
    readonly children?: Path[];
    pathData: string;
    fillRule: "nonzero" | "evenodd";
    unite(path: CompoundPath, options: { insert: boolean }): CompoundPath;
    clone(options: { insert: boolean }): CompoundPath;
    remove(): boolean;
  }
  class Path {
    constructor(content: string | { segments: number[][] });
    readonly length: number;
    readonly curves: unknown[];
    simplify(tolerance: number): boolean;
    remove(): boolean;
    getPointAt(offset: number): Point;
    getNearestLocation(point: number[]): { distance: number };
    contains(point: number[]): boolean;
  }
  const paper: {
    setup(size: Size): void;
    Size: typeof Size;
    Point: typeof Point;
    Curve: typeof Curve;
    CompoundPath: typeof CompoundPath;
    Path: typeof Path;
  };
  export default paper;
}

declare module "three/addons/geometries/TeapotGeometry.js" {
  type Attribute = { array: Float32Array };

  export class TeapotGeometry {
    constructor(
      size: number,
      segments: number,
      bottom: boolean,
      lid: boolean,
      body: boolean,
      fitLid: boolean,
      blinn: boolean,
    );
    readonly attributes: { position: Attribute; normal: Attribute };
    readonly index: Attribute | null;
  }
}

declare module "verb-nurbs" {
  type MeshData = { points: number[][]; uvs: number[][]; faces: number[][] };

  class AdaptiveRefinementOptions {
    minDivsU: number;
    minDivsV: number;
    normTol: number;
  }
  class NurbsSurface {
    static byKnotsControlPointsWeights(
      degreeU: number,
      degreeV: number,
      knotsU: number[],
      knotsV: number[],
      controlPoints: number[][][],
    ): NurbsSurface;
    tessellate(options: AdaptiveRefinementOptions): MeshData;
  }
  class NurbsCurve {
    static byKnotsControlPointsWeights(
      degree: number,
      knots: number[],
      controlPoints: number[][],
      weights: number[],
    ): NurbsCurve;
    point(u: number): number[];
    derivatives(u: number, order: number): number[][];
    length(): number;
    closestPoint(point: number[]): number[];
    closestParam(point: number[]): number;
    tessellate(tolerance: number): number[][];
  }
  class Circle extends NurbsCurve {
    constructor(center: number[], xAxis: number[], yAxis: number[], radius: number);
  }
  class SphericalSurface extends NurbsSurface {
    constructor(center: number[], radius: number);
  }
  class RevolvedSurface extends NurbsSurface {
    constructor(profile: NurbsCurve, center: number[], axis: number[], angle: number);
  }
  const verb: {
    geom: {
      Circle: typeof Circle;
      NurbsCurve: typeof NurbsCurve;
      NurbsSurface: typeof NurbsSurface;
      RevolvedSurface: typeof RevolvedSurface;
      SphericalSurface: typeof SphericalSurface;
    };
    eval: { AdaptiveRefinementOptions: typeof AdaptiveRefinementOptions };
  };
  export default verb;
}
