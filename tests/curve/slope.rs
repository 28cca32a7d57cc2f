//! Derivatives, tangents, normals and curvature, compared with closed forms.

use crate::curve::{adversarial_points, assert_close, steps};
use crate::support::adversarial::ALL;
use crate::support::exact;
use crate::support::{curve, largest, parameters, plane, real, ulp};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, MAX_COORDINATE};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn derivatives_of_any_order_and_degree() {
    adversarial_points(&ALL, |points| {
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
            // n (n − 1) … differences of two numbers each.
            factor *= 2.0 * real(points.len() - 1 - order);
        }
        assert_eq!(curve.derivative_at(0.3, 0), curve.eval(0.3));
        assert_eq!(curve.derivative_at(0.3, points.len()), DVec3::ZERO);
        assert_eq!(curve.derivative_at(0.3, usize::MAX), DVec3::ZERO);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn the_derivative_as_a_curve() {
    adversarial_points(&ALL, |points| {
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
    let far = plane(&[(-MAX_COORDINATE, 0.0), (MAX_COORDINATE, 1.0)]).derivative();
    assert_eq!(
        far.start(),
        DVec2::new(MAX_COORDINATE, 1.0),
        "set to the limit"
    );
    // The derivative of a line is a line whose control points coincide.
    let line = plane(&[(1.0, 2.0), (4.0, 1.0)]).derivative();
    assert_eq!(line, plane(&[(3.0, -1.0), (3.0, -1.0)]));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_parabola() {
    // y = x² from −1 to 1 has the tangent (1, 2x) and the curvature 2 / (1 + 4x²)^³⁄₂.
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
    // (t, t², t³): κ = 2√(9t⁴ + 9t² + 1) / (9t⁴ + 4t² + 1)^³⁄₂; the normal lies in the plane of B′ and B″.
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

#[wasm_bindgen_test(unsupported = test)]
fn straight_curves_have_no_principal_normal_and_no_curvature() {
    // Equal steps of integers, so that rounding does not bend the line.
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

/// Directions are orthonormal, equal in the plane and in space, and without NaN: on every curve, at every t.
#[wasm_bindgen_test(unsupported = test)]
fn directions_are_unit_vectors_at_right_angles() {
    adversarial_points(&ALL, |points| {
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
    for scale in [2.0_f64.powi(498), 2.0_f64.powi(-990), 2.0_f64.powi(-1000)] {
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
