//! Bounding boxes and convex hulls: they contain the curve and are as small as possible.

use crate::curve::{adversarial_points, steps};
use crate::support::adversarial::{ALL, Kind};
use crate::support::exact;
use crate::support::{Rng, curve, largest, plane, real, to_3d, ulp};
use casteljau::Curve;
use casteljau::glam::{DVec2, DVec3};
use wasm_bindgen_test::wasm_bindgen_test;

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
    let before = |i: usize| real(i.max(1) - 1) / real(SAMPLES);
    let after = |i: usize| real((i + 1).min(SAMPLES)) / real(SAMPLES);
    let peaks = (0..=SAMPLES)
        .filter(near)
        .map(|i| peak(at, before(i), after(i)));
    peaks.fold(max, f64::max)
}

fn peak(f: impl Fn(f64) -> f64, mut lo: f64, mut hi: f64) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    while hi - lo > 1e-9 {
        let (x1, x2) = (hi - ratio * (hi - lo), lo + ratio * (hi - lo));
        if f(x1) > f(x2) {
            hi = x2;
        } else {
            lo = x1;
        }
    }
    f(lo).max(f(hi))
}

#[wasm_bindgen_test(unsupported = test)]
fn the_box_contains_the_curve_and_is_touched() {
    adversarial_points(&ALL, |points| {
        if points.len() > 14 {
            return;
        }
        let bounds = curve::<DVec3>(points).bounds();
        let rounding = steps(points) * ulp(largest(points));
        for axis in 0..3 {
            let (high, low) = (greatest(points, axis, 1.0), -greatest(points, axis, -1.0));
            assert!(
                (bounds.max[axis] - high).abs() <= rounding,
                "{points:?}: {} is not {high}",
                bounds.max[axis]
            );
            assert!(
                (bounds.min[axis] - low).abs() <= rounding,
                "{points:?}: {} is not {low}",
                bounds.min[axis]
            );
        }
        let plane: Curve<DVec2> = curve(points);
        assert_eq!(
            (plane.bounds().min, plane.bounds().max),
            (bounds.min.truncate(), bounds.max.truncate())
        );
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn boxes_by_closed_forms() {
    // y = 2t(1 − t) has its maximum at ½.
    let arch = plane(&[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)]).bounds();
    assert_eq!((arch.min, arch.max), (DVec2::ZERO, DVec2::new(2.0, 0.5)));
    // y = 3t(1 − t)(1 − 2t): the extrema are ±√3/6 at ½ ∓ √3/6.
    let wave = plane(&[(0.0, 0.0), (1.0, 1.0), (2.0, -1.0), (3.0, 0.0)]).bounds();
    let height = 3.0_f64.sqrt() / 6.0;
    assert!((wave.max.y - height).abs() < 1e-15 && (wave.min.y + height).abs() < 1e-15);
    // 16t²(1 − t)² of degree 4 has one extremum inside, of height 1.
    let hill = plane(&[
        (0.0, 0.0),
        (1.0, 0.0),
        (2.0, 16.0 / 6.0),
        (3.0, 0.0),
        (4.0, 0.0),
    ])
    .bounds();
    assert!((hill.max.y - 1.0).abs() < 1e-15 && hill.min.y == 0.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_control_box_contains_the_box() {
    adversarial_points(&ALL, |points| {
        let curve = curve::<DVec3>(points);
        let (exact, control) = (curve.bounds(), curve.control_bounds());
        let corner =
            |pick: fn(DVec3, DVec3) -> DVec3| points.iter().copied().reduce(pick).expect("points");
        assert_eq!(
            (control.min, control.max),
            (corner(DVec3::min), corner(DVec3::max))
        );
        let rounding = DVec3::splat(steps(points) * ulp(largest(points)));
        assert!(
            exact.min.cmpge(control.min - rounding).all()
                && exact.max.cmple(control.max + rounding).all()
        );
        assert!(exact.min.cmple(exact.max).all());
    });
    assert_eq!(
        plane(&[(-3e149, 0.0), (0.0, 4e149)]).bounds().diagonal(),
        5e149
    );
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

#[wasm_bindgen_test(unsupported = test)]
fn the_hull_is_convex_and_contains_the_curve() {
    adversarial_points(&ALL, |points| {
        let curve: Curve<DVec2> = curve(points);
        let (hull, control) = (curve.hull(), curve.control_points());
        let size = largest(control).max(f64::MIN_POSITIVE);
        assert!(hull.iter().all(|corner| control.contains(corner)));
        let leftmost = control.iter().all(|p| (hull[0].x, hull[0].y) <= (p.x, p.y));
        assert!(leftmost, "{hull:?}");
        let samples = curve.sample(40).expect("samples");
        let corners = hull.len();
        for k in 0..corners {
            let (a, b, c) = (hull[k], hull[(k + 1) % corners], hull[(k + 2) % corners]);
            assert!(corners < 3 || turn(a, b, c, size) >= 0.0, "{hull:?}");
            let inside = |p: &DVec2| corners < 2 || turn(a, b, *p, size) >= 0.0;
            assert!(
                corners < 3 || samples.iter().chain(control).all(inside),
                "{hull:?} of {control:?}"
            );
        }
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn known_hulls() {
    let corners = |points: &[(f64, f64)]| plane(points).hull();
    let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    assert_eq!(
        corners(&[(1.0, 1.0), (0.0, 0.0), (0.0, 1.0), (1.0, 0.0)]),
        square
    );
    // Points on an edge and inside are omitted.
    assert_eq!(
        corners(&[
            (0.5, 0.0),
            (0.0, 0.0),
            (1.0, 0.0),
            (0.5, 0.5),
            (1.0, 1.0),
            (0.0, 1.0)
        ]),
        square
    );
    assert_eq!(
        corners(&[(0.0, 0.0), (2.0, 2.0), (1.0, 1.0)]),
        [DVec2::ZERO, DVec2::splat(2.0)]
    );
    assert_eq!(corners(&[(3.0, 4.0); 5]), [DVec2::new(3.0, 4.0)]);
    for scale in [1e150, 1e-300] {
        let triangle = corners(&[
            (0.0, 0.0),
            (scale, 0.0),
            (0.0, scale),
            (0.25 * scale, 0.25 * scale),
        ]);
        assert_eq!(
            triangle,
            [DVec2::ZERO, DVec2::new(scale, 0.0), DVec2::new(0.0, scale)]
        );
    }
}

/// Loops and cusps lie inside the hull of their control points, also in space.
#[wasm_bindgen_test(unsupported = test)]
fn curves_stay_among_their_control_points() {
    let mut rng = Rng(11);
    adversarial_points(&[Kind::Loop, Kind::Cusp, Kind::Mixed], |points| {
        let curve = curve::<DVec3>(points);
        let direction = rng.point(3);
        let along = |p: &DVec3| p.dot(direction);
        let max = points.iter().map(along).fold(f64::MIN, f64::max);
        let samples = to_3d(&curve.sample(50).expect("samples"));
        let rounding = 4.0 * steps(points) * ulp(largest(points));
        assert!(samples.iter().all(|p| along(p) <= max + rounding));
    });
}
