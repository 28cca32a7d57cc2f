//! Intersections of rational curves: closed forms on conics, invariance, and subdivision as the reference.

use super::{quarter, random_curve, unit_arc};
use crate::intersect::generate::{Case, case};
use crate::support::Rng;
use casteljau::curve::{Bounds, Intersection, IntersectionKind};
use casteljau::glam::{DAffine2, DMat3, DVec2};
use casteljau::{Curve, RationalCurve, take_steps};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, FRAC_PI_6};

use IntersectionKind::{Cross, Overlap, Tangent};

fn line(from: (f64, f64), to: (f64, f64)) -> Curve<DVec2> {
    Curve::new(&[from, to].map(DVec2::from)).expect("valid")
}

/// The unit circle from (1, 0), counter-clockwise, as one curve of degree 5.
fn circle() -> RationalCurve<DVec2> {
    let points = [
        (1.0, 0.0),
        (1.0, 4.0),
        (-3.0, 2.0),
        (-3.0, -2.0),
        (1.0, -4.0),
        (1.0, 0.0),
    ];
    let weights = [1.0, 0.2, 0.2, 0.2, 0.2, 1.0];
    RationalCurve::new(&points.map(DVec2::from), &weights).expect("valid")
}

fn moved(
    curve: &RationalCurve<DVec2>,
    scale: DVec2,
    angle: f64,
    by: DVec2,
) -> RationalCurve<DVec2> {
    let map = DAffine2::from_scale_angle_translation(scale, angle, by);
    curve.transform(&map).expect("finite")
}

fn turned(curve: &RationalCurve<DVec2>, angle: f64) -> RationalCurve<DVec2> {
    moved(curve, DVec2::ONE, angle, DVec2::ZERO)
}

/// Asserts that both curves pass each intersection.
#[track_caller]
fn are_on_both(
    a: &RationalCurve<DVec2>,
    b: &RationalCurve<DVec2>,
    found: &[Intersection],
    within: f64,
) {
    for p in found {
        let mut places = vec![(p.t, p.u)];
        if let Overlap { t_end, u_end } = p.kind {
            places.push((t_end, u_end));
        }
        for (t, u) in places {
            let gap = (a.eval(t) - b.eval(u)).length();
            assert!(gap <= within, "{gap:e} apart: {p:?}");
        }
        assert!((a.eval(p.t) - p.point).length() <= within);
    }
    assert!(
        found.is_sorted_by(|p, q| (p.t, p.u) <= (q.t, q.u)),
        "{found:?}"
    );
}

#[test]
fn lines_meet_a_circle_in_no_one_or_two_points() {
    let circle = circle();
    for k in -12..=12 {
        let x = f64::from(k) * 0.1 + 0.01;
        let found = circle.intersections_with_curve(&line((x, -2.0), (x, 2.0)));
        if x.abs() > 1.0 {
            assert!(found.is_empty(), "{x}: {found:?}");
            continue;
        }
        let y = (1.0 - x * x).sqrt();
        let mut ys: Vec<f64> = found.iter().map(|p| p.point.y).collect();
        ys.sort_by(f64::total_cmp);
        assert_eq!(ys.len(), 2, "{x}: {found:?}");
        assert!(
            (ys[0] + y).abs() < 1e-14 && (ys[1] - y).abs() < 1e-14,
            "{x}: {ys:?}"
        );
        for p in &found {
            assert_eq!(p.kind, Cross);
            assert!((p.u - (p.point.y + 2.0) / 4.0).abs() < 1e-15);
        }
    }
    let touched = circle.intersections_with_curve(&line((-2.0, 1.0), (2.0, 1.0)));
    assert_eq!(touched.len(), 1, "{touched:?}");
    assert_eq!(touched[0].kind, Tangent);
    assert!((touched[0].point - DVec2::Y).length() < 1e-7 && (touched[0].u - 0.5).abs() < 1e-7);
    // The circle starts where the line touches it: both ends of the curve are there.
    let touched = circle.intersections_with_curve(&line((1.0, -2.0), (1.0, 2.0)));
    let places: Vec<_> = touched.iter().map(|p| (p.t, p.u, p.kind)).collect();
    assert_eq!(places, [(0.0, 0.5, Tangent), (1.0, 0.5, Tangent)]);
}

