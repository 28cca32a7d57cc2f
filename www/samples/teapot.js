import { Surface } from "casteljau";

export function sample(print) {
  const pot = Surface.teapot();
  const newells = Surface.teapot({ height: "original" });
  const only = (part) => ({
    rim: false,
    body: false,
    handle: false,
    spout: false,
    lid: false,
    bottom: false,
    [part]: true,
  });
  print(`${pot.patchCount} patches, ${pot.vertices.length / 3} points`);
  for (const part of ["rim", "body", "handle", "spout", "lid", "bottom"]) {
    print(`${part}: ${Surface.teapot(only(part)).patchCount}`);
  }
  print(`height ${pot.bounds().max.z}, Newell's ${newells.bounds().max.z}`);
}
