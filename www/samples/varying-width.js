import { Path } from "casteljau";

export function sample(print) {
  // A line of length 100. The radius grows from 10 to 40, so the width from 20 to 80.
  const line = Path.fromSVG("M0 0H100");
  const width = {
    stops: [
      [0, 20],
      [1, 80],
    ],
  };
  const outline = line.stroke(width, { cap: "round", tolerance: 1e-6 });

  // Two discs and the two common tangents: the sides turn from the line by α, where sin α = 30 / 100.
  const angle = Math.asin(0.3);
  const side = 100 * Math.cos(angle);
  const discs = (40 ** 2 * (Math.PI + 2 * angle) + 10 ** 2 * (Math.PI - 2 * angle)) / 2;
  print(`area ${outline.area().toFixed(3)}, exactly ${((10 + 40) * side + discs).toFixed(3)}`);

  // A leaf: no width at the ends, 8 in between, without corners in the width.
  const curve = Path.fromSVG("M8 30C20 0 40 50 52 12");
  const leaf = curve.stroke(
    {
      stops: [
        [0, 0],
        [0.4, 8],
        [1, 0],
      ],
      interpolation: "smooth",
    },
    { tolerance: 1e-4 },
  );
  print(`leaf: area ${leaf.area().toFixed(1)}`);
}
