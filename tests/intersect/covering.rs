//! Pairs of low degree that nearly or completely coincide, the hardest to distinguish.

use crate::intersect::spots;
use crate::support::bezier;
use casteljau::Curve;
use casteljau::glam::{DAffine2, DVec2};

/// The shapes are a few units large.
const SLACK: f64 = 1e-12;

fn shapes() -> [Curve<DVec2>; 8] {
    [
        "0 0, 3 2, -2 2, 1 0",
        "0 0, 1 3, 2 -3, 3 1",
        "0 0, 1 1, 0 1, 1 0",
        "0 0, 1 2, 3 2, 4 0",
        "0 0, 3 3, -1 -1, 2 2",
        "0 0, 1 2, 2 0",
        "0 0, 0 0, 0 0, 1 1",
        "1 1, 1 1",
    ]
    .map(bezier)
}

/// A curve and others that nearly or completely coincide with it.
fn neighbours(c: &Curve<DVec2>) -> Vec<Curve<DVec2>> {
    let (some, back) = (c.subsegment(0.2..0.8), c.subsegment(1.0..0.3));
    let mut all = vec![c.clone(), c.reverse(), some, back];
    for k in 0..17 {
        let e = 10_f64.powi(-k);
        let along = c.tangent(0.3) * e;
        for map in [
            DAffine2::from_translation(along),
            DAffine2::from_translation(along.perp()),
            DAffine2::from_angle(e),
            DAffine2::from_scale(DVec2::new(1.0 + e, 1.0)),
        ] {
            all.push(map * c);
        }
        let noise = |i: usize| DVec2::from_angle(7.0 * i as f64) * e;
        let points = c.control_points().iter().enumerate();
        let noisy: Vec<DVec2> = points.map(|(i, &p)| p + noise(i)).collect();
        all.push(Curve::new(&noisy).expect("finite"));
    }
    all
}

/// Every call returns, and at each reported intersection both curves are at the reported point.
#[test]
fn every_reported_point_lies_on_both() {
    for a in shapes() {
        for b in neighbours(&a).into_iter().chain(shapes()) {
            let all = [a.control_points(), b.control_points()];
            for p in a.intersections(&b) {
                let gap = |&(t, u): &(f64, f64)| (a.eval(t) - b.eval(u)).length();
                let mut off = (a.eval(p.t) - p.point).length();
                off = spots(&p).iter().map(gap).fold(off, f64::max);
                assert!(off <= SLACK, "{p:?} is off by {off:e}: {all:?}");
            }
        }
    }
}
