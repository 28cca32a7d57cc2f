import { Curve } from "casteljau";

/** Draws by halving: `line` receives the pieces that are straight enough. */
function draw(curve, tolerance, line) {
  const c = curve.controlPoints();
  const leg = (a, b) => {
    return Math.hypot(c[2 * b] - c[2 * a], c[2 * b + 1] - c[2 * a + 1]);
  };
  const D1 = leg(0, 1) + leg(1, 2) + leg(2, 3);
  const D2 = leg(0, 3);
  if (D1 - D2 < tolerance) return line(curve);
  const [q, r] = curve.halve();
  draw(q, tolerance, line);
  draw(r, tolerance, line);
}

export function sample(print) {
  const curve = new Curve([
    [60, 400],
    [60, 20],
    [620, 20],
    [600, 400],
  ]);

  // D1 − D2 is not a distance. How far is the curve from the lines?
  for (const tolerance of [64, 8, 1, 0.125]) {
    let pieces = 0;
    let error = 0;
    draw(curve, tolerance, (piece) => {
      pieces += 1;
      const chord = new Curve([piece.eval(0), piece.eval(1)]);
      error = Math.max(error, piece.hausdorff(chord));
    });
    const needed = curve.flatten(error).ts.length - 1;
    print(`tolerance ${tolerance}: ${pieces} pieces`);
    print(`  error ${error.toFixed(3)}; flatten() needs ${needed}`);
  }
}
