//! Self-intersections of curves.

use crate::intersect::generate::new;
use crate::support::{Rng, bezier, largest, near, random_points, real};
use casteljau::Path;
use casteljau::curve::IntersectionKind;
use casteljau::glam::DVec2;

#[test]
fn cubics() {
    let found = bezier("0 0, 3 2, -2 2, 1 0").self_intersections();
    assert_eq!(found.len(), 1);
    near(found[0].t + found[0].u, 1.0, 1e-15);
    near(found[0].point.x, 0.5, 1e-15);
    let found = bezier("0 0, 2 2, -2 2, 0 0").self_intersections();
    let closed = (found.len(), found[0].t, found[0].u, found[0].point);
    assert_eq!(closed, (1, 0.0, 1.0, DVec2::ZERO));
    // An arch, a cusp, and a line that is traversed again: no isolated point.
    for points in [
        "0 0, 0 2, 2 2, 2 0",
        "0 0, 1 1, 0 1, 1 0",
        "0 0, 4 4, -2 -2, 1 1",
    ] {
        assert_eq!(bezier(points).self_intersections(), [], "{points}");
    }
}

/// The general method, which is used for degree 4 and above, finds what the closed form finds.
#[test]
fn elevated_cubics() {
    let mut rng = Rng(3);
    let mut loops = 0;
    for case in 0..3000 {
        let on_grid = case % 2 == 0;
        let coordinate = |rng: &mut Rng| {
            if on_grid {
                real(rng.below(5))
            } else {
                rng.signed()
            }
        };
        let points = [(); 4].map(|()| DVec2::new(coordinate(&mut rng), coordinate(&mut rng)));
        let cubic = new(&points);
        let low = cubic.self_intersections();
        let high = cubic.elevate().expect("low").self_intersections();
        assert_eq!(low.len(), high.len(), "{points:?}: {low:?} {high:?}");
        for (p, q) in low.iter().zip(&high) {
            // A short loop is close to a cusp, where parameters are known to the square root of rounding.
            let near = 1e-13 / (p.u - p.t).min(1.0).powi(2);
            let off = (p.t - q.t).abs().max((p.u - q.u).abs());
            assert!(off < near.min(1e-4), "{points:?}: {p:?} {q:?}");
            let apart = (cubic.eval(p.t) - cubic.eval(p.u)).length();
            let meet = p.t < p.u && apart <= 1e-14 * largest(&points);
            assert!(meet, "{points:?}: {p:?}");
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
        let whole = new(&random_points(&mut rng, degree + 1));
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
        let what = format!("{whole:?}: {found:?} {expected:?}");
        assert_eq!(found.len(), expected.len(), "{what}");
        for (p, q) in found.iter().zip(&expected) {
            assert!((p.t - q.0).abs().max((p.u - q.1).abs()) < 1e-9, "{what}");
        }
    }
}

/// x = 3(τ² − 1)², y = 3(τ² − 1)(τ + ½) for τ = 4t − 2: both passes of the origin, at τ = ±1, are vertical.
#[test]
fn a_curve_that_touches_itself() {
    let touching = bezier("27 -13.5, -45 13.5, 59 -3.5, -45 -16.5, 27 22.5");
    let found = Path::from(touching).self_intersections();
    let contacts: Vec<_> = found.iter().filter(|m| m.point.length() < 1e-6).collect();
    assert_eq!(contacts.len(), 1, "{found:?}");
    near(contacts[0].t, 0.25, 1e-6);
    near(contacts[0].u, 0.75, 1e-6);
    assert_eq!(contacts[0].kind, IntersectionKind::Tangent);
}
