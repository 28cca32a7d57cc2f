//! Pairs of low degree that nearly or completely coincide, the hardest to distinguish.

use crate::support::plane;
use casteljau::Curve;
use casteljau::curve::IntersectionKind;
use casteljau::glam::{DAffine2, DVec2};

/// The shapes are a few units large.
const SLACK: f64 = 1e-12;

fn shapes() -> Vec<Curve<DVec2>> {
    vec![
        plane(&[(0.0, 0.0), (3.0, 2.0), (-2.0, 2.0), (1.0, 0.0)]),
        plane(&[(0.0, 0.0), (1.0, 3.0), (2.0, -3.0), (3.0, 1.0)]),
        plane(&[(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]),
        plane(&[(0.0, 0.0), (1.0, 2.0), (3.0, 2.0), (4.0, 0.0)]),
        plane(&[(0.0, 0.0), (3.0, 3.0), (-1.0, -1.0), (2.0, 2.0)]),
        plane(&[(0.0, 0.0), (1.0, 2.0), (2.0, 0.0)]),
        plane(&[(0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (1.0, 1.0)]),
        plane(&[(1.0, 1.0), (1.0, 1.0)]),
    ]
}

/// A curve and others that nearly or completely coincide with it.
fn neighbours(c: &Curve<DVec2>) -> Vec<Curve<DVec2>> {
    let mut all = vec![
        c.clone(),
        c.reverse(),
        c.subsegment(0.2, 0.8),
        c.subsegment(1.0, 0.3),
    ];
    for k in 0..17 {
        let e = 10_f64.powi(-k);
        let along = c.tangent(0.3) * e;
        all.push(
            c.transform(&DAffine2::from_translation(along))
                .expect("a finite image"),
        );
        all.push(
            c.transform(&DAffine2::from_translation(along.perp()))
                .expect("a finite image"),
        );
        all.push(
            c.transform(&DAffine2::from_angle(e))
                .expect("a finite image"),
        );
        all.push(
            c.transform(&DAffine2::from_scale(DVec2::new(1.0 + e, 1.0)))
                .expect("a finite image"),
        );
        let noisy: Vec<DVec2> = c
            .control_points()
            .iter()
            .enumerate()
            .map(|(i, p)| *p + DVec2::from_angle(7.0 * i as f64) * e)
            .collect();
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
            for location in a.intersections(&b) {
                let mut off = (a.eval(location.t) - b.eval(location.u)).length();
                if let IntersectionKind::Overlap { t_end, u_end } = location.kind {
                    off = off.max((a.eval(t_end) - b.eval(u_end)).length());
                }
                off = off.max((a.eval(location.t) - location.point).length());
                assert!(off <= SLACK, "{location:?} is off by {off:e}: {all:?}");
            }
        }
    }
}
