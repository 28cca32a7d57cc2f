import { Surface } from "casteljau";

export function sample(print) {
  const text = "1\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n"; // one patch of degree 1 × 1 and its points
  const saddle = Surface.parse(text);
  print(`area ${saddle.area().toFixed(6)}`);
  const mesh = saddle.tessellate({ segments: 8 });
  print(
    `OBJ: ${
      mesh
        .toOBJ()
        .split("\n")
        .filter((line) => line.startsWith("f ")).length
    } faces`,
  );
  print(`STL: ${mesh.toSTL().length} bytes`);
  print(`GLB: ${new TextDecoder().decode(mesh.toGLB().subarray(0, 4))}`);
}
