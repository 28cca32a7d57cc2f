//! Rational curves: closed forms on conics, invariance, and slow methods as references.

mod forms;
mod golden;
mod intersect;
mod kernels;
mod mesh;
mod network;
mod nurbs;
mod parameters;
mod solid;
mod surface;

use crate::support::Rng;
use casteljau::glam::{DAffine2, DMat3, DVec2, DVec3};
use casteljau::{Curve, Error, RationalCurve};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// An arc of the unit circle of 2α radians, starting at (1, 0).
fn unit_arc(alpha: f64) -> RationalCurve<DVec2> {
    let at = |angle: f64| DVec2::new(angle.cos(), angle.sin());
    let corner = at(alpha) / alpha.cos();
    RationalCurve::conic(DVec2::X, corner, at(2.0 * alpha), alpha.cos()).expect("valid")
}

fn quarter() -> RationalCurve<DVec2> {
    let points = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
    RationalCurve::new(&points, &[1.0, 0.5_f64.sqrt(), 1.0]).expect("valid")
}

/// A random number in a range.
fn within(rng: &mut Rng, from: f64, to: f64) -> f64 {
    from + (to - from) * rng.unit()
}

/// A random curve with coordinates in [−1, 1] and weights from 2^−k to 2^k.
fn random_curve(rng: &mut Rng, degree: usize, k: f64) -> RationalCurve<DVec2> {
    let points: Vec<DVec2> = (0..=degree)
        .map(|_| DVec2::new(within(rng, -1.0, 1.0), within(rng, -1.0, 1.0)))
        .collect();
    let weights: Vec<f64> = (0..=degree).map(|_| within(rng, -k, k).exp2()).collect();
    RationalCurve::new(&points, &weights).expect("valid")
}

#[test]
fn points_are_on_the_circle() {
    for steps in [0.2, 0.5, 1.0] {
        let arc = unit_arc(steps * FRAC_PI_4);
        for i in 0..=1000 {
            let p = arc.eval(f64::from(i) / 1000.0);
            let off = (p.x * p.x + p.y * p.y).sqrt() - 1.0;
            assert!(off.abs() <= 4.0 * f64::EPSILON, "{i}: {off:e}");
        }
    }
}

#[test]
fn curvature_of_the_circle() {
    let arc = quarter();
    for i in 0..=100 {
        let t = f64::from(i) / 100.0;
        assert!(
            (arc.curvature(t) - 1.0).abs() < 1e-13,
            "{t}: {}",
            arc.curvature(t)
        );
        // The tangent is perpendicular to the radius.
        assert!(arc.tangent(t).dot(arc.eval(t)).abs() < 1e-15);
        assert!((arc.normal(t) + arc.eval(t)).length() < 1e-14);
    }
}

#[test]
fn derivatives_are_limits_of_differences() {
    let mut rng = Rng(1);
    for _ in 0..100 {
        let degree = 1 + rng.below(5);
        let curve = random_curve(&mut rng, degree, 3.0);
        let t = within(&mut rng, 0.1, 0.9);
        for k in 1..4 {
            let h = 1e-5;
            let at = |t| curve.derivative_at(t, k - 1).expect("an order");
            let difference = (at(t + h) - at(t - h)) / (2.0 * h);
            let derivative = curve.derivative_at(t, k).expect("an order");
            let size = 1.0 + curve.derivative_at(t, k + 2).expect("an order").length();
            assert!((difference - derivative).length() < 1e-8 * size, "{k}");
        }
    }
}

#[test]
fn lengths_and_areas_of_arcs() {
    for k in 1..20 {
        let alpha = f64::from(k) * 0.07;
        let arc = unit_arc(alpha);
        let off = arc.length() - 2.0 * alpha;
        assert!(off.abs() < 1e-12 * alpha, "length of {alpha}: {off:e}");
        let off = arc.area() - alpha;
        assert!(off.abs() < 1e-13, "area of {alpha}: {off:e}");
    }
    assert!((quarter().time_at_length(FRAC_PI_4) - 0.5).abs() < 1e-12);
}

