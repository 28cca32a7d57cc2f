//! Intersections and self-intersections of splines.

use crate::support::{Rng, plane, real};
use casteljau::curve::{Intersection, IntersectionKind};
use casteljau::glam::DVec2;
use casteljau::take_steps;
use casteljau::{Curve, Spline};

fn polygon(points: &[(f64, f64)], closed: bool) -> Spline<DVec2> {
    let points: Vec<DVec2> = points.iter().map(|&p| DVec2::from(p)).collect();
    Spline::new(&points, 1, closed).expect("a polygon")
}

fn kinds(found: &[Intersection]) -> Vec<(f64, f64, IntersectionKind)> {
    found.iter().map(|p| (p.t, p.u, p.kind)).collect()
}

#[test]
fn joints_are_one_intersection() {
    let square = polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)], true);
    let diagonal = plane(&[(-1.0, -1.0), (3.0, 3.0)]);
    let expected = [
        (0.0, 0.25, IntersectionKind::Cross),
        (2.0, 0.75, IntersectionKind::Cross),
    ];
    assert_eq!(kinds(&square.intersections_with_curve(&diagonal)), expected);
    let zigzag = polygon(&[(-1.0, 0.0), (0.0, 0.0), (0.0, -1.0)], false);
    assert_eq!(
        kinds(&square.intersections(&zigzag)),
        [(0.0, 1.0, IntersectionKind::Tangent)]
    );
}

#[test]
fn shared_pieces_run_across_joints() {
    let square = polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)], true);
    let whole = IntersectionKind::Overlap {
        t_end: 4.0,
        u_end: 4.0,
    };
    assert_eq!(kinds(&square.intersections(&square)), [(0.0, 0.0, whole)]);
    let hook = polygon(
        &[
            (3.0, 0.0),
            (1.0, 0.0),
            (0.5, 0.0),
            (0.0, 0.0),
            (0.0, 1.0),
            (-1.0, 1.0),
        ],
        false,
    );
    let found = kinds(&square.intersections(&hook));
    let bottom = IntersectionKind::Overlap {
        t_end: 1.0,
        u_end: 0.5,
    };
    let side = IntersectionKind::Overlap {
        t_end: 4.0,
        u_end: 3.0,
    };
    assert_eq!(found, [(0.0, 3.0, bottom), (3.5, 4.0, side)]);
}

#[test]
fn a_curve_cut_into_a_spline_meets_as_the_curve_does() {
    let mut rng = Rng(8);
    for _ in 0..300 {
        let mut draw = || {
            let points: Vec<DVec2> = (0..4)
                .map(|_| DVec2::new(rng.signed(), rng.signed()))
                .collect();
            Curve::new(&points).expect("finite")
        };
        let (a, b) = (draw(), draw());
        let cuts = [0.0, 0.21, 0.5, 0.83, 1.0];
        let pieces: Vec<_> = cuts.windows(2).map(|c| a.subsegment(c[0], c[1])).collect();
        let spline = Spline::from_curves(&pieces, false).expect("joined");
        let whole = |t: f64| {
            let k = [1.0, 2.0, 3.0].iter().filter(|&&joint| t >= joint).count();
            cuts[k] + (t - real(k)) * (cuts[k + 1] - cuts[k])
        };
        let (curve, chain) = (a.intersections(&b), spline.intersections_with_curve(&b));
        assert_eq!(curve.len(), chain.len(), "{curve:?} {chain:?}");
        for (p, q) in curve.iter().zip(&chain) {
            assert!(
                (p.t - whole(q.t)).abs() + (p.u - q.u).abs() < 1e-9,
                "{p:?} {q:?}"
            );
        }
        let (curve, chain) = (a.self_intersections(), spline.self_intersections());
        assert_eq!(curve.len(), chain.len(), "{curve:?} {chain:?}");
        for (p, q) in curve.iter().zip(&chain) {
            assert!(
                (p.t - whole(q.t)).abs() + (p.u - whole(q.u)).abs() < 1e-9,
                "{p:?} {q:?}"
            );
        }
    }
}

#[test]
fn selves() {
    let bow = polygon(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)], true);
    let found = bow.self_intersections();
    assert_eq!(
        (found.len(), found[0].t, found[0].u, found[0].point),
        (1, 0.5, 2.5, DVec2::ONE)
    );
    let ring = polygon(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.0, 0.0)], false);
    let found = ring.self_intersections();
    assert_eq!((found.len(), found[0].t, found[0].u), (1, 0.0, 3.0));
    let closed = polygon(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], true);
    assert_eq!(closed.self_intersections(), []);
    let back = polygon(&[(0.0, 0.0), (4.0, 0.0), (1.0, 0.0)], false);
    assert_eq!(back.self_intersections(), []);
}

fn wave(segments: usize, height: f64) -> Spline<DVec2> {
    let points: Vec<DVec2> = (0..=3 * segments)
        .map(|i| DVec2::new(real(i), height * [0.0, 2.0, -2.0][i % 3]))
        .collect();
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
