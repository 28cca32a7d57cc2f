// Paths and curves as objects of three.js.
import assert from "node:assert/strict";
import { test } from "node:test";
import * as THREE from "three";
import { Curve, Path, Spline } from "casteljau";

test("a path gives one shape for each outer contour, with its holes", () => {
  const path = Path.fromSVG("M0 0H4V4H0Z M1 1H3V3H1Z M6 0H8V2H6Z M1.5 1.5H2.5V2.5H1.5Z");
  const shapes = path.toThree(THREE, { fillRule: "evenodd" });
  assert.deepEqual(shapes.map(({ holes }) => holes.length).sort(), [0, 0, 1]);
  const area = (points) => Math.abs(THREE.ShapeUtils.area(points));
  const total = shapes.reduce(
    (sum, shape) =>
      sum + area(shape.getPoints()) - shape.holes.reduce((holes, hole) => holes + area(hole.getPoints()), 0),
    0,
  );
  assert.equal(total, path.area({ fillRule: "evenodd" }));
  const geometry = new THREE.ExtrudeGeometry(shapes, { depth: 1, bevelEnabled: false });
  assert.ok(geometry.getAttribute("position").count > 0);
  assert.equal(Path.circle([0, 0], 1).toThree(THREE)[0].curves.length, 8);
  assert.deepEqual(new Path([]).toThree(THREE), []);
});

test("curves and splines as curves of three.js, with exact lengths", () => {
  const plane = new Curve([0, 0, 1, 2, 3, 0]);
  const space = new Spline([
    [0, 0, 0],
    [1, 1, 1],
    [2, 2, 0],
    [3, 0, 0],
    [4, -2, 0],
    [5, 0, 0],
    [6, 0, 1],
  ]);
  for (const [curve, end] of /** @type {[any, number][]} */ ([
    [plane, 1],
    [space, 2],
  ])) {
    const three = curve.toThree(THREE);
    assert.ok(three instanceof THREE.Curve);
    const { x, y, z = undefined } = curve.eval(0.3 * end);
    const point = three.getPoint(0.3);
    assert.deepEqual([point.x, point.y, point.z], [x, y, z]);
    assert.equal(point.isVector3 ?? false, curve.dimension === 3);
    assert.equal(three.getLength(), curve.length());
    const middle = three.getPointAt(0.5);
    assert.ok(Math.abs(curve.pointAtLength(curve.length() / 2).point.x - middle.x) < 1e-9);
    const target = new THREE.Vector3(9, 9, 9);
    assert.equal(three.getTangent(0.5, target), target);
    assert.ok(Math.abs(target.length() - 1) < 1e-12);
  }
  const tube = new THREE.TubeGeometry(space.toThree(THREE), 16, 0.1);
  assert.ok([...tube.getAttribute("position").array].every(Number.isFinite));
  assert.throws(() => plane.toThree(/** @type {any} */ (null)), {
    message: "THREE: expected the namespace of three.js, got null",
  });
});
