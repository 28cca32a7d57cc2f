use casteljau::curve::Bounds;
use casteljau::{Curve, glam::DVec2};

fn show(bounds: &Bounds<DVec2>) -> String {
    let (min, max) = (bounds.min, bounds.max);
    format!(
        "x {:.3} to {:.3}, y {:.3} to {:.3}",
        min.x, max.x, min.y, max.y
    )
}

fn times(ts: &[f64]) -> String {
    let texts: Vec<String> = ts.iter().map(|t| format!("{t:.4}")).collect();
    texts.join(", ")
}

pub(crate) fn sample(out: &mut String) {
    let points = [(0.0, 0.0), (3.0, 3.0), (-1.0, 3.0), (2.0, 0.0)].map(DVec2::from);
    let curve = Curve::new(&points).unwrap();
    writeln!(out, "control points: {}", show(&curve.control_bounds()));
    writeln!(out, "curve:          {}", show(&curve.bounds()));

    for (axis, name) in ["x", "y"].iter().enumerate() {
        let ts = curve.extrema(axis).unwrap();
        writeln!(out, "extrema of {name} at t = {}", times(&ts));
    }
}