#[test]
fn equal_weights_are_the_polynomial() {
    let mut rng = Rng(2);
    for degree in 1..8 {
        let points: Vec<DVec2> = (0..=degree)
            .map(|_| DVec2::new(within(&mut rng, -1.0, 1.0), within(&mut rng, -1.0, 1.0)))
            .collect();
        let curve = Curve::new(&points).expect("valid");
        let rational = RationalCurve::new(&points, &vec![3.0; points.len()]).expect("valid");
        for i in 0..=20 {
            let t = f64::from(i) / 20.0;
            assert!((rational.eval(t) - curve.eval(t)).length() < 1e-15);
            let (a, b) = (rational.curvature(t), curve.curvature(t));
            assert!((a - b).abs() <= 1e-9 * a.abs().max(1.0), "{a} {b}");
        }
        let p = DVec2::new(0.3, -0.2);
        let near = [rational.nearest(p), curve.nearest(p)].map(|near| near.expect("finite"));
        assert!((near[0].distance - near[1].distance).abs() < 1e-14);
        assert!((rational.length() - curve.length()).abs() < 1e-12);
        assert!((rational.area() - curve.area()).abs() < 1e-13);
        let bounds = [rational.bounds(), curve.bounds()];
        assert!((bounds[0].min - bounds[1].min).length() < 1e-13);
        assert!((bounds[0].max - bounds[1].max).length() < 1e-13);
        let inflections = [rational.inflections(), curve.inflections()];
        assert_eq!(inflections[0].len(), inflections[1].len());
        for (a, b) in inflections[0].iter().zip(&inflections[1]) {
            assert!((a - b).abs() < 1e-9);
        }
        let spline = rational.to_spline(1e-3).expect("a tolerance");
        assert_eq!(spline.control_points(), points);
    }
}

#[test]
fn splitting_and_elevation_keep_the_curve() {
    let mut rng = Rng(3);
    for _ in 0..200 {
        let degree = 1 + rng.below(6);
        let curve = random_curve(&mut rng, degree, 5.0);
        let t = within(&mut rng, 0.0, 1.0);
        let (left, right) = curve.split(t).expect("inside");
        let raised = curve.elevate().expect("below 64");
        let standard = curve.reparametrize().expect("moderate");
        assert_eq!((left.start(), right.end()), (curve.start(), curve.end()));
        assert_eq!(left.end(), right.start());
        for i in 0..=10 {
            let s = f64::from(i) / 10.0;
            assert!((left.eval(s) - curve.eval(s * t)).length() < 1e-14);
            assert!((right.eval(s) - curve.eval(t + s * (1.0 - t))).length() < 1e-14);
            assert!((raised.eval(s) - curve.eval(s)).length() < 1e-14);
            let near = standard.nearest(curve.eval(s)).expect("finite");
            assert!(near.distance < 1e-14);
        }
        if degree == 2 {
            let invariant = |c: &RationalCurve<DVec2>| {
                let w = c.weights();
                w[0] * w[2] / (w[1] * w[1])
            };
            let (a, b) = (invariant(&curve), invariant(&standard));
            assert!((a / b - 1.0).abs() < 1e-15, "{a} {b}");
        }
    }
}

#[test]
fn projections_move_every_point() {
    let matrix = DMat3::from_cols_array(&[1.0, 0.2, 0.1, -0.3, 1.1, 0.2, 0.4, 0.5, 1.5]);
    let mut rng = Rng(4);
    for _ in 0..50 {
        let curve = random_curve(&mut rng, 3, 2.0);
        let image = curve.project(&matrix).expect("in front of the horizon");
        for i in 0..=10 {
            let t = f64::from(i) / 10.0;
            let q = matrix * curve.eval(t).extend(1.0);
            assert!((image.eval(t) - q.truncate() / q.z).length() < 1e-14);
        }
    }
    // The line x = −1 is sent to infinity.
    let matrix = DMat3::from_cols(DVec3::new(1.0, 0.0, 1.0), DVec3::Y, DVec3::Z);
    let points = [(-2.0, 0.0), (0.0, 1.0), (2.0, 0.0)].map(DVec2::from);
    let arc = RationalCurve::new(&points, &[1.0, 2.0, 1.0]).expect("valid");
    assert!(matches!(
        arc.project(&matrix),
        Err(Error::Item { index: 1, .. })
    ));
    let moved = arc
        .transform(&DAffine2::from_translation(DVec2::ONE))
        .expect("finite");
    assert_eq!(moved.weights(), arc.weights());
}

