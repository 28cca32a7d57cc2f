//! The work of distance queries, in counted steps, where rounding makes termination hardest.

use crate::support::{bezier, spline, xyz};
use casteljau::glam::{DVec2, DVec3};
use casteljau::take_steps;
use casteljau::{Curve, Spline};

/// An arc about the origin with elevated degree: all its points have the same distance, except for rounding.
fn arc(radius: f64, angle: f64, degree: usize) -> Curve<DVec2> {
    let handle = 4.0 / 3.0 * (angle / 4.0).tan();
    let end = DVec2::from_angle(angle);
    let handles = (DVec2::new(1.0, handle), end - end.perp() * handle);
    let points = [DVec2::X, handles.0, handles.1, end].map(|p| p * radius);
    let mut curve = Curve::new(&points).expect("finite");
    while curve.degree() < degree {
        curve = curve.elevate().expect("a degree below the limit");
    }
    curve
}

fn steps_of<T>(call: impl FnOnce() -> T) -> (T, usize) {
    take_steps();
    let answer = call();
    (answer, take_steps())
}

/// At degree 12 this once took seconds, at degree 24 it did not terminate.
#[test]
fn nearest_on_an_arc_about_the_point() {
    for angle in [1e-1, 1e-2, 1e-3, 1e-4] {
        let limits = [
            (3, 256),
            (4, 128),
            (6, 160),
            (12, 256),
            (24, 448),
            (64, 1088),
        ];
        for (degree, limit) in limits {
            for radius in [1.0, 1e6] {
                let arc = arc(radius, angle, degree);
                let (nearest, steps) = steps_of(|| arc.nearest(DVec2::ZERO).expect("finite"));
                assert!((nearest.distance / radius - 1.0).abs() < 1e-9);
                // Each halving that was started before the limit is finished; the root finding in the remaining pieces
                // counts its own steps.
                assert!(steps <= 16 * (limit + 64), "{angle} {degree}: {steps}");
            }
        }
    }
}

#[test]
fn curves_at_a_constant_distance() {
    for angle in [1e-1, 1e-2, 1e-3] {
        for degree in [3, 6, 24] {
            let (a, b) = (arc(1.0, angle, degree), arc(1.5, angle, degree));
            let (found, steps) = steps_of(|| a.distance_to(&b));
            assert!((found.distance - 0.5).abs() < 1e-9);
            assert!(steps <= 2 * 16_384, "{angle} {degree}: {steps}");
            let (far, steps) = steps_of(|| a.hausdorff(&b));
            assert!((far - 0.5).abs() < 1e-9);
            assert!(steps <= 4 * 6_500, "{angle} {degree}: {steps}");
        }
    }
}

/// The direction of this curve is rounding noise on long stretches.
#[test]
fn frames_where_directions_are_rounding() {
    let points = "3e14 1e-9 2, 1e-12 -4e3 1, -2e15 7e-4 0, 5 1e15 -3e-7, 3e14 1e-9 2";
    let curve: Curve<DVec3> = crate::support::curve(&xyz(points));
    for count in [1, 16, 400] {
        let (frames, steps) = steps_of(|| curve.frames(count).expect("few"));
        assert_eq!(frames.len(), count + 1);
        assert!(steps <= 4097 + 64 * (count + 1), "{count}: {steps}");
    }
}

/// A fine tolerance once produced a million vertices.
#[test]
fn simplify_at_a_fine_tolerance() {
    let cubic = bezier("-2 -2, 0 0.5, -3 -2, 3 -3");
    let plain = spline("-2 -2, 0 0.5, -3 -2, 3 -3", 3, false);
    assert_eq!(plain.simplify(1e-12), Ok(plain));
    let higher = cubic.elevate().expect("degree 4");
    let higher = Spline::from_curves(&[higher], false).expect("a curve");
    let (cubics, steps) = steps_of(|| higher.simplify(1e-12).expect("cubics"));
    assert!(steps <= 4096, "{steps}");
    for k in 0..=100 {
        let point = higher.eval(f64::from(k) / 100.0);
        assert!(cubics.nearest(point).expect("finite").distance <= 1e-12);
    }
}
