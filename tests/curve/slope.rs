//! Derivatives, tangents, normals, curvature: closed forms, and limits where the derivative vanishes.

use crate::common::exact;
use crate::common::wild::ALL;
use crate::common::{Space, curve, in_space, largest, parameters, plane, real, ulp};
use crate::{assert_close, steps, wild_points};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Point};
use std::f64::consts::FRAC_1_SQRT_2;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn derivatives_of_any_order_and_degree() {
    wild_points(&ALL, |points| {
        let curve = curve::<DVec3>(points);
        let size = largest(points);
        let mut factor = 1.0;
        for order in 0..points.len().min(5) {
            for t in [0.0, 0.25, 0.5, 0.8125, 1.0] {
                let expected = exact::derivative(points, t, order);
                assert_close(
                    curve.derivative_at(t, order),
                    expected,
                    factor * steps(points),
                    size,
                );
            }
            if factor * size > 1e303 {
                break; // the true value is about to overflow
            }
            // n (n − 1) … differences, each of two numbers.
            factor *= 2.0 * real(points.len() - 1 - order);
        }
        assert_eq!(curve.derivative_at(0.3, 0), curve.eval(0.3));
        assert_eq!(curve.derivative_at(0.3, points.len()), DVec3::ZERO);
        assert_eq!(curve.derivative_at(0.3, usize::MAX), DVec3::ZERO);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn the_derivative_as_a_curve() {
    wild_points(&ALL, |points| {
        let derivative = curve::<DVec3>(points).derivative();
        assert_eq!(derivative.degree(), (points.len() - 2).max(1));
        for t in parameters(4) {
            let allowed = 2.0 * real(points.len()) * steps(points);
            assert_close(
                derivative.eval(t),
                exact::derivative(points, t, 1),
                allowed,
                largest(points),
            );
        }
    });
    // Of a line: a line whose points coincide.
    let line = plane(&[(1.0, 2.0), (4.0, 1.0)]).derivative();
    assert_eq!(line, plane(&[(3.0, -1.0), (3.0, -1.0)]));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_parabola() {
    // y = x² from −1 to 1: tangent (1, 2x), curvature 2 / (1 + 4x²)^³⁄₂.
    let parabola = plane(&[(-1.0, 1.0), (0.0, -1.0), (1.0, 1.0)]);
    for t in parameters(16) {
        let x = 2.0 * t - 1.0;
        let tangent = DVec2::new(1.0, 2.0 * x).normalize();
        assert!(
            (parabola.tangent(t) - tangent).length() < 4.0 * f64::EPSILON,
            "{t}"
        );
        assert!(
            (parabola.normal(t) - tangent.perp()).length() < 4.0 * f64::EPSILON,
            "{t}"
        );
        let curvature = 2.0 / (1.0 + 4.0 * x * x).powf(1.5);
        assert!(
            (parabola.curvature(t) / curvature - 1.0).abs() < 1e-14,
            "{t}"
        );
        assert!(
            (parabola.reverse().curvature(1.0 - t) / curvature + 1.0).abs() < 1e-14,
            "{t}"
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_twisted_cubic() {
    // (t, t², t³): κ = 2√(9t⁴ + 9t² + 1) / (9t⁴ + 4t² + 1)^³⁄₂, normal in the plane of B′ and B″.
    let third = 1.0 / 3.0;
    let points = [
        DVec3::ZERO,
        DVec3::X * third,
        DVec3::new(2.0 * third, third, 0.0),
        DVec3::ONE,
    ];
    let cubic = curve::<DVec3>(&points);
    for t in parameters(16) {
        let (first, second) = (
            DVec3::new(1.0, 2.0 * t, 3.0 * t * t),
            DVec3::new(0.0, 2.0, 6.0 * t),
        );
        assert!((cubic.tangent(t) - first.normalize()).length() < 1e-15);
        let normal = (second - first * (second.dot(first) / first.length_squared())).normalize();
        assert!((cubic.normal(t) - normal).length() < 1e-14, "{t}");
        let (a, b) = (9.0 * t.powi(4), t * t);
        let curvature = 2.0 * (a + 9.0 * b + 1.0).sqrt() / (a + 4.0 * b + 1.0).powf(1.5);
        assert!((cubic.curvature(t) / curvature - 1.0).abs() < 1e-13, "{t}");
        assert!(
            (cubic.reverse().curvature(1.0 - t) / curvature - 1.0).abs() < 1e-13,
            "never negative"
        );
        assert!(
            (cubic.reverse().normal(1.0 - t) - normal).length() < 1e-14,
            "{t}"
        );
    }
}

/// The first point that differs from an end gives the direction there, whatever lies in between.
#[wasm_bindgen_test(unsupported = test)]
fn tangents_at_the_ends_look_to_the_next_other_point() {
    fn check<P: Space>(points: &[DVec3]) {
        let curve = curve::<P>(points);
        let control = in_space(curve.control_points());
        let start = control
            .iter()
            .map(|&p| p - control[0])
            .find(|v| *v != DVec3::ZERO);
        let Some(start) = start else {
            let all =
                [0.0, 0.3, 1.0].map(|t| (curve.tangent(t), curve.normal(t), curve.curvature(t)));
            assert_eq!(all, [(P::default(), P::default(), 0.0); 3]);
            return;
        };
        let last = control[control.len() - 1];
        let end = control
            .iter()
            .rev()
            .map(|&p| last - p)
            .find(|v| *v != DVec3::ZERO)
            .expect("two places");
        for (t, direction) in [(0.0, start), (1.0, end)] {
            // Next to nothing beside the rest, a handle may count as none.
            if direction.max_abs() > 1e-11 * real(control.len()) * largest(&control) {
                let error = (curve.tangent(t).in_space() - direction.unit()).length();
                assert!(error < 1e-15 * 4.0, "{points:?} at {t}: {error:e}");
            }
        }
    }
    wild_points(&ALL, |points| {
        check::<DVec2>(points);
        check::<DVec3>(points);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn zero_length_handles() {
    let at = |points: &[(f64, f64)], t: f64| {
        let curve = plane(points);
        (curve.tangent(t), curve.normal(t), curve.curvature(t))
    };
    let (down, diagonal) = (DVec2::NEG_Y, DVec2::splat(FRAC_1_SQRT_2));
    let near = |(tangent, normal, curvature): (DVec2, DVec2, f64), expected: DVec2| {
        assert!(
            (tangent - expected).length() < 1e-15,
            "{tangent} instead of {expected}"
        );
        assert_eq!(normal, tangent.perp());
        // Without bound, and to the right of the way.
        assert_eq!(curvature, f64::NEG_INFINITY);
    };
    // P₁ = P₀: towards P₂.
    near(
        at(&[(0.0, 0.0), (0.0, 0.0), (1.0, 1.0), (2.0, 0.0)], 0.0),
        diagonal,
    );
    // P₂ = P₃: from P₁.
    near(
        at(&[(0.0, 2.0), (1.0, 5.0), (1.0, 0.0), (1.0, 0.0)], 1.0),
        down,
    );
    // All handles on the ends: a straight line.
    let line = [(0.0, 0.0), (0.0, 0.0), (3.0, 3.0), (3.0, 3.0)];
    for t in parameters(4) {
        let (tangent, _, curvature) = at(&line, t);
        assert!(
            (tangent - diagonal).length() < 1e-15 && curvature == 0.0,
            "{t}"
        );
    }
    assert_eq!(
        at(&[(0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (0.0, -2.0)], 0.0),
        (down, DVec2::X, 0.0)
    );
}

/// (6t², t⁴) runs on y = x²/36, which bends by 1/18, though its derivative vanishes at 0.
#[wasm_bindgen_test(unsupported = test)]
fn curvature_as_a_finite_limit() {
    let slow = plane(&[(0.0, 0.0), (0.0, 0.0), (1.0, 0.0), (3.0, 0.0), (6.0, 1.0)]);
    assert!((slow.curvature(0.0) - 1.0 / 18.0).abs() < 1e-16);
    assert!((slow.reverse().curvature(1.0) + 1.0 / 18.0).abs() < 1e-16);
    assert!((slow.curvature(1e-3) - 1.0 / 18.0).abs() < 1e-7);
    let turned = [(0.0, 0.0), (0.0, 0.0), (0.0, 1.0), (0.0, 3.0), (1.0, 6.0)];
    assert!((plane(&turned).curvature(0.0) + 1.0 / 18.0).abs() < 1e-16);
    let space: Vec<DVec3> = turned.iter().map(|&(x, y)| DVec3::new(0.0, x, y)).collect();
    let space = curve::<DVec3>(&space);
    for limit in [space.curvature(0.0), space.reverse().curvature(1.0)] {
        assert!((limit - 1.0 / 18.0).abs() < 1e-16, "{limit}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_cusp_has_the_tangent_of_its_way_out() {
    // B′(½) = 0, B″(½) = (0, −6): it comes up and goes down again.
    let cusp = plane(&[(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]);
    assert_eq!(cusp.derivative_at(0.5, 1), DVec2::ZERO);
    assert_eq!(cusp.tangent(0.5), DVec2::NEG_Y);
    assert_eq!(cusp.normal(0.5), DVec2::X);
    assert!(cusp.curvature(0.5).is_infinite());
    assert!((cusp.tangent(0.5 - 1e-9) - DVec2::Y).length() < 1e-7);
    assert!((cusp.tangent(0.5 + 1e-9) - DVec2::NEG_Y).length() < 1e-7);
}

#[wasm_bindgen_test(unsupported = test)]
fn straight_curves_have_no_principal_normal_and_no_curvature() {
    // Even steps of whole numbers, so that no rounding bends the line.
    let (from, step) = (DVec3::new(1.0, -2.0, 5.0), DVec3::new(3.0, 1.0, -7.0));
    for degree in 1..=12 {
        let points: Vec<DVec3> = (0..=degree).map(|i| from + step * real(i)).collect();
        let line = curve::<DVec3>(&points);
        for t in [0.0, 0.4, 1.0] {
            assert!((line.tangent(t) - step.normalize()).length() < 1e-15);
            assert_eq!(
                (line.normal(t), line.curvature(t)),
                (DVec3::ZERO, 0.0),
                "degree {degree}"
            );
        }
    }
}

/// Unit vectors, right angles, the same in the plane and in space, no NaN: on every curve, at every t.
#[wasm_bindgen_test(unsupported = test)]
fn directions_are_unit_vectors_at_right_angles() {
    wild_points(&ALL, |points| {
        let space = curve::<DVec3>(points);
        let flat: Curve<DVec2> = curve(points);
        for t in parameters(8) {
            let (tangent, normal) = (space.tangent(t), space.normal(t));
            for v in [
                tangent,
                normal,
                flat.tangent(t).extend(0.0),
                flat.normal(t).extend(0.0),
            ] {
                assert!(
                    v == DVec3::ZERO || (v.length() - 1.0).abs() < 1e-15,
                    "{points:?} at {t}: {v}"
                );
            }
            let along = tangent.dot(normal);
            assert!(
                along.abs() < 1e-15,
                "{points:?} at {t}: {along:e} {tangent} {normal}"
            );
            assert_eq!(flat.tangent(t).perp(), flat.normal(t));
            assert!(
                !space.curvature(t).is_nan() && space.curvature(t) >= 0.0,
                "{points:?} at {t}"
            );
            assert!(!flat.curvature(t).is_nan(), "{points:?} at {t}");
        }
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn directions_follow_the_scale_of_the_curve() {
    let base = [(0.0, 0.0), (1.0, 2.0), (3.0, 3.0), (4.0, 0.0)];
    let whole = plane(&base);
    for scale in [2.0_f64.powi(990), 2.0_f64.powi(-990), 2.0_f64.powi(-1000)] {
        let scaled = plane(&base.map(|(x, y)| (x * scale, y * scale)));
        for t in parameters(8) {
            assert_eq!(scaled.tangent(t), whole.tangent(t), "{scale}");
            let (got, expected) = (scaled.curvature(t), whole.curvature(t) / scale);
            assert!(
                (got - expected).abs() <= 8.0 * ulp(expected),
                "{scale} at {t}: {got} {expected}"
            );
        }
    }
}

/// Where the derivative is next to nothing, just before and after a place where it vanishes, the way is still forward.
#[wasm_bindgen_test(unsupported = test)]
fn tangents_beside_a_place_where_the_derivative_vanishes() {
    let slowing = [(0.0, 0.0), (3.0, 4.0), (3.0, 4.0), (3.0, 4.0)];
    let stopping = [(0.0, 0.0), (0.0, 0.0), (3.0, 4.0), (3.0, 4.0)];
    let cusp = [(0.0, 0.0), (3.0, 4.0), (-3.0, -4.0), (0.0, 0.0)];
    let ahead = DVec2::new(0.6, 0.8);
    for distance in [0.0, 1e-16, 1e-15, 1e-14, 1e-12, 1e-9, 1e-8, 1e-7, 1e-3] {
        for points in [slowing, stopping] {
            assert!(
                (plane(&points).tangent(1.0 - distance) - ahead).length() < 1e-15,
                "{distance}"
            );
            assert!(
                (plane(&points).reverse().tangent(distance) + ahead).length() < 1e-15,
                "{distance}"
            );
        }
    }
    // x = 3·(t(1 − t)² − t²(1 − t)) · 3 turns at ½ ∓ √3/6.
    let turn = 0.5 - 3.0_f64.sqrt() / 6.0;
    for distance in [1e-15, 1e-14, 1e-12, 1e-6] {
        assert!(
            (plane(&cusp).tangent(turn - distance) - ahead).length() < 1e-3,
            "{distance}"
        );
        assert!(
            (plane(&cusp).tangent(turn + distance) + ahead).length() < 1e-3,
            "{distance}"
        );
    }
}
