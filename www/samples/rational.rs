use casteljau::{NurbsCurve, RationalCurve, glam::DVec2};

pub(crate) fn sample(out: &mut String) {
    // A quarter of the unit circle with the weights 1, 1, 2.
    let points = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
    let quarter = RationalCurve::new(&points, &[1.0, 1.0, 2.0]).unwrap();
    for t in [0.0, 0.25, 0.5, 1.0] {
        let point = quarter.eval(t);
        let (x, y, radius) = (point.x, point.y, point.length());
        writeln!(out, "t = {t}: ({x:.4}, {y:.4}), radius {radius:.12}");
    }

    // The same arc with the first and the last weight 1.
    let standard = quarter.reparametrize().unwrap();
    let middle = standard.weights()[1];
    writeln!(out, "weight of the middle point: {middle:.4}");

    // The whole circle, and one more knot, which does not change it.
    let circle = NurbsCurve::circle(DVec2::ZERO, 1.0).unwrap();
    let refined = circle.insert_knot(0.1, 1).unwrap();
    for curve in [circle, refined] {
        let (points, arcs) = (curve.control_points().len(), curve.segments().len());
        let length = curve.length();
        writeln!(out, "{points} points, {arcs} arcs, length {length:.12}");
    }
}
