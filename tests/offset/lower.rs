//! Degree reduction, and curves through points.

use crate::support::de_casteljau as at;
use crate::support::{Rng, largest, near_at, random_points, real, ulp};
use casteljau::Curve;
use casteljau::glam::DVec2;
use std::f64::consts::PI;

fn random(rng: &mut Rng, degree: usize) -> Curve<DVec2> {
    Curve::new(&random_points(rng, degree + 1)).expect("finite")
}

#[test]
fn the_error_is_the_greatest_distance() {
    let mut rng = Rng(5);
    for degree in (1..=12).chain([20, 33, 64]) {
        for _ in 0..40 {
            let curve = random(&mut rng, degree);
            let reduced = curve.reduce();
            assert_eq!(reduced.curve.degree(), degree.saturating_sub(1).max(1));
            let ends = (reduced.curve.start(), reduced.curve.end());
            assert_eq!(ends, (curve.start(), curve.end()));
            let steps = 4000;
            let apart = |k: usize| {
                let t = real(k) / real(steps);
                (at(curve.control_points(), t) - at(reduced.curve.control_points(), t)).length()
            };
            let max = (0..=steps).map(apart).fold(0.0, f64::max);
            let noise = 1e-13 * largest(reduced.curve.control_points());
            near_at(max, reduced.error, 1e-3 * reduced.error + noise, degree);
        }
    }
}

#[test]
fn elevated_curves_come_back() {
    let mut rng = Rng(6);
    for degree in (1..=12).chain([32, 63]) {
        let curve = random(&mut rng, degree);
        let back = curve.elevate().expect("below 64").reduce();
        assert!(back.error <= 1e-14);
        assert!(back.curve.approx_eq(&curve, 1e-12), "{back:?}, {curve:?}");
    }
}

#[test]
fn through_points() {
    let mut rng = Rng(7);
    for count in (2..=16).chain([33, 65]) {
        let points: Vec<DVec2> = random_points(&mut rng, count);
        let last = real(count - 1);
        let crowd = |i: usize| 0.5 - 0.5 * (PI * real(i) / last).cos();
        let crowded: Vec<f64> = (0..count).map(crowd).collect();
        for ts in [None, Some(&crowded[..])] {
            let curve = Curve::interpolate(&points, ts).expect("different");
            assert_eq!((curve.start(), curve.end()), (points[0], points[count - 1]));
            let chosen = ts.map_or_else(|| chords(&points), <[f64]>::to_vec);
            let size = largest(curve.control_points());
            if count > 16 {
                // The control points are larger than the points by many powers of ten.
                assert!(size.is_finite());
                continue;
            }
            for (&t, &p) in chosen.iter().zip(&points) {
                let got = at(curve.control_points(), t);
                near_at(got, p, real(count) * 8.0 * ulp(size), (count, size));
            }
        }
    }
}

fn chords(points: &[DVec2]) -> Vec<f64> {
    let lengths: Vec<f64> = points.windows(2).map(|p| (p[1] - p[0]).length()).collect();
    let total: f64 = lengths.iter().sum();
    let mut ts = vec![0.0];
    for length in lengths {
        ts.push(ts[ts.len() - 1] + length / total);
    }
    ts
}

#[test]
fn through_points_of_a_known_curve() {
    let mut rng = Rng(8);
    for degree in 1..=10 {
        let curve = random(&mut rng, degree);
        let ts: Vec<f64> = (0..=degree).map(|k| real(k) / real(degree)).collect();
        let points = curve.eval_at(&ts);
        let found = Curve::interpolate(&points, Some(&ts)).expect("different");
        assert!(found.approx_eq(&curve, 1e-11), "degree {degree}");
    }
}

#[test]
fn what_cannot_be_done_is_refused() {
    let points = [DVec2::ZERO, DVec2::X, DVec2::Y];
    assert!(Curve::interpolate(&points, Some(&[0.0, 0.5, 0.5])).is_err());
    assert!(Curve::interpolate(&points, Some(&[0.0, 0.5])).is_err());
    assert!(Curve::interpolate(&points[..1], None).is_err());
    assert!(Curve::interpolate(&[DVec2::ONE; 3], None).is_ok());
    assert!(Curve::interpolate(&[DVec2::NAN; 3], None).is_err());
}
