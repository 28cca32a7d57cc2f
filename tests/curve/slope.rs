//! Derivatives, tangents, normals and curvature, compared with closed forms.

use crate::curve::{adversarial_points, near, outside, steps};
use crate::support::adversarial::ALL;
use crate::support::{bezier, curve, exact, largest, near_at, parameters, real, ulp};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, MAX_COORDINATE, Point};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn derivatives_of_any_order_and_degree() {
    adversarial_points(&ALL, |points| {
        let curve = curve::<DVec3>(points);
        let size = largest(points);
        let mut factor = 1.0;
        for order in 0..points.len().min(5) {
            for t in [0.0, 0.25, 0.5, 0.8125, 1.0] {
                let expected = exact::derivative(points, t, order);
                let got = curve.derivative_at(t, order);
                near(got, expected, factor * steps(points), size);
            }
            for (t, growth) in outside(points) {
                let expected = exact::derivative(points, t, order);
                let got = curve.derivative_at(t, order);
                near(got, expected, growth * factor * steps(points), size);
            }
            if factor * size > 1e303 {
                break; // the true value is about to overflow
            }
            // n (n − 1) … differences of two numbers each.
            factor *= 2.0 * real(points.len() - 1 - order);
        }
        assert_eq!(curve.derivative_at(0.3, 0), curve.eval(0.3));
        for order in [points.len(), usize::MAX] {
            assert_eq!(curve.derivative_at(0.3, order), DVec3::ZERO);
        }
    });
}

#[test]
fn the_derivative_as_a_curve() {
    adversarial_points(&ALL, |points| {
        let derivative = curve::<DVec3>(points).derivative();
        assert_eq!(derivative.degree(), (points.len() - 2).max(1));
        for t in parameters(4) {
            let allowed = 2.0 * real(points.len()) * steps(points);
            let expected = exact::derivative(points, t, 1);
            near(derivative.eval(t), expected, allowed, largest(points));
        }
    });
    let far = Curve::line(DVec2::X * -MAX_COORDINATE, DVec2::new(MAX_COORDINATE, 1.0));
    let limit = DVec2::new(MAX_COORDINATE, 1.0);
    assert_eq!(far.derivative().start(), limit, "set to the limit");
    // The derivative of a line is a line whose control points coincide.
    assert_eq!(bezier("1 2, 4 1").derivative(), bezier("3 -1, 3 -1"));
}

#[test]
fn a_parabola() {
    // y = x² from −1 to 1 has the tangent (1, 2x) and the curvature 2 / (1 + 4x²)^³⁄₂.
    let parabola = bezier("-1 1, 0 -1, 1 1");
    for t in parameters(16) {
        let x = 2.0 * t - 1.0;
        let tangent = DVec2::new(1.0, 2.0 * x).normalize();
        near_at(parabola.tangent(t), tangent, 4.0 * f64::EPSILON, t);
        near_at(parabola.normal(t), tangent.perp(), 4.0 * f64::EPSILON, t);
        let curvature = 2.0 / (1.0 + 4.0 * x * x).powf(1.5);
        let back = parabola.reverse().curvature(1.0 - t);
        near_at(parabola.curvature(t) / curvature, 1.0, 1e-14, t);
        near_at(back / curvature, -1.0, 1e-14, t);
    }
}

