// easing.from and easing.spring, compared with their functions.
import assert from "node:assert/strict";
import { test } from "node:test";
import { easing } from "casteljau";

/** The largest difference of two functions on 0 to 1, at places that are not those of the samples. */
function difference(a, b) {
  let worst = 0;
  for (let k = 0; k <= 7_919; k++) worst = Math.max(worst, Math.abs(a(k / 7_919) - b(k / 7_919)));
  return worst;
}

test("smooth functions are kept within the tolerance, with few stops", () => {
  const functions = [(x) => x ** 3, (x) => Math.sin(9 * x), (x) => 5 + 2 * x, Math.sqrt, (x) => Math.exp(-50 * x)];
  for (const f of functions) {
    for (const tolerance of [0.1, 0.01, 0.002]) {
      const ease = easing.from(f, { tolerance: tolerance * 7 });
      assert.ok(difference(ease, f) <= tolerance * 7, `${f} ${tolerance}`);
      assert.equal(easing(ease.css).css, ease.css);
    }
  }
  assert.equal(easing.from((x) => x).css, "linear");
  assert.ok(easing.from((x) => x * x).css.split(",").length < 16);
});

test("a jump becomes a steep line", () => {
  const ease = easing.from((x) => (x < 0.3 ? 0 : 1), { tolerance: 0.01 });
  assert.ok(ease(0.299_99) < 0.01 && ease(0.300_01) > 0.99);
});

test("a timing function of CSS can be approximated again", () => {
  const original = easing("ease-in-out");
  assert.ok(difference(easing.from(original, { tolerance: 0.001 }), original) <= 0.001);
});

/** The motion of a spring by 200,000 steps of the Runge–Kutta method. */
function simulated({ mass = 1, stiffness = 100, damping = 10, velocity = 0 }, seconds) {
  const steps = 200_000;
  const h = seconds / steps;
  const force = (x, v) => (-stiffness * (x - 1) - damping * v) / mass;
  let [x, v] = [0, velocity];
  const xs = [x];
  for (let k = 0; k < steps; k++) {
    const [a1, v1] = [force(x, v), v];
    const [a2, v2] = [force(x + (h / 2) * v1, v + (h / 2) * a1), v + (h / 2) * a1];
    const [a3, v3] = [force(x + (h / 2) * v2, v + (h / 2) * a2), v + (h / 2) * a2];
    const [a4, v4] = [force(x + h * v3, v + h * a3), v + h * a3];
    x += (h / 6) * (v1 + 2 * v2 + 2 * v3 + v4);
    v += (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4);
    xs.push(x);
  }
  return (part) => xs[Math.round(part * steps)];
}

test("springs follow the equation of motion, below, at and above critical damping", () => {
  const springs = [
    {},
    { velocity: 20 },
    { velocity: -5, damping: 4 },
    { damping: 20 },
    { damping: 20 * (1 + 1e-7) },
    { damping: 30 },
    { damping: 300, velocity: 3 },
    { mass: 3, stiffness: 40, damping: 2 },
  ];
  for (const options of springs) {
    const spring = easing.spring(options);
    const motion = simulated(options, spring.duration / 1000);
    assert.ok(difference(spring, (x) => (x === 1 ? 1 : motion(x))) <= 0.0021, JSON.stringify(options));
    assert.ok(Math.abs(motion(1) - 1) <= 0.0021 && spring(1) === 1);
    assert.ok(`${spring}`.startsWith("linear("));
  }
});

test("a spring has settled after its duration, and not long before it", () => {
  const spring = easing.spring({ tolerance: 0.01 });
  const motion = simulated({}, (3 * spring.duration) / 1000);
  for (let part = 1 / 3; part <= 1; part += 0.001) assert.ok(Math.abs(motion(part) - 1) <= 0.0101);
  assert.ok(spring.duration > 800 && spring.duration < 1000);
});

test("errors", () => {
  const refused = (act, message) => assert.throws(act, { message });
  refused(() => easing.from(/** @type {any} */ ("ease")), "f: expected a function, got string");
  refused(() => easing.from((x) => 1 / (x - 0.5)), "f(0.5): expected a finite number, got Infinity");
  refused(
    () => easing.from((x) => x, { tolerance: 1e-5 }),
    "tolerance: expected at least 0.0001 of the largest output, got 0.00001",
  );
  refused(() => easing.spring({ mass: 0 }), "mass: expected a number above 0, got 0");
  refused(() => easing.spring({ velocity: NaN }), "velocity: expected a finite number, got NaN");
  refused(() => easing.spring(/** @type {any} */ ({ bounce: 1 })), /^bounce: unknown option; expected mass, /);
  refused(() => easing.spring({ damping: 1e-3 }), /^damping: expected a spring that settles within 100 oscillations/);
});
