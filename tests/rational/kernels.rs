//! Lengths and nearest points of conics and cubics beside the same curves in another form: with other weights, which change only the
//! parameter, or elevated, for which the general algorithms are used.

use super::{random_curve, unit_arc, within};
use crate::support::Rng;
use casteljau::curve::Nearest;
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, RationalCurve};

/// The curve with the weights wᵢρⁱ.
fn with_ratio(curve: &RationalCurve<DVec2>, ratio: f64) -> RationalCurve<DVec2> {
    let powers = (0..).map(|i| ratio.powi(i));
    let weights: Vec<f64> = curve
        .weights()
        .iter()
        .zip(powers)
        .map(|(w, p)| w * p)
        .collect();
    RationalCurve::new(curve.control_points(), &weights).expect("valid")
}

/// The curve in a plane in space that is at an angle to the axes.
fn in_space(curve: &RationalCurve<DVec2>) -> RationalCurve<DVec3> {
    let points: Vec<DVec3> = curve.control_points().iter().map(|&p| lifted(p)).collect();
    RationalCurve::new(&points, curve.weights()).expect("valid")
}

fn lifted(p: DVec2) -> DVec3 {
    DVec3::new(0.6 * p.x, p.y, 0.8 * p.x)
}

fn assert_length(curve: &RationalCurve<DVec2>, expected: f64) {
    for found in [curve.length(), in_space(curve).length()] {
        let off = (found - expected) / expected;
        assert!(off.abs() <= 1e-12, "{curve:?}: {found}, off by {off:e}");
    }
}

#[test]
fn lengths_of_arcs_with_extreme_weights() {
    for k in 1..20 {
        let alpha = 0.07 * f64::from(k);
        let arc = unit_arc(alpha);
        for exponent in -50..=50 {
            let arc = with_ratio(&arc, f64::from(exponent).exp2());
            assert_length(&arc, 2.0 * alpha);
            assert_length(&arc.elevate().expect("a degree"), 2.0 * alpha);
        }
    }
}

#[test]
fn times_at_lengths_with_extreme_weights() {
    for exponent in [-50, -30, -22, -12, 0, 15, 30, 50] {
        let arc = with_ratio(&unit_arc(0.7), f64::from(exponent).exp2());
        for s in [1e-3, 0.1, 0.5, 0.7, 1.2, 1.3999] {
            let t = arc.time_at_length(s);
            // Near t = 1, the next number is far away on the curve if the last weight is small.
            let next = (arc.eval(t.next_up().min(1.0)) - arc.eval(t.next_down())).length();
            let off = (arc.eval(t) - DVec2::new(s.cos(), s.sin())).length();
            assert!(off <= 2e-12 + next, "2^{exponent} at {s}: {off:e}");
        }
        assert_eq!(arc.time_at_length(-1.0), 0.0);
        assert_eq!(arc.time_at_length(1.5), 1.0);
        assert!(arc.time_at_length(f64::NAN).is_nan());
    }
}

#[test]
fn lengths_of_polynomial_cubics_with_extreme_weights() {
    let mut rng = Rng(31);
    for k in 0..2000 {
        let cubic = random_curve(&mut rng, 3, 0.0);
        let length = Curve::new(cubic.control_points()).expect("valid").length();
        assert_length(&with_ratio(&cubic, f64::from(k % 67 - 33).exp2()), length);
    }
}

/// Cusps, reversals, and loops that end where they start.
#[test]
fn lengths_of_degenerate_curves() {
    let cubics = [
        [(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)],
        [(0.0, 0.0), (3.0, 0.0), (-2.0, 0.0), (1.0, 0.0)],
        [(0.0, 0.0), (3.0, 1.0), (-2.0, 1.0), (0.0, 0.0)],
        [(1.0, 2.0), (1.0, 2.0), (1.0, 2.0), (4.0, 6.0)],
    ];
    for points in cubics {
        let points = points.map(DVec2::from);
        let length = Curve::new(&points).expect("valid").length();
        for ratio in [1.0, 0.25, 8.0] {
            let cubic = RationalCurve::new(&points, &[1.0; 4]).expect("valid");
            assert_length(&with_ratio(&cubic, ratio), length);
        }
    }
    let line = RationalCurve::new(&[DVec2::ZERO, DVec2::new(3.0, 4.0)], &[1.0, 7.0]);
    assert_eq!(line.expect("valid").length(), 5.0);
    // There and back: half of the way is the height of a conic, w/(1 + w).
    for exponent in [-9, 0, 9] {
        let w = f64::from(exponent).exp2();
        let conic = RationalCurve::conic(DVec2::ZERO, DVec2::X, DVec2::ZERO, w).expect("valid");
        assert_length(&conic, 2.0 * w / (1.0 + w));
    }
    let point = RationalCurve::new(&[DVec2::ONE; 4], &[1.0, 2.0, 3.0, 4.0]).expect("valid");
    assert_eq!(point.length(), 0.0);
}

#[test]
fn lengths_of_elevated_curves() {
    let mut rng = Rng(32);
    for k in 0..2000 {
        let degree = 2 + k % 2;
        let curve = random_curve(&mut rng, degree, 5.0);
        let mut elevated = curve.elevate().expect("a degree");
        if degree == 2 {
            elevated = elevated.elevate().expect("a degree");
        }
        assert_length(&curve, elevated.length());
    }
}

#[test]
fn nearest_points_of_curves_with_other_weights() {
    let mut rng = Rng(33);
    for k in 0..4000 {
        let degree = 2 + k % 2;
        let curve = random_curve(&mut rng, degree, (k % 8) as f64);
        // A curve may pass through the point.
        let p = if k % 7 == 0 {
            curve.eval(0.3)
        } else {
            DVec2::new(within(&mut rng, -1.5, 1.5), within(&mut rng, -1.5, 1.5))
        };
        let mut elevated = curve.clone();
        while elevated.degree() < 5 {
            elevated = elevated.elevate().expect("a degree");
        }
        let expected = elevated.nearest(p).expect("finite").distance;
        let Nearest { t, point, distance } = curve.nearest(p).expect("finite");
        assert!(
            (distance - expected).abs() < 1e-14,
            "{curve:?} {p}: {distance} {expected}"
        );
        assert_eq!(point, curve.eval(t));
        let space = in_space(&curve).nearest(lifted(p)).expect("finite");
        assert!(
            (space.distance - expected).abs() < 1e-14,
            "{curve:?} {p} {space:?}"
        );
        let ratio = ((k % 21) as f64).exp2();
        let other = with_ratio(&curve, ratio).nearest(p).expect("finite");
        assert!(
            (other.distance - expected).abs() < 1e-14,
            "{curve:?} {p} {ratio}"
        );
    }
}
