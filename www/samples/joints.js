import { Spline } from "casteljau";

const names = (of) => {
  const held = ["c0", "g1", "c1", "g2", "c2"].filter((name) => of[name]);
  return held.join(" ").toUpperCase();
};

export function sample(print) {
  // P2, P3, P4 lie on one line, but P3 is not the midpoint: G1, not C1.
  const first = [
    [70, 330],
    [90, 120],
    [210, 100],
    [330, 200],
  ];
  const second = [
    [390, 250],
    [520, 400],
    [600, 160],
  ];
  const spline = new Spline([...first, ...second]);
  print(`aligned: ${names(spline.continuity(1))}`);

  const [before, after] = spline.segments();
  const speed = (v) => Math.hypot(v.x, v.y).toFixed(1);
  const [a, b] = [before.derivativeAt(1), after.derivativeAt(0)].map(speed);
  print(`speed at P3: ${a} before, ${b} after`);

  for (const mode of ["c1", "g2", "c2"]) {
    const set = spline.setJoint(1, mode);
    print(`set to ${mode.toUpperCase()}: ${names(set.continuity(1))}`);
  }

  // Move P2 and keep the joint C1: P4 moves as well.
  const held = spline.setJoint(1, "c1");
  const moved = held.movePoint(2, [230, 60], { joints: ["free", "c1"] });
  const [x, y] = moved.controlPoints().subarray(8, 10);
  print(`P4 is now (${x}, ${y})`);
}
