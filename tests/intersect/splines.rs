//! Intersections and self-intersections of splines.

use crate::intersect::{kinds, overlap};
use crate::support::{Rng, bezier, near, random_points, real, spline};
use casteljau::curve::IntersectionKind::{Cross, Tangent};
use casteljau::glam::DVec2;
use casteljau::{Curve, Spline, take_steps};

const SQUARE: &str = "0 0, 2 0, 2 2, 0 2";

#[test]
fn joints_are_one_intersection() {
    let square = spline(SQUARE, 1, true);
    let found = square.intersections_with_curve(&bezier("-1 -1, 3 3"));
    assert_eq!(kinds(&found), [(0.0, 0.25, Cross), (2.0, 0.75, Cross)]);
    let found = square.intersections(&spline("-1 0, 0 0, 0 -1", 1, false));
    assert_eq!(kinds(&found), [(0.0, 1.0, Tangent)]);
    // Shared pieces run across joints.
    let found = square.intersections(&square);
    assert_eq!(kinds(&found), [(0.0, 0.0, overlap(4.0, 4.0))]);
    let hook = spline("3 0, 1 0, 0.5 0, 0 0, 0 1, -1 1", 1, false);
    let expected = [(0.0, 3.0, overlap(1.0, 0.5)), (3.5, 4.0, overlap(4.0, 3.0))];
    assert_eq!(kinds(&square.intersections(&hook)), expected);
}

#[test]
fn a_curve_cut_into_a_spline_meets_as_the_curve_does() {
    let mut rng = Rng(8);
    for _ in 0..300 {
        let mut draw = || Curve::new(&random_points::<DVec2>(&mut rng, 4)).expect("finite");
        let (a, b) = (draw(), draw());
        let cuts = [0.0, 0.21, 0.5, 0.83, 1.0];
        let pieces: Vec<_> = cuts.windows(2).map(|c| a.subsegment(c[0]..c[1])).collect();
        let spline = Spline::from_curves(&pieces, false).expect("joined");
        let whole = |t: f64| {
            let k = [1.0, 2.0, 3.0].iter().filter(|&&joint| t >= joint).count();
            cuts[k] + (t - real(k)) * (cuts[k + 1] - cuts[k])
        };
        let (curve, chain) = (a.intersections(&b), spline.intersections_with_curve(&b));
        assert_eq!(curve.len(), chain.len(), "{curve:?} {chain:?}");
        for (p, q) in curve.iter().zip(&chain) {
            near((p.t - whole(q.t)).abs() + (p.u - q.u).abs(), 0.0, 1e-9);
        }
        let (curve, chain) = (a.self_intersections(), spline.self_intersections());
        assert_eq!(curve.len(), chain.len(), "{curve:?} {chain:?}");
        for (p, q) in curve.iter().zip(&chain) {
            near(
                (p.t - whole(q.t)).abs() + (p.u - whole(q.u)).abs(),
                0.0,
                1e-9,
            );
        }
    }
}

#[test]
fn selves() {
    for (points, closed, expected) in [
        ("0 0, 2 2, 2 0, 0 2", true, Some((0.5, 2.5, DVec2::ONE))),
        ("0 0, 1 0, 0 1, 0 0", false, Some((0.0, 3.0, DVec2::ZERO))),
        ("0 0, 1 0, 0 1", true, None),
        ("0 0, 4 0, 1 0", false, None),
    ] {
        let found = spline(points, 1, closed).self_intersections();
        let found: Vec<_> = found.iter().map(|p| (p.t, p.u, p.point)).collect();
        assert_eq!(found, Vec::from_iter(expected), "{points}");
    }
}

fn wave(segments: usize, height: f64) -> Spline<DVec2> {
    let point = |i: usize| DVec2::new(real(i), height * [0.0, 2.0, -2.0][i % 3]);
    let points: Vec<DVec2> = (0..=3 * segments).map(point).collect();
    Spline::new(&points, 3, false).expect("a wave")
}

/// The waves cross between and at their joints, and a wave does not cross itself. The number of steps (pairs of boxes
/// and of pieces) grows hardly faster than the number of segments.
#[test]
fn long_splines() {
    for segments in [1, 2, 300, 30_000] {
        let (a, b) = (wave(segments, 1.0), wave(segments, -1.0));
        take_steps();
        assert_eq!(a.intersections(&b).len(), 2 * segments + 1);
        let across = take_steps();
        assert!(across <= 50 * segments, "{segments}: {across}");
        assert!(a.self_intersections().is_empty());
        let itself = take_steps();
        assert!(itself <= 30 * segments, "{segments}: {itself}");
    }
}