#[test]
fn circles_meet_in_no_one_or_two_points() {
    let circle = circle();
    for k in 1..=24 {
        // Two unit circles at the distance d meet at d/2 and ±√(1 − d²/4).
        let d = f64::from(k) * 0.1 - 0.03;
        let other = turned(&circle, 1.0);
        let other = moved(&other, DVec2::ONE, 0.0, DVec2::new(d, 0.0));
        let found = circle.intersections(&other);
        are_on_both(&circle, &other, &found, 1e-14);
        assert_eq!(found.len(), if d < 2.0 { 2 } else { 0 }, "{d}: {found:?}");
        for p in &found {
            let y = (1.0 - 0.25 * d * d).sqrt();
            assert!(
                (p.point.x - 0.5 * d).abs() < 1e-14 * (1.0 + 1.0 / y),
                "{d}: {p:?}"
            );
            assert!((p.point.y.abs() - y).abs() < 1e-14 * (1.0 + 1.0 / y));
            assert_eq!(p.kind, Cross);
        }
    }
    let touched = circle.intersections(&moved(
        &turned(&circle, 1.0),
        DVec2::ONE,
        0.0,
        DVec2::new(0.0, 2.0),
    ));
    assert_eq!(touched.len(), 1, "{touched:?}");
    assert_eq!(touched[0].kind, Tangent);
    assert!((touched[0].point - DVec2::Y).length() < 1e-7);
}

#[test]
fn ellipses_meet_in_four_points() {
    // x²/4 + y² = 1 and x² + y²/4 = 1 at ±2/√5, turned and moved.
    let circle = turned(&circle(), 0.3);
    let c = 2.0 / 5.0_f64.sqrt();
    for k in 0..10 {
        let (angle, by) = (f64::from(k), DVec2::new(0.3, -0.2) * f64::from(k));
        let place = |scale: (f64, f64)| {
            moved(
                &moved(&circle, scale.into(), 0.0, DVec2::ZERO),
                DVec2::ONE,
                angle,
                by,
            )
        };
        let (a, b) = (place((2.0, 1.0)), place((1.0, 2.0)));
        let found = a.intersections(&b);
        are_on_both(&a, &b, &found, 1e-14);
        assert_eq!(found.len(), 4, "{found:?}");
        for p in found {
            let at = DVec2::from_angle(-angle).rotate(p.point - by);
            assert!((at.abs() - DVec2::splat(c)).length() < 1e-14, "{at}");
            assert_eq!(p.kind, Cross);
        }
    }
}

#[test]
fn arcs_of_one_circle_overlap() {
    // An arc from 0 to 2α and one from `from` to `from` + 2β share the angles from `from` to 2α.
    let angle = |p: DVec2| p.y.atan2(p.x);
    for (alpha, beta, from) in [
        (0.7, 0.5, 0.4),
        (0.5, 1.2, 0.3),
        (0.2, 0.3, 0.1),
        (1.3, 0.6, 2.0),
    ] {
        let arc = unit_arc(alpha);
        let other = turned(&unit_arc(beta), from);
        let to = (2.0_f64 * alpha).min(from + 2.0 * beta);
        for (a, b) in [
            (arc.clone(), other.clone()),
            (arc.clone(), other.reverse()),
            (arc.elevate().expect("below 64"), other.clone()),
            (arc.clone(), other.elevate().expect("below 64").reverse()),
        ] {
            take_steps();
            let found = a.intersections(&b);
            let steps = take_steps();
            assert!(steps < 100, "{steps}");
            are_on_both(&a, &b, &found, 1e-13);
            assert_eq!(found.len(), 1, "{alpha} {beta} {from}: {found:?}");
            let Overlap { t_end, .. } = found[0].kind else {
                panic!("{alpha} {beta} {from}: {found:?}");
            };
            let ends = [angle(a.eval(found[0].t)), angle(a.eval(t_end))];
            assert!(
                (ends[0] - from).abs() < 1e-13 && (ends[1] - to).abs() < 1e-13,
                "{ends:?}"
            );
        }
    }
    let whole = circle();
    let found = whole.intersections(&turned(&quarter(), 1.0));
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(matches!(found[0].kind, Overlap { .. }));
}

