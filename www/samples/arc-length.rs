use casteljau::{Curve, glam::DVec2};

pub(crate) fn sample(out: &mut String) {
    let points = [(0.0, 0.0), (0.0, 3.0), (1.0, 0.0), (4.0, 0.0)].map(DVec2::from);
    let curve = Curve::new(&points).unwrap();
    let length = curve.length();
    writeln!(out, "length {length:.6}");

    // The t where half of the length is covered is not 0.5.
    let t = curve.time_at_length(length / 2.0);
    writeln!(out, "half of it at t = {t:.6}");

    // Five points at equal distances along the curve.
    for time in curve.equidistant_times(4).unwrap() {
        let p = curve.eval(time);
        writeln!(out, "t = {time:.4}: ({:.3}, {:.3})", p.x, p.y);
    }
}
