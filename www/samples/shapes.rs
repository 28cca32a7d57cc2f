use casteljau::Curve;
use casteljau::glam::DVec2;

pub(crate) fn sample(out: &mut String) {
    // Four curves: an arch, an S, a loop and a cusp.
    let [a, b, c, d] = [(0.0, 0.0), (0.0, 3.0), (4.0, 3.0), (4.0, 0.0)];
    let shapes = [
        ("arch", [a, b, c, d]),
        ("S", [a, (4.0, 0.0), (0.0, 3.0), (4.0, 3.0)]),
        ("loop", [a, (5.0, 4.0), (-1.0, 4.0), d]),
        ("cusp", [a, c, b, d]),
    ];
    for (name, points) in shapes {
        let curve = Curve::new(&points.map(DVec2::from)).unwrap();
        let class = format!("{:?}", curve.classify()).to_lowercase();
        let inflections = curve.inflections().len();
        let crossings = curve.self_intersections().len();
        writeln!(
            out,
            "{name}: {class}, {inflections} inflections, {crossings} crossings"
        );
    }

    // At the cusp the velocity is zero.
    let cusp = Curve::new(&shapes[3].1.map(DVec2::from)).unwrap();
    let DVec2 { x, y } = cusp.derivative_at(0.5, 1);
    writeln!(out, "velocity of the cusp at t = ½: ({x}, {y})");
}
