use casteljau::{Curve, glam::DVec2};

pub(crate) fn sample(out: &mut String) {
    let points = [(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(DVec2::from);
    let curve = Curve::new(&points).unwrap();
    for q in [(1.0, 3.0), (3.0, 1.0), (1.0, -1.0)].map(DVec2::from) {
        let nearest = curve.nearest(q).unwrap();
        let (t, p, distance) = (nearest.t, nearest.point, nearest.distance);
        let place = format!("({:.3}, {:.3})", p.x, p.y);
        writeln!(
            out,
            "Q = ({}, {}): t = {t:.4}, {place}, distance {distance:.4}",
            q.x, q.y
        );
    }

    // Was the curve clicked? Ask whether the distance is at most a few pixels.
    let is_hit = |x, y| curve.nearest(DVec2::new(x, y)).unwrap().distance <= 0.1;
    let (first, second) = (is_hit(1.0, 1.45), is_hit(1.0, 1.0));
    writeln!(out, "(1, 1.45): {first}, (1, 1): {second}");
}
