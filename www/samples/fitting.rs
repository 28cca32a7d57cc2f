use casteljau::spline::FitOptions;
use casteljau::{Path, Spline, glam::DVec2};
use std::f64::consts::PI;

pub(crate) fn sample(out: &mut String) {
    // 60 points, alternately 0.05 above and below a wave.
    let points: Vec<DVec2> = (0..60)
        .map(|i| {
            let x = f64::from(i) / 10.0;
            DVec2::new(x, x.sin() + 0.05 * f64::from(1 - i % 2 * 2))
        })
        .collect();
    for tolerance in [0.01, 0.03, 0.06] {
        let spline = Spline::fit(&points, &FitOptions::new(tolerance)).unwrap();
        let near = points
            .iter()
            .all(|&point| spline.nearest(point).unwrap().distance <= tolerance);
        writeln!(
            out,
            "tolerance {tolerance}: {} cubics, all points near: {near}",
            spline.segment_count()
        );
    }

    // A polygon of 200 corners, with fewer segments: the whole outline stays within the tolerance.
    let corner = |i: f64| DVec2::from_angle(i) * (50.0 + 10.0 * (5.0 * i).sin());
    let corners: Vec<DVec2> = (0..200)
        .map(|i| corner(f64::from(i) * PI / 100.0))
        .collect();
    let polygon = Path::polygon(&corners).unwrap();
    let simple = polygon.simplify(0.5).unwrap();
    writeln!(
        out,
        "{} lines, {} cubics",
        polygon.segment_count(),
        simple.segment_count()
    );
}