#[test]
fn arcs_that_share_an_end_meet_there() {
    let arc = unit_arc(FRAC_PI_4);
    let next = RationalCurve::conic(
        DVec2::Y,
        DVec2::new(-1.0, 1.0),
        DVec2::NEG_X,
        0.5_f64.sqrt(),
    );
    let found = quarter().intersections(&next.expect("valid"));
    assert_eq!(found.len(), 1);
    assert_eq!(
        (found[0].t, found[0].u, found[0].point),
        (1.0, 0.0, DVec2::Y)
    );
    assert_eq!(found[0].kind, Tangent);
    // A circle around the end of the first one.
    let small = moved(&arc, DVec2::splat(0.5), 0.3, arc.end());
    let found = arc.intersections(&small);
    assert!(found.len() <= 1);
    let across = RationalCurve::conic(arc.end(), DVec2::new(3.0, 2.0), DVec2::new(4.0, 0.0), 2.0);
    let found = arc.intersections(&across.expect("valid"));
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!((found[0].t, found[0].u, found[0].kind), (1.0, 0.0, Cross));
    assert_eq!(found[0].point, arc.end());
    let far = moved(
        &arc,
        DVec2::ONE,
        FRAC_PI_6,
        DVec2::new(FRAC_PI_2 * 4.0, 0.0),
    );
    assert!(arc.intersections(&far).is_empty());
}

#[test]
fn equal_weights_are_the_polynomial_curves() {
    let mut rng = Rng(11);
    for _ in 0..200 {
        let (n, m) = (1 + rng.below(5), 1 + rng.below(5));
        let (a, b) = (
            random_curve(&mut rng, n, 0.0),
            random_curve(&mut rng, m, 0.0),
        );
        let [p, q] = [&a, &b].map(|c| Curve::new(c.control_points()).expect("valid"));
        let expected = p.intersections(&q);
        for found in [a.intersections(&b), a.intersections_with_curve(&q)] {
            assert_eq!(found.len(), expected.len());
            for (p, q) in found.iter().zip(&expected) {
                assert_eq!((p.t, p.u, p.kind), (q.t, q.u, q.kind));
                assert!((p.point - q.point).length() < 1e-15);
            }
        }
    }
}

/// The boxes around the points where two curves meet, found by halving pieces until their control points are apart, or both
/// are smaller than this.
const SMALLEST_PIECE: f64 = 1e-7;

fn meetings(a: &RationalCurve<DVec2>, b: &RationalCurve<DVec2>) -> Vec<Bounds<DVec2>> {
    let size = |bounds: &Bounds<DVec2>| (bounds.max - bounds.min).max_element();
    let is_near = |p: &Bounds<DVec2>, q: &Bounds<DVec2>, margin: f64| {
        let gap = p.min.max(q.min) - p.max.min(q.max);
        gap.max_element() <= margin
    };
    let mut pairs = vec![(a.clone(), b.clone())];
    let mut groups: Vec<Bounds<DVec2>> = Vec::new();
    while let Some((a, b)) = pairs.pop() {
        let (p, q) = (a.control_bounds(), b.control_bounds());
        if !is_near(&p, &q, 1e-14) {
            continue;
        }
        if size(&p).max(size(&q)) > SMALLEST_PIECE {
            if size(&p) > size(&q) {
                let (before, after) = a.halve();
                pairs.extend([(before, b.clone()), (after, b)]);
            } else {
                let (before, after) = b.halve();
                pairs.extend([(a.clone(), before), (a, after)]);
            }
            continue;
        }
        let mut joined = p;
        groups.retain(|group| {
            let belongs = is_near(group, &p, 4.0 * SMALLEST_PIECE);
            if belongs {
                joined = joined.union(*group);
            }
            !belongs
        });
        groups.push(joined);
    }
    groups
}