#[test]
fn a_twisted_cubic() {
    // (t, t², t³): κ = 2√(9t⁴ + 9t² + 1) / (9t⁴ + 4t² + 1)^³⁄₂; the normal lies in the plane of B′ and B″.
    let third = 1.0 / 3.0;
    let p2 = DVec3::new(2.0 * third, third, 0.0);
    let cubic = Curve::cubic(DVec3::ZERO, DVec3::X * third, p2, DVec3::ONE);
    let back = cubic.reverse();
    for t in parameters(16) {
        let first = DVec3::new(1.0, 2.0 * t, 3.0 * t * t);
        let second = DVec3::new(0.0, 2.0, 6.0 * t);
        near_at(cubic.tangent(t), first.normalize(), 1e-15, t);
        let normal = (second - first * (second.dot(first) / first.length_squared())).normalize();
        near_at(cubic.normal(t), normal, 1e-14, t);
        near_at(back.normal(1.0 - t), normal, 1e-14, t);
        let (a, b) = (9.0 * t.powi(4), t * t);
        let curvature = 2.0 * (a + 9.0 * b + 1.0).sqrt() / (a + 4.0 * b + 1.0).powf(1.5);
        near_at(cubic.curvature(t) / curvature, 1.0, 1e-13, t);
        // Never negative in space.
        near_at(back.curvature(1.0 - t) / curvature, 1.0, 1e-13, t);
    }
}

#[test]
fn straight_curves_have_no_principal_normal_and_no_curvature() {
    // Equal steps of integers, so that rounding does not bend the line.
    let (from, step) = (DVec3::new(1.0, -2.0, 5.0), DVec3::new(3.0, 1.0, -7.0));
    for degree in 1..=12 {
        let points: Vec<DVec3> = (0..=degree).map(|i| from + step * real(i)).collect();
        let line = curve::<DVec3>(&points);
        for t in [0.0, 0.4, 1.0] {
            near_at(line.tangent(t), step.normalize(), 1e-15, degree);
            let found = (line.normal(t), line.curvature(t));
            assert_eq!(found, (DVec3::ZERO, 0.0), "degree {degree}");
        }
    }
}

/// Directions are orthonormal, equal in the plane and in space, and without NaN: on every curve, at every t. The tangent
/// has the direction of the derivative, unless this is lost in the rounding of the control points.
#[test]
fn directions_are_unit_vectors_at_right_angles() {
    adversarial_points(&ALL, |points| {
        let (space, plane) = (curve::<DVec3>(points), curve::<DVec2>(points));
        let scale = real(points.len()) * largest(points);
        let inside = parameters(8).map(|t| (t, 1.0));
        for (t, growth) in inside.chain(outside(points)) {
            let scale = scale * growth;
            let (tangent, normal) = (space.tangent(t), space.normal(t));
            let flat = [plane.tangent(t).extend(0.0), plane.normal(t).extend(0.0)];
            for v in [tangent, normal, flat[0], flat[1]] {
                let unit = v == DVec3::ZERO || (v.length() - 1.0).abs() < 1e-15;
                assert!(unit, "{points:?} at {t}: {v}");
            }
            near_at(tangent.dot(normal), 0.0, 1e-15, (points, t));
            assert_eq!(plane.tangent(t).perp(), plane.normal(t));
            let curvatures = [space.curvature(t), plane.curvature(t)];
            let valid = curvatures[0] >= 0.0 && !curvatures[1].is_nan();
            assert!(valid, "{points:?} at {t}: {curvatures:?}");
            let derivative = exact::derivative(points, t, 1);
            if derivative.max_abs() > 1e-6 * scale {
                let direction = Point::unit(derivative);
                let max = 1e-15 * scale / derivative.max_abs() * steps(points);
                near_at(tangent, direction, max, (points, t));
            }
        }
    });
}

#[test]
fn directions_follow_the_scale_of_the_curve() {
    let whole = bezier("0 0, 1 2, 3 3, 4 0");
    for scale in [498, -990, -1000].map(|k| 2.0_f64.powi(k)) {
        let points: Vec<DVec2> = whole.control_points().iter().map(|&p| p * scale).collect();
        let scaled = Curve::new(&points).expect("finite");
        for t in parameters(8) {
            assert_eq!(scaled.tangent(t), whole.tangent(t), "{scale}");
            let expected = whole.curvature(t) / scale;
            near_at(
                scaled.curvature(t),
                expected,
                8.0 * ulp(expected),
                (scale, t),
            );
        }
    }
}
