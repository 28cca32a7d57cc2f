//! Splitting and elevating leave the curve unchanged.

use crate::curve::{adversarial_points, near, steps};
use crate::support::adversarial::ALL;
use crate::support::{Space, all_near, bezier, curve, exact, largest, refused, to_3d, ulp, xy};
use casteljau::Curve;
use casteljau::glam::{DVec2, DVec3};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Eighths, whose products and differences are exact.
const EIGHTHS: [f64; 9] = [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0];

/// Asserts that `piece` at s is the whole curve at t₀ + (t₁ − t₀)s.
fn assert_is_piece<P: Space>(piece: &Curve<P>, whole: &[DVec3], t0: f64, t1: f64) {
    assert_eq!(piece.degree(), whole.len() - 1);
    let control = to_3d(piece.control_points());
    for s in EIGHTHS {
        let expected = exact::eval(whole, t0 + (t1 - t0) * s);
        let ulps = 2.0 * steps(whole);
        near(exact::eval(&control, s), expected, ulps, largest(whole));
    }
}

#[test]
fn several_splits_give_the_parts_between_the_sorted_parameters() {
    adversarial_points(&ALL, |points| {
        let whole = curve::<DVec3>(points);
        let parts = whole.split_at(&[0.75, 0.25, 1.0, 0.25]);
        let ends = [0.0, 0.25, 0.25, 0.75, 1.0, 1.0];
        assert_eq!(parts.len(), 5);
        for (part, pair) in parts.iter().zip(ends.windows(2)) {
            assert_eq!(part, &whole.subsegment(pair[0]..pair[1]));
        }
        assert!(
            parts
                .windows(2)
                .all(|pair| pair[0].end() == pair[1].start())
        );
        assert_eq!(whole.split_at(&[]), [whole]);
    });
}

#[test]
fn splits_and_subsegments_are_the_curve() {
    fn check<P: Space>(points: &[DVec3]) {
        let whole = curve::<P>(points);
        let points = &to_3d(whole.control_points());
        for t in EIGHTHS {
            let (left, right) = whole.split(t);
            assert_eq!((left.start(), right.end()), (whole.start(), whole.end()));
            assert_eq!(left.end(), right.start());
            assert_is_piece(&left, points, 0.0, t);
            assert_is_piece(&right, points, t, 1.0);
        }
        for (t0, t1) in [0, 1, 4, 7, 8]
            .into_iter()
            .flat_map(|i| [0, 2, 4, 8].map(|k| (EIGHTHS[i], EIGHTHS[k])))
        {
            let piece = whole.subsegment(t0..t1);
            let ends = (whole.eval(t0), whole.eval(t1));
            assert_eq!((piece.start(), piece.end()), ends);
            assert_is_piece(&piece, points, t0, t1);
        }
        let back = whole.subsegment(0.25..0.75).reverse();
        assert_eq!(whole.subsegment(0.75..0.25), back);
        assert_eq!(whole.subsegment(0.0..1.0), whole);
        // Sums and halvings round in the same way as the interpolation at ½.
        assert_eq!(whole.split(0.5), whole.halve());
    }
    adversarial_points(&ALL, |points| {
        check::<DVec2>(points);
        check::<DVec3>(points);
    });
    let expected = (bezier("0 0, 0 4, 2 6, 4 6"), bezier("4 6, 6 6, 8 4, 8 0"));
    assert_eq!(bezier("0 0, 0 8, 8 8, 8 0").halve(), expected);
}

#[test]
fn elevation_keeps_the_curve() {
    adversarial_points(&ALL, |points| {
        let whole = curve::<DVec3>(points);
        if whole.degree() == 64 {
            let error = whole.elevate().expect_err("refused");
            let expected = "degree: expected a degree below 64, got 64";
            return assert_eq!(error.to_string(), expected);
        }
        let raised = whole.elevate().expect("below 64");
        assert_eq!(raised.degree(), whole.degree() + 1);
        assert_eq!((raised.start(), raised.end()), (whole.start(), whole.end()));
        for s in EIGHTHS {
            let (got, expected) = (
                exact::eval(raised.control_points(), s),
                exact::eval(points, s),
            );
            near(got, expected, 2.0 * steps(points), largest(points));
        }
    });
    // The control points of a line at degree 64 are equally spaced.
    let mut line = bezier("0 64, 64 -64");
    while line.degree() < 64 {
        line = line.elevate().expect("below 64");
    }
    let point = |i: u32| DVec2::new(f64::from(i), 64.0 - 2.0 * f64::from(i));
    let expected: Vec<DVec2> = (0..=64).map(point).collect();
    all_near(line.control_points(), &expected, 64.0 * ulp(64.0));
    refused(line.elevate(), "Range degree");
}

#[test]
fn equal_means_near_point_by_point() {
    let (a, b) = (bezier("0 0, 1 1, 2 0"), bezier("0 0, 1 1.5, 2 0"));
    assert!(a.approx_eq(&a, 0.0) && a.approx_eq(&b, 0.5) && !a.approx_eq(&b, 0.499));
    assert!(!a.approx_eq(&a.reverse(), 1.0) && !a.approx_eq(&b, f64::NAN));
    assert!(!a.approx_eq(&a.elevate().expect("degree 2"), 100.0));
    assert_eq!(a.reverse().control_points(), xy("2 0, 1 1, 0 0"));
}

#[test]
fn parts_far_outside_stay_within_the_limit() {
    for degree in [1, 2, 3, 4, 7] {
        let points: Vec<DVec2> = (0..=degree)
            .map(|k| DVec2::new(f64::from(k * k).sin(), f64::from(k).cos()) * 1e100)
            .collect();
        let curve = Curve::new(&points).expect("finite points");
        for t in [1e250, -1e250, 1e308] {
            let (before, after) = curve.split(t);
            let part = curve.subsegment(0.0..t);
            for piece in [before, after, part] {
                let _ = Curve::new(piece.control_points()).expect("coordinates within the limit");
            }
        }
    }
}