#[test]
fn random_curves_meet_where_halving_finds_it() {
    let mut rng = Rng(12);
    let mut count = 0;
    for round in 0..1000 {
        let (n, m) = (1 + rng.below(5), 1 + rng.below(5));
        // Weights from 2^−k to 2^k; 2^10 is about 10³.
        let k = if round % 2 == 0 { 2.0 } else { 10.0 };
        let (a, b) = (random_curve(&mut rng, n, k), random_curve(&mut rng, m, k));
        let found = a.intersections(&b);
        are_on_both(&a, &b, &found, 1e-10);
        let expected = meetings(&a, &b);
        for p in &found {
            let outside = |group: &Bounds<DVec2>| (group.min - p.point).max(p.point - group.max);
            let contains = |group: &Bounds<DVec2>| outside(group).max_element() <= 1e-10;
            assert!(expected.iter().any(contains), "{round}: {p:?} {expected:?}");
        }
        assert_eq!(
            found.len(),
            expected.len(),
            "{round}: {found:?} {expected:?}"
        );
        count += found.len();
    }
    assert!(count > 500, "{count}");
}

#[test]
fn elevation_and_parameters_do_not_matter() {
    let mut rng = Rng(13);
    for round in 0..200 {
        let (a, b) = (
            random_curve(&mut rng, 3, 6.0),
            random_curve(&mut rng, 3, 6.0),
        );
        let found = a.intersections(&b);
        let raised = b.elevate().expect("below 64");
        let standard = b.reparametrize().expect("moderate");
        let powers = [3.0, 3e3, 3e6, 3e9].iter();
        let scaled: Vec<f64> = b
            .weights()
            .iter()
            .zip(powers)
            .map(|(w, power)| w * power)
            .collect();
        let faster = RationalCurve::new(b.control_points(), &scaled).expect("valid");
        for (k, other) in [raised, standard, faster].iter().enumerate() {
            let again = a.intersections(other);
            are_on_both(&a, other, &again, 1e-11);
            assert_eq!(again.len(), found.len(), "{round} {k}: {found:?} {again:?}");
            for (p, q) in found.iter().zip(&again) {
                assert!((p.t - q.t).abs() < 1e-9, "{round} {k}: {p:?} {q:?}");
                assert!(
                    (p.point - q.point).length() < 1e-11,
                    "{round} {k}: {p:?} {q:?}"
                );
                assert_eq!(p.kind, q.kind);
            }
        }
    }
}

/// The number of overlaps.
fn overlaps(found: &[Intersection]) -> usize {
    let is_overlap = |p: &&Intersection| matches!(p.kind, Overlap { .. });
    found.iter().filter(is_overlap).count()
}

