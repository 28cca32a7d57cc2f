import { Surface } from "casteljau";

export function sample(print) {
  const lid = Surface.teapot().patch(20);
  for (const v of [0, 0.5, 1]) {
    const { u: along, v: across } = lid.partials(0.5, v);
    const lengths = [along, across].map(({ x, y, z }) => Math.hypot(x, y, z).toFixed(3));
    const { z } = lid.normal(0.5, v);
    print(`v = ${v}: |Su| = ${lengths[0]}, |Sv| = ${lengths[1]}, normal z = ${z.toFixed(3)}`);
  }
}
