//! Extrema, times at a coordinate, inflections and tangents: complete in comparison with samples, and without false
//! results.

use crate::points::{cases, hostile, steps};
use crate::support::adversarial::{Kind, ORDINARY};
use crate::support::{Rng, all_near, bezier, curve, largest, near, random_points, real, ulp};
use casteljau::Curve;
use casteljau::glam::{DVec2, DVec3};
use std::fmt::Debug;

/// The effect of rounding of the control points and of the evaluation on a coordinate.
fn slack(points: &[DVec3]) -> f64 {
    4.0 * (2.0 + real(points.len())) * ulp(largest(points))
}

/// Between successive extrema a coordinate is monotone, in alternating directions.
#[test]
fn coordinates_are_monotone_between_extrema() {
    let mut rng = Rng(100);
    for case in 0..cases() {
        let points = hostile(&mut rng, &ORDINARY, 2);
        let (on, axis): (Curve<DVec2>, usize) = (curve(&points), case % 2);
        let at = |t: f64| on.eval(t)[axis];
        let stops = with_ends(&on.extrema(axis).expect("an axis"));
        assert!(stops.windows(2).all(|pair| pair[0] < pair[1]));
        let slack = slack(&points);
        let mut last = 0.0_f64;
        for pair in stops.windows(2) {
            let direction = at(pair[1]) - at(pair[0]);
            let turns = direction * last < 0.0;
            let known = direction.abs() <= slack || last.abs() <= slack || turns;
            assert!(known, "{points:?}: no turn at {}", pair[0]);
            last = direction;
            let mut before = at(pair[0]);
            for s in steps(20) {
                let now = at(pair[0] + (pair[1] - pair[0]) * s);
                let goes_on = (now - before) * direction.signum() >= -slack;
                assert!(goes_on, "{points:?}: back at {s} of {pair:?}");
                before = now;
            }
        }
    }
}

#[test]
fn every_time_at_a_value_is_found_once() {
    let mut rng = Rng(101);
    for case in 0..cases() {
        let points = hostile(&mut rng, &ORDINARY, 2);
        let (on, axis): (Curve<DVec2>, usize) = (curve(&points), case % 2);
        let turns = on.extrema(axis).expect("an axis");
        let t = rng.unit();
        // At a random point, at an extremum, at an end.
        let wanted = match rng.below(4) {
            0 if !turns.is_empty() => rng.pick(&turns),
            1 => rng.pick(&[0.0, 1.0]),
            _ => t,
        };
        let value = on.eval(wanted)[axis];
        let found = on.times_at_coordinate(axis, value).expect("finite");
        let slack = slack(&points);
        let off = |t: f64| on.eval(t)[axis] - value;
        assert!(!found.is_empty(), "{points:?} at {wanted}");
        assert!(found.windows(2).all(|pair| pair[0] < pair[1]), "{found:?}");
        let right = |&t: &f64| (0.0..=1.0).contains(&t) && off(t).abs() <= slack;
        assert!(found.iter().all(right), "{points:?} {found:?}");
        assert_no_crossing(&with_ends(&found), off, slack, &points);
    }
}

fn with_ends(ts: &[f64]) -> Vec<f64> {
    [&[0.0], ts, &[1.0]].concat()
}