#[test]
fn a_projective_map_keeps_the_intersections() {
    let matrix = DMat3::from_cols_array(&[1.0, 0.2, 0.03, -0.3, 1.1, 0.05, 0.4, 0.5, 1.5]);
    let (mut rounds, mut with_overlap, mut different) = (0, 0, 0);
    for seed in 0..4000 {
        let Case { a, b, .. } = case(&mut Rng(seed));
        let points = a.control_points().iter().chain(b.control_points());
        let size = points.fold(0.0_f64, |size, p| size.max(p.abs().max_element()));
        let scale = DAffine2::from_scale(DVec2::splat(1.0 / size));
        let image = |curve: &Curve<DVec2>| {
            let near = RationalCurve::from(curve).transform(&scale)?;
            near.project(&matrix)
        };
        // Coordinates far from the origin are rounded by the map.
        if !(1e-3..1e3).contains(&size) {
            continue;
        }
        let (Ok(p), Ok(q)) = (image(&a), image(&b)) else {
            continue;
        };
        let (expected, found) = (a.intersections(&b), p.intersections(&q));
        are_on_both(&p, &q, &found, 1e-13);
        rounds += 1;
        with_overlap += usize::from(overlaps(&expected) > 0);
        let same = overlaps(&found) == overlaps(&expected) && found.len() == expected.len();
        different += usize::from(!same);
    }
    // The map rounds the points, so that there may be two crossings or none in the place of a tangency.
    assert!(
        rounds > 2000 && with_overlap > 300,
        "{rounds} {with_overlap}"
    );
    assert!(200 * different < rounds, "{different} of {rounds}");
}

#[test]
fn extreme_weights_have_bounded_work() {
    let mut rng = Rng(14);
    for k in [40.0, 400.0] {
        for _ in 0..300 {
            let (n, m) = (1 + rng.below(7), 1 + rng.below(7));
            let (a, b) = (random_curve(&mut rng, n, k), random_curve(&mut rng, m, k));
            let part = a.subsegment(rng.unit()..rng.unit());
            take_steps();
            for other in [&a, &b, &a.reverse(), &part.unwrap_or(b.clone())] {
                let found = a.intersections(other);
                // The product of the degrees is Bézout's bound; some are found twice, because rounding of a parameter moves the point.
                let max = 2 * a.degree() * other.degree() + 4;
                assert!(k > 50.0 || found.len() <= max, "{} of {max}", found.len());
                for p in found {
                    assert!(
                        (0.0..=1.0).contains(&p.t) && (0.0..=1.0).contains(&p.u),
                        "{p:?}"
                    );
                    assert!(p.point.is_finite());
                }
            }
            let steps = take_steps();
            assert!(steps < 60_000, "{steps}");
        }
    }
}

#[test]
fn self_intersections_are_passed_twice() {
    // A closed curve passes its start twice.
    let whole = circle().self_intersections();
    assert_eq!(whole.len(), 1);
    assert_eq!(
        (whole[0].t, whole[0].u, whole[0].point),
        (0.0, 1.0, DVec2::X)
    );
    assert!(
        unit_arc(1.2)
            .elevate()
            .expect("below 64")
            .self_intersections()
            .is_empty()
    );
    let mut rng = Rng(15);
    let mut count = 0;
    for _ in 0..300 {
        let curve = random_curve(&mut rng, 3, 3.0);
        let found = curve.self_intersections();
        // A rational cubic has at most one double point.
        assert!(found.len() <= 1, "{found:?}");
        for p in &found {
            count += 1;
            assert!(p.t < p.u);
            assert!((curve.eval(p.t) - p.point).length() < 1e-13);
            assert!((curve.eval(p.u) - p.point).length() < 1e-13);
        }
        let again = curve.elevate().expect("below 64").self_intersections();
        assert_eq!(again.len(), found.len());
        // Both branches are found as an intersection of the parts.
        if let Some(p) = found.first() {
            let (left, right) = curve.split(0.5 * (p.t + p.u)).expect("inside");
            let crossings = left.intersections(&right);
            let is_there = |q: &Intersection| (q.point - p.point).length() < 1e-12;
            assert!(crossings.iter().any(is_there), "{p:?} {crossings:?}");
        }
    }
    assert!(count > 20, "{count}");
    let points = [(0.0, 0.0), (4.0, 3.0), (-3.0, 3.0), (1.0, 0.0)].map(DVec2::from);
    let equal = RationalCurve::new(&points, &[2.0; 4]).expect("valid");
    let polynomial = Curve::new(&points).expect("valid");
    assert_eq!(equal.self_intersections().len(), 1);
    assert_eq!(
        equal.self_intersections()[0].t,
        polynomial.self_intersections()[0].t
    );
}
