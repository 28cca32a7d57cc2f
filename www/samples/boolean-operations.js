import { Path } from "casteljau";

export function sample(print) {
  const a = Path.fromSVG("M0 0H4V4H0Z");
  const b = Path.fromSVG("M2 2H6V6H2Z");
  const area = (path) => path.area().toFixed(1);
  print(`union ${area(a.union(b))}`);
  print(`intersection ${area(a.intersect(b))}`);
  print(`difference ${area(a.subtract(b))}`);
  print(`exclusive or ${area(a.exclude(b))}`);

  // The faces into which both outlines divide the plane.
  const texts = Path.faces([a, b]).map(({ path, inside: [inA, inB] }) => {
    const where = inA && inB ? "both" : inA ? "A" : "B";
    return `${where} ${area(path)}`;
  });
  print(`faces: ${texts.sort().join(", ")}`);
}