/// The largest distance of samples of a curve from a polyline.
fn farthest(curve: &RationalCurve<DVec2>, line: &[DVec2]) -> f64 {
    let distance = |p: DVec2| {
        let segments = line.windows(2).map(|ab| {
            let chord = ab[1] - ab[0];
            let t = ((p - ab[0]).dot(chord) / chord.length_squared()).clamp(0.0, 1.0);
            let t = if t.is_nan() { 0.0 } else { t };
            (ab[0] + chord * t - p).length()
        });
        segments.fold(f64::INFINITY, f64::min)
    };
    let samples = (0..=2000).map(|i| curve.eval(f64::from(i) / 2000.0));
    samples.map(distance).fold(0.0, f64::max)
}

#[test]
fn flattening_and_cubics_keep_the_tolerance() {
    let mut rng = Rng(5);
    for round in 0..60 {
        let degree = 1 + rng.below(5);
        let curve = random_curve(&mut rng, degree, 10.0);
        let tolerance = 10.0_f64.powf(within(&mut rng, -4.0, -1.0));
        let line = curve.flatten(tolerance).expect("a tolerance");
        let off = farthest(&curve, &line.points);
        assert!(off <= tolerance, "{round}: {off} of {tolerance}");
        let spline = curve.to_spline(tolerance).expect("a tolerance");
        for i in 0..=200 {
            let p = curve.eval(f64::from(i) / 200.0);
            let near = spline.nearest(p).expect("finite");
            assert!(near.distance <= tolerance);
        }
    }
}

#[test]
fn extrema_bounds_and_nearest_points_are_those_of_dense_samples() {
    let mut rng = Rng(6);
    for _ in 0..200 {
        let degree = 1 + rng.below(6);
        let curve = random_curve(&mut rng, degree, 6.0);
        let samples = curve.sample(4000).expect("a count");
        let bounds = curve.bounds();
        let p = DVec2::new(within(&mut rng, -1.5, 1.5), within(&mut rng, -1.5, 1.5));
        let nearest = curve.nearest(p).expect("finite");
        let mut closest = f64::INFINITY;
        let (mut min, mut max) = (samples[0], samples[0]);
        for &q in &samples {
            (min, max) = (min.min(q), max.max(q));
            closest = closest.min((q - p).length());
        }
        assert!(bounds.min.x <= min.x + 1e-15 && bounds.max.x >= max.x - 1e-15);
        assert!(bounds.min.y <= min.y + 1e-15 && bounds.max.y >= max.y - 1e-15);
        assert!((bounds.min - min).length() < 1e-3 && (bounds.max - max).length() < 1e-3);
        assert!(nearest.distance <= closest + 1e-14, "{nearest:?} {closest}");
        assert!(closest - nearest.distance < 1e-2);
    }
}

#[test]
fn inflections_are_changes_of_the_sign_of_curvature() {
    let mut rng = Rng(7);
    let mut found = 0;
    for _ in 0..200 {
        let degree = 3 + rng.below(3);
        let curve = random_curve(&mut rng, degree, 3.0);
        for t in curve.inflections() {
            found += 1;
            let (before, after) = (curve.curvature(t - 1e-6), curve.curvature(t + 1e-6));
            assert!(before * after < 0.0, "{t}: {before} {after}");
        }
    }
    assert!(found > 50);
}

#[test]
fn invalid_arguments_are_named() {
    let points = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)].map(DVec2::from);
    let message = |weights: &[f64]| {
        let error = RationalCurve::new(&points, weights).expect_err("invalid");
        error.to_string()
    };
    assert_eq!(
        message(&[1.0, 1.0]),
        "weights: expected a weight for each point, got 2"
    );
    let above = "a number above 0, from 2^-500 to 2^500";
    assert_eq!(
        message(&[1.0, 0.0, 1.0]),
        format!("weights[1]: expected {above}, got 0")
    );
    assert_eq!(
        message(&[1.0, 1.0, -2.0]),
        format!("weights[2]: expected {above}, got -2")
    );
    assert_eq!(
        message(&[f64::NAN, 1.0, 1.0]),
        "weights[0]: expected a finite number, got NaN"
    );
    let arc = RationalCurve::new(&points, &[1.0, 0.1, 1.0]).expect("valid");
    // The denominator (1 − t)² + 0.2 t (1 − t) + t² has no zero; that of the weights 1, 4, 1 has.
    assert!(arc.eval(-3.0).x.is_finite());
    let hyperbola = RationalCurve::new(&points, &[1.0, 4.0, 1.0]).expect("valid");
    assert!(hyperbola.eval(-3.0).x.is_nan());
    assert!(hyperbola.split(-3.0).is_err());
    assert!((quarter().length() - FRAC_PI_2).abs() < 1e-14);
}
