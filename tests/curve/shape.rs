//! Bounding boxes and convex hulls: they contain the curve and are as small as possible.

use crate::curve::{adversarial_points, steps};
use crate::support::adversarial::ALL;
use crate::support::{bezier, curve, exact, highest, largest, near, near_at, real, ulp, xy};
use casteljau::Curve;
use casteljau::glam::{DVec2, DVec3};
#[cfg(target_family = "wasm")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// The maximum of one coordinate (times `sign`), by samples and golden-section search in double the precision of f64.
fn greatest(points: &[DVec3], axis: usize, sign: f64) -> f64 {
    const SAMPLES: usize = 64;
    let coordinates: Vec<f64> = points.iter().map(|p| sign * p[axis]).collect();
    let at = |t: f64| exact::eval_scalar(&coordinates, t).hi;
    let values: Vec<f64> = (0..=SAMPLES).map(|i| at(real(i) / real(SAMPLES))).collect();
    let max = values.iter().copied().fold(f64::MIN, f64::max);
    let min = values.iter().copied().fold(f64::MAX, f64::min);
    // Searches around each sample that may be next to the maximum, including those at the ends.
    let near = |&i: &usize| values[i] >= max - 0.05 * (max - min);
    let around = |i: usize| [i.max(1) - 1, (i + 1).min(SAMPLES)].map(|i| real(i) / real(SAMPLES));
    let peaks = (0..=SAMPLES)
        .filter(near)
        .map(|i| highest(at, around(i), 40));
    peaks.fold(max, f64::max)
}

#[test]
fn the_box_contains_the_curve_and_is_touched() {
    adversarial_points(&ALL, |points| {
        let curve = curve::<DVec3>(points);
        let (bounds, control) = (curve.bounds(), curve.control_bounds());
        let corner = |pick: fn(DVec3, DVec3) -> DVec3| points.iter().copied().reduce(pick);
        let corners = (corner(DVec3::min), corner(DVec3::max));
        assert_eq!((Some(control.min), Some(control.max)), corners);
        let rounding = steps(points) * ulp(largest(points));
        let slack = DVec3::splat(rounding);
        assert!(bounds.min.cmpge(control.min - slack).all(), "{points:?}");
        assert!(bounds.max.cmple(control.max + slack).all(), "{points:?}");
        assert!(bounds.min.cmple(bounds.max).all(), "{points:?}");
        if points.len() > 14 {
            return;
        }
        for axis in 0..3 {
            near_at(
                bounds.max[axis],
                greatest(points, axis, 1.0),
                rounding,
                points,
            );
            near_at(
                bounds.min[axis],
                -greatest(points, axis, -1.0),
                rounding,
                points,
            );
        }
        let plane: Curve<DVec2> = crate::support::curve(points);
        let expected = (bounds.min.truncate(), bounds.max.truncate());
        assert_eq!((plane.bounds().min, plane.bounds().max), expected);
    });
    assert_eq!(bezier("-3e149 0, 0 4e149").bounds().diagonal(), 5e149);
}

#[test]
fn boxes_by_closed_forms() {
    // y = 2t(1 − t) has its maximum at ½.
    let arch = bezier("0 0, 1 1, 2 0").bounds();
    assert_eq!((arch.min, arch.max), (DVec2::ZERO, DVec2::new(2.0, 0.5)));
    // y = 3t(1 − t)(1 − 2t): the extrema are ±√3/6 at ½ ∓ √3/6.
    let wave = bezier("0 0, 1 1, 2 -1, 3 0").bounds();
    near(wave.max.y, 3.0_f64.sqrt() / 6.0, 1e-15);
    near(wave.min.y, -3.0_f64.sqrt() / 6.0, 1e-15);
    // 16t²(1 − t)² of degree 4 has one extremum inside, of height 1.
    let hill = bezier("0 0, 1 0, 2 2.6666666666666665, 3 0, 4 0").bounds();
    near(hill.max.y, 1.0, 1e-15);
    assert_eq!(hill.min.y, 0.0);
}

/// Twice the signed area of three points divided by the square of their size; 0 within rounding.
fn turn(a: DVec2, b: DVec2, c: DVec2, size: f64) -> f64 {
    let area = ((b - a) / size).perp_dot((c - a) / size);
    if area.abs() < 16.0 * f64::EPSILON {
        0.0
    } else {
        area
    }
}

#[test]
fn the_hull_is_convex_and_contains_the_curve() {
    adversarial_points(&ALL, |points| {
        let curve: Curve<DVec2> = curve(points);
        let (hull, control) = (curve.hull(), curve.control_points());
        let size = largest(control).max(f64::MIN_POSITIVE);
        assert!(hull.iter().all(|corner| control.contains(corner)));
        let leftmost = control.iter().all(|p| (hull[0].x, hull[0].y) <= (p.x, p.y));
        assert!(leftmost, "{hull:?}");
        let samples = curve.sample(40).expect("samples");
        let n = hull.len();
        for k in (0..n).filter(|_| n > 2) {
            let (a, b, c) = (hull[k], hull[(k + 1) % n], hull[(k + 2) % n]);
            let inside = |p: &DVec2| turn(a, b, *p, size) >= 0.0;
            let all = samples.iter().chain(control).chain([&c]).all(inside);
            assert!(all, "{hull:?} of {control:?}");
        }
    });
}

#[test]
fn known_hulls() {
    for (points, expected) in [
        ("1 1, 0 0, 0 1, 1 0", "0 0, 1 0, 1 1, 0 1"),
        // Points on an edge and inside are omitted.
        ("0.5 0, 0 0, 1 0, 0.5 0.5, 1 1, 0 1", "0 0, 1 0, 1 1, 0 1"),
        ("0 0, 2 2, 1 1", "0 0, 2 2"),
        ("3 4, 3 4, 3 4, 3 4, 3 4", "3 4"),
        (
            "0 0, 1e150 0, 0 1e150, 0.25e150 0.25e150",
            "0 0, 1e150 0, 0 1e150",
        ),
        (
            "0 0, 1e-300 0, 0 1e-300, 0.25e-300 0.25e-300",
            "0 0, 1e-300 0, 0 1e-300",
        ),
    ] {
        assert_eq!(bezier(points).hull(), xy(expected), "{points}");
    }
}

#[test]
fn boxes_have_a_center_and_extents() {
    let bounds = bezier("1 2, 5 2, 5 10").control_bounds();
    assert_eq!((bounds.width(), bounds.height()), (4.0, 8.0));
    assert_eq!(xy("3 6"), [bounds.center()]);
    assert_eq!(bounds.diagonal(), 80.0_f64.sqrt());
}
