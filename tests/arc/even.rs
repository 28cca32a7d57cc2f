//! Parameters at given arc lengths, and equidistant parameters, measured with an independent integral.

use crate::arc::length::hostile;
use crate::support::adversarial::{ALL, Kind, ORDINARY};
use crate::support::{Rng, cases, curve, integral, plane, real};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Error, Point, Spline};

fn time<P: Point>(curve: &Curve<P>, s: f64) -> f64 {
    curve.time_at_length(s, None).expect("a finite length")
}

#[test]
fn closed_forms() {
    let line = plane(&[(0., 0.), (3., 4.)]);
    assert_eq!(
        line.equidistant_times(4).expect("steps"),
        [0.0, 0.25, 0.5, 0.75, 1.0]
    );
    assert_eq!(time(&line, 2.5), 0.5);
    // The curve runs forth and back: s = 2t(1 − t) up to the middle.
    let back = plane(&[(0., 0.), (1., 0.), (0., 0.)]);
    for t in [0.1_f64, 0.25, 0.5, 0.7, 0.99] {
        let s = if t <= 0.5 {
            2.0 * t * (1.0 - t)
        } else {
            1.0 - 2.0 * t * (1.0 - t)
        };
        assert!((time(&back, s) - t).abs() < 3e-8, "{t}");
        let slow = (1.0 - 2.0 * t).abs().max(1e-8);
        assert!((time(&back, s) - t).abs() * slow < 1e-14, "{t}");
    }
    // (t², t³) from 0: 27 s = (4 + 9t²)^1.5 − 8.
    let cusp = plane(&[(0., 0.), (0., 0.), (1. / 3., 0.), (1., 1.)]);
    for t in [1e-3, 0.1, 0.5, 0.9] {
        let s = ((4.0_f64 + 9.0 * t * t).powf(1.5) - 8.0) / 27.0;
        assert!((time(&cusp, s) - t).abs() < 1e-12, "{t}");
    }
}

#[test]
fn the_ends() {
    let mut rng = Rng(1687);
    for kind in ALL {
        for degree in [1, 2, 3, 4, 7, 64] {
            let points =
                crate::support::adversarial::points(&mut rng, kind, degree, 2 + degree % 2);
            let curve: Curve<DVec3> = curve(&points);
            let whole = curve.length(None).expect("a length");
            assert_eq!(time(&curve, 0.0), 0.0);
            assert_eq!(time(&curve, -1.0), 0.0);
            if whole > 0.0 {
                assert_eq!(time(&curve, whole), 1.0, "{kind:?} {points:?}");
                assert_eq!(time(&curve, f64::MAX), 1.0);
            }
            for n in [1, 2, 3, 10] {
                let ts = curve.equidistant_times(n).expect("steps");
                assert_eq!((ts.len(), ts[0], ts[n]), (n + 1, 0.0, 1.0));
                assert!(ts.windows(2).all(|t| t[0] <= t[1]), "{ts:?} of {points:?}");
            }
        }
    }
    let point = plane(&[(2., 3.); 4]);
    assert_eq!((time(&point, 1.0), time(&point, 0.0)), (0.0, 0.0));
    assert_eq!(
        point.equidistant_times(4).expect("steps"),
        [0.0, 0.25, 0.5, 0.75, 1.0]
    );
}

#[test]
fn refusals() {
    let curve = plane(&[(0., 0.), (1., 1.), (2., 0.)]);
    for s in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(
            curve.time_at_length(s, None),
            Err(Error::Range { what: "s", .. })
        ));
    }
    assert!(matches!(
        curve.time_at_length(1.0, Some(0.0)),
        Err(Error::Range {
            what: "tolerance",
            ..
        })
    ));
    assert!(matches!(
        curve.time_at_length(1.0, Some(1e-17)),
        Err(Error::Tolerance { .. })
    ));
    assert!(matches!(
        curve.length(Some(f64::NAN)),
        Err(Error::Range { .. })
    ));
    assert!(matches!(
        curve.equidistant_times(0),
        Err(Error::Range { .. })
    ));
    assert!(matches!(
        curve.equidistant_times(usize::MAX),
        Err(Error::TooMany { .. })
    ));
}

#[test]
fn the_length_up_to_t_is_s() {
    let mut rng = Rng(1690);
    for _ in 0..cases(4_000, 200_000) {
        let points = hostile(&mut rng, &ORDINARY);
        let curve: Curve<DVec3> = curve(&points);
        let whole = curve.length(None).expect("a length");
        let s = whole * rng.pick(&[1e-6, 0.1, 0.5, 0.9, 1.0 - 1e-9]);
        let got = integral::length(&points, 0.0, time(&curve, s));
        assert!(
            (got - s).abs() <= 2e-12 * whole,
            "{got} instead of {s} of {whole}: {points:?}"
        );
        let tolerance = whole * rng.magnitude(-9.0, -1.0);
        if let Ok(t) = curve.time_at_length(s, Some(tolerance)) {
            let got = integral::length(&points, 0.0, t);
            assert!(
                (got - s).abs() <= tolerance,
                "{got} instead of {s} to {tolerance}: {points:?}"
            );
        }
    }
}

