//! Self-intersections of curves.

use crate::intersect::generate::new;
use crate::support::{Rng, largest, plane, real};
use casteljau::Curve;
use casteljau::glam::DVec2;

#[test]
fn cubics() {
    let loop_ = plane(&[(0.0, 0.0), (3.0, 2.0), (-2.0, 2.0), (1.0, 0.0)]);
    let found = loop_.self_intersections();
    assert_eq!(found.len(), 1);
    assert!(
        (found[0].t + found[0].u - 1.0).abs() < 1e-15 && (found[0].point.x - 0.5).abs() < 1e-15
    );
    let arch = plane(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)]);
    assert_eq!(arch.self_intersections(), []);
    let cusp = plane(&[(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]);
    assert_eq!(cusp.self_intersections(), []);
    let closed = plane(&[(0.0, 0.0), (2.0, 2.0), (-2.0, 2.0), (0.0, 0.0)]);
    let found = closed.self_intersections();
    assert_eq!(
        (found.len(), found[0].t, found[0].u, found[0].point),
        (1, 0.0, 1.0, DVec2::ZERO)
    );
    // Traversed again: no isolated point.
    let back = plane(&[(0.0, 0.0), (4.0, 4.0), (-2.0, -2.0), (1.0, 1.0)]);
    assert_eq!(back.self_intersections(), []);
}

/// The general method, which is used for degree 4 and above, finds what the closed form finds.
#[test]
fn elevated_cubics() {
    let mut rng = Rng(3);
    let mut loops = 0;
    for case in 0..3000 {
        let coordinate = |rng: &mut Rng| {
            if case % 2 == 0 {
                real(rng.below(5))
            } else {
                rng.signed()
            }
        };
        let points: Vec<DVec2> = (0..4)
            .map(|_| DVec2::new(coordinate(&mut rng), coordinate(&mut rng)))
            .collect();
        let cubic = new(&points);
        let (low, high) = (
            cubic.self_intersections(),
            cubic.elevate().expect("low").self_intersections(),
        );
        assert_eq!(low.len(), high.len(), "{points:?}: {low:?} {high:?}");
        for (p, q) in low.iter().zip(&high) {
            // A short loop is close to a cusp, where parameters are known to the square root of rounding.
            let near = 1e-13 / (p.u - p.t).min(1.0).powi(2);
            assert!(
                (p.t - q.t).abs().max((p.u - q.u).abs()) < near.min(1e-4),
                "{points:?}: {p:?} {q:?}"
            );
            let apart = (cubic.eval(p.t) - cubic.eval(p.u)).length();
            assert!(
                p.t < p.u && apart <= 1e-14 * largest(&points),
                "{points:?}: {p:?}"
            );
        }
        loops += low.len();
    }
    assert!(loops > 200, "{loops}");
}

/// A curve intersects itself where its two halves intersect, and where each half intersects itself.
#[test]
fn halves_cross_where_the_whole_crosses_itself() {
    let mut rng = Rng(11);
    for case in 0..1000 {
        let degree = 4 + case % 5;
        let points: Vec<DVec2> = (0..=degree)
            .map(|_| DVec2::new(rng.signed(), rng.signed()))
            .collect();
        let whole: Curve<DVec2> = new(&points);
        let (before, after) = whole.split(0.4375);
        let back = |t: f64| 0.4375 * t;
        let on = |t: f64| 0.4375 + 0.5625 * t;
        let mut expected: Vec<(f64, f64)> = Vec::new();
        expected.extend(
            before
                .self_intersections()
                .iter()
                .map(|p| (back(p.t), back(p.u))),
        );
        expected.extend(
            after
                .self_intersections()
                .iter()
                .map(|p| (on(p.t), on(p.u))),
        );
        expected.extend(
            before
                .intersections(&after)
                .iter()
                .map(|p| (back(p.t), on(p.u))),
        );
        expected.retain(|p| p.1 - p.0 > 1e-6);
        expected.sort_by(|p, q| p.0.total_cmp(&q.0));
        let found = whole.self_intersections();
        assert_eq!(
            found.len(),
            expected.len(),
            "{points:?}: {found:?} {expected:?}"
        );
        for (p, q) in found.iter().zip(&expected) {
            assert!(
                (p.t - q.0).abs().max((p.u - q.1).abs()) < 1e-9,
                "{points:?}: {p:?} {q:?}"
            );
        }
    }
}
