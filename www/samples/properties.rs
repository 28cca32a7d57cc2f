use casteljau::Curve;
use casteljau::glam::{DAffine2, DVec2, DVec3};

pub(crate) fn sample(out: &mut String) {
    // A curve in space. Its velocities at the ends are 3(P1 − P0) and 3(P3 − P2).
    let points = [
        [0.0, 2.0, 3.0],
        [2.0, 3.0, 5.0],
        [6.0, 7.0, 9.0],
        [3.0, 4.0, 5.0],
    ];
    let curve = Curve::new(&points.map(DVec3::from)).unwrap();
    let show = |p: DVec3| format!("({}, {}, {})", p.x, p.y, p.z);
    writeln!(out, "middle: {}", show(curve.eval(0.5)));
    let (first, last) = (curve.derivative_at(0.0, 1), curve.derivative_at(1.0, 1));
    writeln!(out, "velocity at the start {}", show(first));
    writeln!(out, "velocity at the end {}", show(last));

    // Map the points, then draw; or draw, then map: the same. (Half the size, rotated.)
    let map = DAffine2::from_cols_array(&[0.0, 0.5, -0.5, 0.0, 300.0, 20.0]);
    let points = [(60.0, 400.0), (160.0, 40.0), (480.0, 40.0), (600.0, 400.0)];
    let flat = Curve::new(&points.map(DVec2::from)).unwrap();
    let moved = map.transform_point2(flat.eval(0.3));
    let other = flat.transform(&map).unwrap().eval(0.3);
    writeln!(out, "affine: {}", other.distance(moved) < 1e-12);

    // The curve lies inside the hull and does not reach P1 and P2.
    let (low, high) = (flat.bounds().min.y, flat.bounds().max.y);
    writeln!(out, "y from {low:.1} to {high:.1}, points from 40 to 400");
}
