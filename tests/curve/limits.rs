//! Tangents, normals and curvature where the derivative vanishes: limits.

use crate::curve::adversarial_points;
use crate::support::adversarial::ALL;
use crate::support::{Space, curve, largest, parameters, plane, real, to_3d};
use casteljau::Point;
use casteljau::glam::{DVec2, DVec3};
use std::f64::consts::FRAC_1_SQRT_2;
use wasm_bindgen_test::wasm_bindgen_test;

/// The first control point that differs from an end gives the tangent at this end, whatever lies between.
#[wasm_bindgen_test(unsupported = test)]
fn tangents_at_the_ends_look_to_the_next_other_point() {
    fn check<P: Space>(points: &[DVec3]) {
        let curve = curve::<P>(points);
        let control = to_3d(curve.control_points());
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
            // A handle that is negligibly short relative to the rest may count as none.
            if direction.max_abs() > 1e-11 * real(control.len()) * largest(&control) {
                let error =
                    (curve.tangent(t).to_3d() - Point::normalize_or_zero(direction)).length();
                assert!(error < 1e-15 * 4.0, "{points:?} at {t}: {error:e}");
            }
        }
    }
    adversarial_points(&ALL, |points| {
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
        // Infinite, and to the right of the direction of travel.
        assert_eq!(curvature, f64::NEG_INFINITY);
    };
    // P₁ = P₀: the tangent points towards P₂.
    near(
        at(&[(0.0, 0.0), (0.0, 0.0), (1.0, 1.0), (2.0, 0.0)], 0.0),
        diagonal,
    );
    // P₂ = P₃: the tangent points away from P₁.
    near(
        at(&[(0.0, 2.0), (1.0, 5.0), (1.0, 0.0), (1.0, 0.0)], 1.0),
        down,
    );
    // All handles coincide with the ends: a straight line.
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

/// (6t², t⁴) runs on y = x²/36, whose curvature at 0 is 1/18, though its derivative vanishes there.
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
fn a_cusp_has_the_tangent_of_the_piece_after_it() {
    // B′(½) = 0 and B″(½) = (0, −6): the curve comes up and goes down again.
    let cusp = plane(&[(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]);
    assert_eq!(cusp.derivative_at(0.5, 1), DVec2::ZERO);
    assert_eq!(cusp.tangent(0.5), DVec2::NEG_Y);
    assert_eq!(cusp.normal(0.5), DVec2::X);
    assert!(cusp.curvature(0.5).is_infinite());
    assert!((cusp.tangent(0.5 - 1e-9) - DVec2::Y).length() < 1e-7);
    assert!((cusp.tangent(0.5 + 1e-9) - DVec2::NEG_Y).length() < 1e-7);
}

/// Where the derivative is almost zero, just before and after a point where it vanishes, the tangent still points
/// forward.
#[wasm_bindgen_test(unsupported = test)]
fn tangents_next_to_a_vanishing_derivative() {
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
    // x = 3·(t(1 − t)² − t²(1 − t)) · 3 turns back at ½ ∓ √3/6.
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