/// Asserts that a function keeps its sign between some parameters.
fn assert_no_crossing(ts: &[f64], f: impl Fn(f64) -> f64, slack: f64, what: impl Debug) {
    for pair in ts.windows(2) {
        let within = steps(20).map(|s| f(pair[0] + (pair[1] - pair[0]) * s));
        let (low, high) = within.fold((0.0_f64, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
        assert!(
            low >= -slack || high <= slack,
            "{what:?}: missed between {pair:?}"
        );
    }
}

/// The numerator of the curvature, and its rounding error.
fn bend(on: &Curve<DVec2>, t: f64) -> (f64, f64) {
    let (first, second) = (on.derivative_at(t, 1), on.derivative_at(t, 2));
    let n = real(on.degree());
    let rounding = 8.0 * n * n * n * n * ulp(largest(on.control_points()));
    let slopes = largest(on.derivative().control_points());
    (
        first.perp_dot(second),
        rounding * (n + 1.0) * (slopes + rounding),
    )
}

#[test]
fn the_bend_keeps_its_side_between_inflections() {
    let mut rng = Rng(102);
    for _ in 0..cases() {
        let points = hostile(&mut rng, &ORDINARY, 2);
        let on: Curve<DVec2> = curve(&points);
        for pair in with_ends(&on.inflections()).windows(2) {
            let within = steps(20).map(|s| bend(&on, pair[0] + (pair[1] - pair[0]) * s));
            let bends: Vec<(f64, f64)> = within.collect();
            let left = bends.iter().any(|&(bend, slack)| bend > slack);
            let right = bends.iter().any(|&(bend, slack)| bend < -slack);
            assert!(
                !(left && right),
                "{points:?}: an inflection between {pair:?}"
            );
        }
    }
}

#[test]
fn inflections_stay_under_affine_maps() {
    let mut rng = Rng(103);
    for _ in 0..cases() / 4 {
        let degree = 3 + rng.below(4);
        let points: Vec<DVec2> = random_points(&mut rng, degree + 1);
        let on = Curve::new(&points).expect("finite");
        let plain = on.inflections();
        // Only where the numerator of the curvature crosses zero steeply.
        let steep = |&t: &f64| bend(&on, t + 1e-4).0.abs().min(bend(&on, t - 1e-4).0.abs()) > 1e-4;
        if !plain.iter().all(steep) {
            continue;
        }
        let (a, b) = (rng.point(2).truncate(), rng.point(2).truncate());
        if a.perp_dot(b).abs() < 0.1 {
            continue;
        }
        let scale = rng.pick(&[1.0, 1e9, 1e-9, 1e140, 1e-250]);
        let image: Vec<DVec2> = points.iter().map(|p| (a * p.x + b * p.y) * scale).collect();
        let again = Curve::new(&image).expect("finite").inflections();
        all_near(&again, &plain, 1e-9);
    }
}

#[test]
fn tangents_pass_through_the_point() {
    let mut rng = Rng(104);
    for _ in 0..cases() {
        use Kind::{Closed, Integers, Loop, Random, ZeroHandles};
        let points = hostile(&mut rng, &[Random, Integers, Closed, ZeroHandles, Loop], 2);
        let (on, t): (Curve<DVec2>, f64) = (curve(&points), rng.unit());
        let reach = rng.pick(&[0.0, 0.5, -2.0]);
        let p = on.eval(t) + on.tangent(t) * reach;
        let found = on.tangents_from(p).expect("finite");
        assert!(found.windows(2).all(|pair| pair[0] < pair[1]), "{found:?}");
        let off = |t: f64| (p - on.eval(t)).perp_dot(on.derivative_at(t, 1));
        let size = largest(on.control_points()).max(p.abs().max_element());
        let slack = 1e-13 * real(points.len()).powi(3) * size * size;
        let right = |&t: &f64| (0.0..=1.0).contains(&t) && off(t).abs() <= slack;
        assert!(found.iter().all(right), "{points:?} {p} {found:?}");
        // At a cusp B′ changes its sign, so this product does too.
        let mut stops = on.cusps();
        stops.extend(found.iter().chain(&[0.0, 1.0]));
        stops.sort_by(f64::total_cmp);
        assert_no_crossing(&stops, off, slack, (&points, p));
        // Where the speed is almost zero, the direction is lost in rounding.
        let goes = on.derivative_at(t, 1).length() > 1e-3 * size;
        assert!(!goes || !found.is_empty(), "{points:?} from {p} at {t}");
    }
}

#[test]
fn known_answers() {
    // The curvature has a triple root at ½, after a simple one.
    let ts = bezier("1 1, 2 -2, -2 1, 1 -2, 1 1, 1 -2").inflections();
    assert_eq!(ts.len(), 2, "{ts:?}");
    near(ts[0], 0.434_258_545_910_66, 1e-12);
    near(ts[1], 0.5, 1e-4);
    let ts = bezier("0 0, 1 0.25, 0 1, 1 0").inflections();
    all_near(&ts, &[0.5, 0.8], 1e-15);
    // A double root that rounding splits: y = (t − 0.3)² touches 0 once.
    let touch = bezier("0 0.09, 0.5 -0.21, 1 0.49");
    all_near(
        &touch.times_at_coordinate(1, 0.0).expect("finite"),
        &[0.3],
        1e-8,
    );
    let flat = bezier("0 2, 5 2, 1 2");
    assert_eq!(flat.times_at_coordinate(1, 2.0), Ok(vec![0.0, 1.0]));
    assert_eq!(flat.times_at_coordinate(1, 2.1), Ok(vec![]));
    assert_eq!(flat.extrema(1), Ok(vec![]));
    assert!(flat.extrema(2).is_err() && flat.times_at_coordinate(2, 0.0).is_err());
    assert!(flat.times_at_coordinate(0, f64::NAN).is_err());
    let line = bezier("0 0, 1 1");
    assert_eq!(line.tangents_from(DVec2::splat(5.0)), Ok(vec![0.0, 1.0]));
    assert_eq!(line.tangents_from(DVec2::new(5.0, 6.0)), Ok(vec![]));
    assert!(line.tangents_from(DVec2::NAN).is_err());
}
