use casteljau::Curve;
use casteljau::glam::DVec2;

pub(crate) fn sample(out: &mut String) {
    let points = [[0.0, 0.0], [1.0, 3.0], [3.0, 3.0], [4.0, 0.0]];
    let curve = Curve::new(&points.map(DVec2::from)).unwrap();
    for t in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let p = curve.eval(t);
        writeln!(out, "t = {t}: ({}, {})", p.x, p.y);
    }
}
