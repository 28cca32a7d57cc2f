//! Parameters at given arc lengths, and equidistant parameters, measured with an independent integral.

use crate::arc::length::{hostile, length};
use crate::support::adversarial::{self, ALL, Kind, ORDINARY};
use crate::support::{Rng, bezier, cases, curve, integral, near_at, random_points, real, refused};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Point, Spline};

fn time<P: Point>(curve: &Curve<P>, s: f64) -> f64 {
    curve.time_at_length(s)
}

fn times<P: Point>(curve: &Curve<P>, segments: usize) -> Vec<f64> {
    curve.equidistant_times(segments).expect("steps")
}

#[test]
fn closed_forms() {
    let line = bezier("0 0, 3 4");
    assert_eq!(times(&line, 4), [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(time(&line, 2.5), 0.5);
    // The curve runs forth and back: s = 2t(1 − t) up to the middle.
    let back = bezier("0 0, 1 0, 0 0");
    for t in [0.1_f64, 0.25, 0.5, 0.7, 0.99] {
        let ahead = 2.0 * t * (1.0 - t);
        let got = time(&back, if t <= 0.5 { ahead } else { 1.0 - ahead });
        near_at(got, t, 3e-8, t);
        let slow = (1.0 - 2.0 * t).abs().max(1e-8);
        near_at(got * slow, t * slow, 1e-14, t);
    }
    // (t², t³) from 0: 27 s = (4 + 9t²)^1.5 − 8.
    let cusp = bezier("0 0, 0 0, 0.3333333333333333 0, 1 1");
    for t in [1e-3, 0.1, 0.5, 0.9] {
        let s = ((4.0_f64 + 9.0 * t * t).powf(1.5) - 8.0) / 27.0;
        near_at(time(&cusp, s), t, 1e-12, t);
    }
    let point = bezier("2 3, 2 3, 2 3, 2 3");
    assert_eq!((time(&point, 1.0), time(&point, 0.0)), (0.0, 0.0));
    assert_eq!(times(&point, 4), [0.0, 0.25, 0.5, 0.75, 1.0]);
}

#[test]
fn the_ends() {
    let mut rng = Rng(1687);
    for (kind, degree) in ALL
        .into_iter()
        .flat_map(|k| [1, 2, 3, 4, 7, 64].map(|n| (k, n)))
    {
        let points = adversarial::points(&mut rng, kind, degree, 2 + degree % 2);
        let curve: Curve<DVec3> = curve(&points);
        let whole = length(&curve);
        assert_eq!((time(&curve, 0.0), time(&curve, -1.0)), (0.0, 0.0));
        if whole > 0.0 {
            let ends = (time(&curve, whole), time(&curve, f64::MAX));
            assert_eq!(ends, (1.0, 1.0), "{kind:?} {points:?}");
        }
        for n in [1, 2, 3, 10] {
            let ts = times(&curve, n);
            assert_eq!((ts.len(), ts[0], ts[n]), (n + 1, 0.0, 1.0));
            assert!(ts.is_sorted(), "{ts:?} of {points:?}");
        }
    }
}

#[test]
fn refusals() {
    let curve = bezier("0 0, 1 1, 2 0");
    assert!(curve.time_at_length(f64::NAN).is_nan());
    assert_eq!(curve.time_at_length(f64::INFINITY), 1.0);
    assert_eq!(curve.time_at_length(f64::NEG_INFINITY), 0.0);
    refused(curve.time_at_length_within(1.0, 0.0), "Range tolerance");
    refused(curve.time_at_length_within(1.0, 1e-17), "Tolerance");
    refused(curve.length_within(f64::NAN), "Range tolerance");
    refused(curve.equidistant_times(0), "Range segments");
    refused(
        curve.equidistant_times(usize::MAX),
        "TooMany segments 134217727",
    );
}

#[test]
fn the_length_up_to_t_is_s() {
    let mut rng = Rng(1690);
    for _ in 0..cases(4_000, 30_000) {
        let points = hostile(&mut rng, &ORDINARY);
        let curve: Curve<DVec3> = curve(&points);
        let whole = length(&curve);
        let s = whole * rng.pick(&[1e-6, 0.1, 0.5, 0.9, 1.0 - 1e-9]);
        let got = integral::length(&points, 0.0, time(&curve, s));
        near_at(got, s, 2e-12 * whole, &points);
        let tolerance = whole * rng.magnitude(-9.0, -1.0);
        if let Ok(t) = curve.time_at_length_within(s, tolerance) {
            near_at(integral::length(&points, 0.0, t), s, tolerance, &points);
        }
    }
}

#[test]
fn steps_are_even() {
    let mut rng = Rng(1696);
    for _ in 0..cases(1_000, 25_000) {
        let points = hostile(&mut rng, &ORDINARY);
        let curve: Curve<DVec3> = curve(&points);
        let whole = length(&curve);
        let n = rng.pick(&[1, 2, 3, 7, 16]);
        for pair in times(&curve, n).windows(2) {
            let step = integral::length(&points, pair[0], pair[1]);
            near_at(step, whole / real(n), 2e-12 * whole, &points);
        }
    }
}

#[test]
fn splines_go_on_over_joints() {
    let mut rng = Rng(1701);
    for round in 0..cases(100, 2_500) {
        let degrees: Vec<usize> = (0..1 + rng.below(6)).map(|_| 1 + rng.below(5)).collect();
        let closed = round % 3 == 0;
        let count = degrees.iter().sum::<usize>() + usize::from(!closed);
        let mut points: Vec<DVec3> = random_points(&mut rng, count);
        if round % 4 == 0 && count > degrees[0] {
            // A segment of length 0.
            points[..=degrees[0]].fill(DVec3::ONE);
        }
        let spline = Spline::with_degrees(points, &degrees, closed).expect("a spline");
        let pieces: Vec<_> = spline.segments().collect();
        let up_to = |t: f64| -> f64 {
            let share = |k: usize| (t - real(k)).clamp(0.0, 1.0);
            let piece = |k: usize| integral::length(pieces[k].control_points(), 0.0, share(k));
            (0..pieces.len()).map(piece).sum()
        };
        let end = real(pieces.len());
        let whole = up_to(end);
        let got = spline.length();
        near_at(got, whole, 1e-12 * whole, round);
        near_at(
            spline.length_within(1e-6).expect("a length"),
            whole,
            1e-6,
            round,
        );
        let n = 1 + rng.below(20);
        let ts = spline.equidistant_times(n).expect("steps");
        assert_eq!((ts[0], ts[n]), (0.0, end));
        for (i, &t) in ts.iter().enumerate() {
            let s = whole * real(i) / real(n);
            near_at(up_to(t), s, 2e-12 * whole, (round, t));
            let same = spline.time_at_length(s);
            near_at(up_to(same), s, 2e-12 * whole, (round, same));
        }
        let end = if got > 0.0 { end } else { 0.0 };
        assert_eq!(spline.time_at_length(got), end);
        assert_eq!(spline.time_at_length(-1.0), 0.0);
        // The arc length up to a joint gives the parameter of the joint.
        let first = length(&pieces[0]);
        let joint = spline.time_at_length(first);
        assert!(pieces.len() == 1 || first == 0.0 || joint == 1.0);
    }
    let point = Spline::new(&[DVec2::ONE; 7], 3, false).expect("a spline");
    let ts = point.equidistant_times(4).expect("steps");
    assert_eq!(ts, [0.0, 0.5, 1.0, 1.5, 2.0]);
    assert_eq!(point.length(), 0.0);
}

#[test]
fn the_same_at_any_size() {
    let mut rng = Rng(1704);
    for _ in 0..200 {
        let points = hostile(
            &mut rng,
            &[Kind::Random, Kind::Cusp, Kind::Collinear, Kind::Loop],
        );
        let unit: Curve<DVec3> = curve(&points);
        let whole = length(&unit);
        let apart = |a: f64, b: f64| integral::length(&points, a.min(b), a.max(b));
        for size in [-900, -30, 30, 490].map(|power| 2_f64.powi(power)) {
            let scaled: Vec<DVec3> = points.iter().map(|&p| p * size).collect();
            let scaled: Curve<DVec3> = curve(&scaled);
            near_at(length(&scaled) / size, whole, 1e-15 * whole, &points);
            for (a, b) in times(&scaled, 5).into_iter().zip(times(&unit, 5)) {
                near_at(apart(a, b), 0.0, 1e-12 * whole, &points);
            }
        }
        let back = times(&unit.reverse(), 8);
        for (a, b) in times(&unit, 8).into_iter().zip(back.into_iter().rev()) {
            near_at(apart(a, 1.0 - b), 0.0, 2e-12 * whole, &points);
        }
    }
}
