use casteljau::{Curve, glam::DVec2};

pub(crate) fn sample(out: &mut String) {
    let points = [(0.0, 0.0), (0.0, 8.0), (8.0, 8.0), (8.0, 0.0)].map(DVec2::from);
    let curve = Curve::new(&points).unwrap();

    // The control points of the derivative: three times the legs.
    let derivative = curve.derivative();
    let coordinates: Vec<String> = derivative
        .control_points()
        .iter()
        .map(|p| format!("{} {}", p.x, p.y))
        .collect();
    writeln!(out, "B' has the points {}", coordinates.join(" "));

    for t in [0.0, 0.5, 1.0] {
        let v = curve.derivative_at(t, 1);
        let speed = v.length();
        writeln!(out, "t = {t}: velocity ({}, {}), speed {speed}", v.x, v.y);
    }

    let a = curve.derivative_at(0.5, 2);
    writeln!(out, "acceleration at 0.5: ({}, {})", a.x, a.y);

    let curvature = curve.curvature(0.5);
    writeln!(out, "curvature at 0.5: {curvature:.4}");
    let radius = (1.0 / curvature).abs();
    writeln!(out, "radius of curvature: {radius:.4}");
}
