//! Tangents, normals and curvature where the derivative vanishes: limits.

use crate::curve::adversarial_points;
use crate::support::adversarial::ALL;
use crate::support::{Space, bezier, curve, largest, near, near_at, parameters, real, to_3d};
use casteljau::Point;
use casteljau::glam::{DVec2, DVec3};
use std::f64::consts::FRAC_1_SQRT_2;
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// The first control point that differs from an end gives the tangent at this end, whatever lies between.
#[test]
fn tangents_at_the_ends_look_to_the_next_other_point() {
    fn check<P: Space>(points: &[DVec3]) {
        let curve = curve::<P>(points);
        let control = to_3d(curve.control_points());
        let last = control[control.len() - 1];
        let mut ahead = control.iter().map(|&p| p - control[0]);
        let mut behind = control.iter().rev().map(|&p| last - p);
        let other = |v: &DVec3| *v != DVec3::ZERO;
        let (Some(start), Some(end)) = (ahead.find(other), behind.find(other)) else {
            for t in [0.0, 0.3, 1.0] {
                let found = (curve.tangent(t), curve.normal(t), curve.curvature(t));
                assert_eq!(found, (P::default(), P::default(), 0.0));
            }
            return;
        };
        for (t, direction) in [(0.0, start), (1.0, end)] {
            // A handle that is negligibly short relative to the rest may count as none.
            if direction.max_abs() > 1e-11 * real(control.len()) * largest(&control) {
                let expected = Point::unit(direction);
                near_at(curve.tangent(t).to_3d(), expected, 1e-15 * 4.0, (points, t));
            }
        }
    }
    adversarial_points(&ALL, |points| {
        check::<DVec2>(points);
        check::<DVec3>(points);
    });
}

#[test]
fn zero_length_handles() {
    let (down, diagonal) = (DVec2::NEG_Y, DVec2::splat(FRAC_1_SQRT_2));
    for (points, t, tangent) in [
        // P₁ = P₀: the tangent points towards P₂.
        ("0 0, 0 0, 1 1, 2 0", 0.0, diagonal),
        // P₂ = P₃: the tangent points away from P₁.
        ("0 2, 1 5, 1 0, 1 0", 1.0, down),
    ] {
        let curve = bezier(points);
        near(curve.tangent(t), tangent, 1e-15);
        assert_eq!(curve.normal(t), curve.tangent(t).perp());
        // Infinite, and to the right of the direction of travel.
        assert_eq!(curve.curvature(t), f64::NEG_INFINITY);
    }
    // All handles coincide with the ends: a straight line.
    let line = bezier("0 0, 0 0, 3 3, 3 3");
    for t in parameters(4) {
        near_at(line.tangent(t), diagonal, 1e-15, t);
        assert_eq!(line.curvature(t), 0.0, "{t}");
    }
    let late = bezier("0 0, 0 0, 0 0, 0 -2");
    assert_eq!((late.tangent(0.0), late.normal(0.0)), (down, DVec2::X));
    assert_eq!(late.curvature(0.0), 0.0);
}

/// (6t², t⁴) runs on y = x²/36, whose curvature at 0 is 1/18, though its derivative vanishes there.
#[test]
fn curvature_as_a_finite_limit() {
    let (slow, turned) = (
        bezier("0 0, 0 0, 1 0, 3 0, 6 1"),
        bezier("0 0, 0 0, 0 1, 0 3, 1 6"),
    );
    near(slow.curvature(0.0), 1.0 / 18.0, 1e-16);
    near(slow.reverse().curvature(1.0), -1.0 / 18.0, 1e-16);
    near(slow.curvature(1e-3), 1.0 / 18.0, 1e-7);
    near(turned.curvature(0.0), -1.0 / 18.0, 1e-16);
    let in_space = |p: &DVec2| DVec3::new(0.0, p.x, p.y);
    let space: Vec<DVec3> = turned.control_points().iter().map(in_space).collect();
    let space = curve::<DVec3>(&space);
    near(space.curvature(0.0), 1.0 / 18.0, 1e-16);
    near(space.reverse().curvature(1.0), 1.0 / 18.0, 1e-16);
}

#[test]
fn a_cusp_has_the_tangent_of_the_piece_after_it() {
    // B′(½) = 0 and B″(½) = (0, −6): the curve comes up and goes down again.
    let cusp = bezier("0 0, 1 1, 0 1, 1 0");
    assert_eq!(cusp.derivative_at(0.5, 1), DVec2::ZERO);
    assert_eq!(
        (cusp.tangent(0.5), cusp.normal(0.5)),
        (DVec2::NEG_Y, DVec2::X)
    );
    assert!(cusp.curvature(0.5).is_infinite());
    near(cusp.tangent(0.5 - 1e-9), DVec2::Y, 1e-7);
    near(cusp.tangent(0.5 + 1e-9), DVec2::NEG_Y, 1e-7);
}

/// Where the derivative is almost zero, just before and after a point where it vanishes, the tangent still points
/// forward.
#[test]
fn tangents_next_to_a_vanishing_derivative() {
    let ahead = DVec2::new(0.6, 0.8);
    let stopping = [bezier("0 0, 3 4, 3 4, 3 4"), bezier("0 0, 0 0, 3 4, 3 4")];
    for distance in [0.0, 1e-16, 1e-15, 1e-14, 1e-12, 1e-9, 1e-8, 1e-7, 1e-3] {
        for curve in &stopping {
            near_at(curve.tangent(1.0 - distance), ahead, 1e-15, distance);
            near_at(curve.reverse().tangent(distance), -ahead, 1e-15, distance);
        }
    }
    // x = 3·(t(1 − t)² − t²(1 − t)) · 3 turns back at ½ ∓ √3/6.
    let cusp = bezier("0 0, 3 4, -3 -4, 0 0");
    let turn = 0.5 - 3.0_f64.sqrt() / 6.0;
    for distance in [1e-15, 1e-14, 1e-12, 1e-6] {
        near_at(cusp.tangent(turn - distance), ahead, 1e-3, distance);
        near_at(cusp.tangent(turn + distance), -ahead, 1e-3, distance);
    }
}