#[test]
fn steps_are_even() {
    let mut rng = Rng(1696);
    for _ in 0..cases(1_000, 50_000) {
        let points = hostile(&mut rng, &ORDINARY);
        let curve: Curve<DVec3> = curve(&points);
        let whole = curve.length(None).expect("a length");
        let n = rng.pick(&[1, 2, 3, 7, 16]);
        let ts = curve.equidistant_times(n).expect("steps");
        for pair in ts.windows(2) {
            let off = (integral::length(&points, pair[0], pair[1]) - whole / real(n)).abs();
            assert!(off <= 2e-12 * whole, "{off:e} of {whole}: {points:?}");
        }
    }
}

#[test]
fn splines_go_on_over_joints() {
    let mut rng = Rng(1701);
    for round in 0..cases(100, 5_000) {
        let degrees: Vec<usize> = (0..1 + rng.below(6)).map(|_| 1 + rng.below(5)).collect();
        let closed = round % 3 == 0;
        let count = degrees.iter().sum::<usize>() + usize::from(!closed);
        let mut points: Vec<DVec3> = (0..count).map(|_| rng.point(3)).collect();
        if round % 4 == 0 && count > degrees[0] {
            // A segment of length 0.
            points[..=degrees[0]].fill(DVec3::ONE);
        }
        let spline = Spline::with_degrees(points, &degrees, closed).expect("a spline");
        let pieces: Vec<Vec<DVec3>> = spline
            .segments()
            .collect::<Vec<_>>()
            .iter()
            .map(|c| c.control_points().to_vec())
            .collect();
        let up_to = |t: f64| -> f64 {
            let whole = |k: usize| integral::length(&pieces[k], 0.0, (t - real(k)).clamp(0.0, 1.0));
            (0..pieces.len()).map(whole).sum()
        };
        let whole = up_to(real(pieces.len()));
        let got = spline.length(None).expect("a length");
        assert!((got - whole).abs() <= 1e-12 * whole);
        assert!((spline.length(Some(1e-6)).expect("a length") - whole).abs() <= 1e-6);
        let n = 1 + rng.below(20);
        let ts = spline.equidistant_times(n).expect("steps");
        assert_eq!((ts[0], ts[n]), (0.0, real(pieces.len())));
        for (i, &t) in ts.iter().enumerate() {
            let s = whole * real(i) / real(n);
            assert!((up_to(t) - s).abs() <= 2e-12 * whole, "{t}");
            let same = spline.time_at_length(s, None).expect("a t");
            assert!((up_to(same) - s).abs() <= 2e-12 * whole, "{same}");
        }
        let end = if got > 0.0 { real(pieces.len()) } else { 0.0 };
        assert_eq!(spline.time_at_length(got, None), Ok(end));
        assert_eq!(spline.time_at_length(-1.0, None), Ok(0.0));
        // The arc length up to a joint gives the parameter of the joint.
        let first = spline.segments().collect::<Vec<_>>()[0]
            .length(None)
            .expect("a length");
        let joint = spline.time_at_length(first, None).expect("a t");
        assert!(pieces.len() == 1 || first == 0.0 || joint == 1.0);
    }
    let point = Spline::new(&[DVec2::ONE; 7], 3, false).expect("a spline");
    assert_eq!(
        point.equidistant_times(4).expect("steps"),
        [0.0, 0.5, 1.0, 1.5, 2.0]
    );
    assert_eq!(point.length(None), Ok(0.0));
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
        let length = unit.length(None).expect("a length");
        for power in [-900, -30, 30, 490] {
            let size = 2_f64.powi(power);
            let scaled: Vec<DVec3> = points.iter().map(|&p| p * size).collect();
            let scaled: Curve<DVec3> = curve(&scaled);
            let got = scaled.length(None).expect("a length") / size;
            assert!(
                (got - length).abs() <= 1e-15 * length,
                "{got} instead of {length}: {points:?}"
            );
            for (a, b) in scaled
                .equidistant_times(5)
                .expect("steps")
                .iter()
                .zip(unit.equidistant_times(5).expect("steps"))
            {
                let off = integral::length(&points, a.min(b), a.max(b));
                assert!(off <= 1e-12 * length, "{points:?}");
            }
        }
        let forth = unit.equidistant_times(8).expect("steps");
        let back = unit.reverse().equidistant_times(8).expect("steps");
        for (a, b) in forth.iter().zip(back.iter().rev()) {
            let off = integral::length(&points, a.min(1.0 - b), a.max(1.0 - b));
            assert!(off <= 2e-12 * length, "{a} and {b}: {points:?}");
        }
    }
}

/// The curve turns back next to its start, where the derivative is almost zero.
#[test]
fn a_hook_at_the_start_counts() {
    let points = [
        (0.0, 0.0),
        (-9.958911800110698e-9, 1.0),
        (-2378.321009626822, -954636660740.4569),
        (-2.8042010993724994e-7, 1000000000000000.0),
    ];
    let curve = Curve::new(&points.map(DVec2::from)).expect("a curve");
    let whole = curve.length(None).expect("a length");
    let ts = curve.equidistant_times(10).expect("steps");
    let half = curve.split(ts[5]).0.length(None).expect("a length");
    assert!(
        (half - 0.5 * whole).abs() <= 1e-12 * whole,
        "{half:e} of {whole:e}"
    );
}
