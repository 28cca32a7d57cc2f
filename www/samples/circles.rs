use casteljau::{Curve, glam::DVec2};

/// The first of n equal arcs of the circle of radius 1.
fn arc(n: u32) -> Curve<DVec2> {
    let angle = 2.0 * std::f64::consts::PI / f64::from(n);
    let h = 4.0 / 3.0 * (angle / 4.0).tan();
    let (s, c) = angle.sin_cos();
    let points = [(1.0, 0.0), (1.0, h), (c + h * s, s - h * c), (c, s)];
    Curve::new(&points.map(DVec2::from)).unwrap()
}

pub(crate) fn sample(out: &mut String) {
    for n in [2, 4, 8, 16] {
        let curve = arc(n);
        let mut error: f64 = 0.0;
        for i in 0..=1000 {
            let point = curve.eval(f64::from(i) / 1000.0);
            error = error.max((point.length() - 1.0).abs());
        }
        let millionths = 1e6 * error;
        writeln!(out, "{n} arcs: error {millionths:.3} millionths");
    }
}
