use casteljau::{Curve, Spline, glam::DVec3};
use std::f64::consts::FRAC_1_SQRT_2;

pub(crate) fn sample(out: &mut String) {
    // A quarter of the unit circle with the weights 1, 1, 2, as the curve of the points (w x, w y, w) in space.
    let points = [(1.0, 0.0, 1.0), (1.0, 1.0, 1.0), (0.0, 2.0, 2.0)];
    let arc = Curve::new(&points.map(DVec3::from)).unwrap();
    for t in [0.0, 0.25, 0.5, 1.0] {
        let point = arc.eval(t);
        let (x, y) = (point.x / point.z, point.y / point.z);
        let radius = x.hypot(y);
        writeln!(out, "t = {t}: ({x:.4}, {y:.4}), radius {radius:.12}");
    }

    // The whole circle: nine points, every other weight is the root of 1/2, and twelve knots.
    let w = FRAC_1_SQRT_2;
    let points = [
        (1.0, 0.0, 1.0),
        (w, w, w),
        (0.0, 1.0, 1.0),
        (-w, w, w),
        (-1.0, 0.0, 1.0),
        (-w, -w, w),
        (0.0, -1.0, 1.0),
        (w, -w, w),
        (1.0, 0.0, 1.0),
    ]
    .map(DVec3::from);
    let knots = [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0];
    let circle = Spline::from_bspline(&points, 2, Some(&knots), false).unwrap();
    let mut error: f64 = 0.0;
    for i in 0..=1000 {
        let point = circle.eval(f64::from(i) / 250.0);
        error = error.max(((point.x / point.z).hypot(point.y / point.z) - 1.0).abs());
    }
    let arcs = circle.segment_count();
    let small = error < 1e-15;
    writeln!(out, "{arcs} arcs, error below 1e-15: {small}");
}
