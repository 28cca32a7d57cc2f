//! Splitting, reversing, elevating and mapping leave the curve unchanged.

use crate::curve::{adversarial_points, assert_close, steps};
use crate::support::adversarial::ALL;
use crate::support::exact;
use crate::support::{Rng, Space, curve, largest, plane, real, to_3d};
use casteljau::glam::{DAffine2, DAffine3, DMat3, DVec2, DVec3};
use casteljau::{Curve, Error};
use wasm_bindgen_test::wasm_bindgen_test;

/// Eighths, whose products and differences are exact.
const EIGHTHS: [f64; 9] = [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0];

/// Asserts that `piece` at s is the whole curve at t₀ + (t₁ − t₀)s.
fn assert_is_piece<P: Space>(piece: &Curve<P>, whole: &[DVec3], t0: f64, t1: f64) {
    let control = to_3d(piece.control_points());
    for s in EIGHTHS {
        let expected = exact::eval(whole, t0 + (t1 - t0) * s);
        assert_close(
            exact::eval(&control, s),
            expected,
            2.0 * steps(whole),
            largest(whole),
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_two_sides_of_a_split_are_the_curve() {
    fn check<P: Space>(points: &[DVec3]) {
        let whole = curve::<P>(points);
        let points = &to_3d(whole.control_points());
        for t in EIGHTHS {
            let (left, right) = whole.split(t);
            assert_eq!(
                (left.degree(), right.degree()),
                (whole.degree(), whole.degree())
            );
            assert_eq!((left.start(), right.end()), (whole.start(), whole.end()));
            assert_eq!(left.end(), right.start());
            assert_is_piece(&left, points, 0.0, t);
            assert_is_piece(&right, points, t, 1.0);
        }
    }
    adversarial_points(&ALL, |points| {
        check::<DVec2>(points);
        check::<DVec3>(points);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn halves_join_to_the_curve_and_equal_the_split_at_a_half() {
    adversarial_points(&ALL, |points| {
        let whole = curve::<DVec3>(points);
        let (left, right) = whole.halve();
        assert_eq!((left.start(), right.end()), (whole.start(), whole.end()));
        assert_eq!(left.end(), right.start());
        assert_is_piece(&left, points, 0.0, 0.5);
        assert_is_piece(&right, points, 0.5, 1.0);
        // Sums and halvings round in the same way as the interpolation at ½.
        assert_eq!(whole.split(0.5), (left, right));
    });
    let (left, right) = plane(&[(0.0, 0.0), (0.0, 8.0), (8.0, 8.0), (8.0, 0.0)]).halve();
    assert_eq!(
        left,
        plane(&[(0.0, 0.0), (0.0, 4.0), (2.0, 6.0), (4.0, 6.0)])
    );
    assert_eq!(
        right,
        plane(&[(4.0, 6.0), (6.0, 6.0), (8.0, 4.0), (8.0, 0.0)])
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_split_outside_extends_the_curve() {
    let points = [
        DVec3::ZERO,
        DVec3::new(1.0, 2.0, 0.0),
        DVec3::new(3.0, 1.0, -1.0),
        DVec3::X,
    ];
    let whole = curve::<DVec3>(&points);
    for t in [-1.0, 1.5, 2.0] {
        let (left, right) = whole.split(t);
        assert_close(left.end(), exact::eval(&points, t), 64.0, 16.0);
        assert_close(left.eval(0.5), exact::eval(&points, 0.5 * t), 64.0, 16.0);
        assert_close(
            right.eval(0.5),
            exact::eval(&points, 0.5 * (1.0 + t)),
            64.0,
            16.0,
        );
        assert_eq!(right.end(), points[3]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn subsegments_are_pieces() {
    fn check<P: Space>(points: &[DVec3]) {
        let whole = curve::<P>(points);
        let points = &to_3d(whole.control_points());
        for t0 in [0.0, 0.125, 0.5, 0.875, 1.0] {
            for t1 in [0.0, 0.25, 0.5, 1.0] {
                let piece = whole.subsegment(t0, t1);
                assert_eq!(piece.degree(), whole.degree());
                assert_eq!(
                    (piece.start(), piece.end()),
                    (whole.eval(t0), whole.eval(t1))
                );
                assert_is_piece(&piece, points, t0, t1);
            }
        }
        assert_eq!(
            whole.subsegment(0.75, 0.25),
            whole.subsegment(0.25, 0.75).reverse()
        );
        assert_eq!(whole.subsegment(0.0, 1.0), whole);
    }
    adversarial_points(&ALL, |points| {
        check::<DVec2>(points);
        check::<DVec3>(points);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn subsegments_reach_outside() {
    let points = [
        DVec3::ZERO,
        DVec3::new(2.0, 4.0, 0.0),
        DVec3::new(4.0, 0.0, 2.0),
    ];
    let whole = curve::<DVec3>(&points);
    for (t0, t1) in [
        (-1.0, 0.5),
        (0.5, 2.0),
        (-1.0, 2.0),
        (1.0, 3.0),
        (-2.0, 0.0),
        (2.0, -1.0),
    ] {
        let piece = whole.subsegment(t0, t1);
        for s in EIGHTHS {
            assert_close(
                piece.eval(s),
                exact::eval(&points, t0 + (t1 - t0) * s),
                256.0,
                32.0,
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn reversing_keeps_the_curve_and_twice_is_the_curve_itself() {
    adversarial_points(&ALL, |points| {
        let whole = curve::<DVec3>(points);
        let back = whole.reverse();
        assert_eq!((back.start(), back.end()), (whole.end(), whole.start()));
        assert_is_piece(&back, points, 1.0, 0.0);
        assert_eq!(back.reverse(), whole);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn elevation_keeps_the_curve() {
    adversarial_points(&ALL, |points| {
        let whole = curve::<DVec3>(points);
        if whole.degree() == 64 {
            let refused = Err(Error::Range {
                what: "degree",
                expected: "a degree below 64",
                got: 64.0,
            });
            assert_eq!(whole.elevate(), refused);
            return;
        }
        let raised = whole.elevate().expect("below 64");
        assert_eq!(raised.degree(), whole.degree() + 1);
        assert_eq!((raised.start(), raised.end()), (whole.start(), whole.end()));
        assert_is_piece(&raised, points, 0.0, 1.0);
    });
}

/// The control points of a line at degree 64 are equally spaced.
#[wasm_bindgen_test(unsupported = test)]
fn a_line_can_be_elevated_to_degree_64() {
    let mut line = plane(&[(0.0, 64.0), (64.0, -64.0)]);
    while line.degree() < 64 {
        line = line.elevate().expect("below 64");
    }
    for (i, p) in line.control_points().iter().enumerate() {
        assert_close(
            p.extend(0.0),
            DVec3::new(real(i), 64.0 - 2.0 * real(i), 0.0),
            64.0,
            64.0,
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn maps_move_the_curve_with_its_control_points() {
    let mut rng = Rng(2);
    for degree in [1, 2, 3, 5, 20] {
        let points: Vec<DVec3> = (0..=degree).map(|_| rng.point(3)).collect();
        let columns = DMat3::from_cols(rng.point(3), rng.point(3), rng.point(3));
        let map = DAffine3::from_mat3_translation(columns, rng.point(3));
        let whole = curve::<DVec3>(&points);
        for t in EIGHTHS {
            assert_close(
                whole.transform(&map).expect("a finite image").eval(t),
                map.transform_point3(whole.eval(t)),
                2.0 * steps(&points),
                4.0,
            );
        }
    }
    let quarter_turn = DAffine2::from_cols(DVec2::Y, -DVec2::X, DVec2::new(10.0, 0.0));
    let turned = plane(&[(1.0, 2.0), (3.0, 4.0)])
        .transform(&quarter_turn)
        .expect("a finite image");
    assert_eq!(turned, plane(&[(8.0, 1.0), (6.0, 3.0)]));
}

#[wasm_bindgen_test(unsupported = test)]
fn equal_means_near_point_by_point() {
    let a = plane(&[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)]);
    let b = plane(&[(0.0, 0.0), (1.0, 1.5), (2.0, 0.0)]);
    assert!(a.approx_eq(&a, 0.0) && a.approx_eq(&b, 0.5) && !a.approx_eq(&b, 0.499));
    assert!(
        !a.approx_eq(&a.reverse(), 1.0) && !a.approx_eq(&a.elevate().expect("degree 2"), 100.0)
    );
    assert!(!a.approx_eq(&b, f64::NAN));
}
