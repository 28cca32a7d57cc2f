use casteljau::{Curve, Spline, glam::DVec2};

fn show(curve: &Curve<DVec2>) -> String {
    let round = |x: f64| (x * 1e6).round() / 1e6;
    let pairs: Vec<String> = curve
        .control_points()
        .iter()
        .map(|p| format!("({}, {})", round(p.x), round(p.y)))
        .collect();
    pairs.join(" ")
}

pub(crate) fn sample(out: &mut String) {
    let points = [(0.0, 8.0), (8.0, 0.0), (24.0, 0.0), (32.0, 8.0)].map(DVec2::from);
    let curve = Curve::new(&points).unwrap();

    let (q, r) = curve.split(0.5);
    writeln!(out, "q: {}", show(&q));
    writeln!(out, "r: {}", show(&r));

    // The part between two parameters. If they are swapped, it runs backwards.
    writeln!(out, "third quarter: {}", show(&curve.subsegment(0.5..0.75)));
    writeln!(out, "reversed: {}", show(&curve.subsegment(1.0..0.0)));

    // Insert a point: two pieces, the same shape.
    let spline = Spline::new(&points, 3, false).unwrap().insert(0.5).unwrap();
    let moved = spline.eval(1.5).distance(curve.eval(0.75));
    writeln!(out, "{} segments, moved by {moved}", spline.segment_count());
}
