//! Nearest points, compared with sampling and refinement, on difficult curves and query points.

use crate::points::{cases, extent, hostile, steps};
use crate::support::adversarial::{self, ORDINARY};
use crate::support::{
    Rng, Space, bezier, curve, highest, largest, near_at, real, refused, ulp, xy,
};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Point, Spline};

/// The minimum distance by samples and golden-section search around the best of them; never below the true minimum.
fn sampled<P: Point>(curve: &Curve<P>, q: P, samples: usize) -> f64 {
    let distance = |t: f64| (curve.eval(t) - q).norm();
    let all: Vec<f64> = steps(samples).map(distance).collect();
    let mut min = all.iter().copied().fold(f64::INFINITY, f64::min);
    for i in 0..=samples {
        let (lo, hi) = (i.saturating_sub(1), (i + 1).min(samples));
        if all[i] <= all[lo] && all[i] <= all[hi] {
            let around = [lo, hi].map(|k| real(k) / real(samples));
            min = min.min(-highest(|t| -distance(t), around, 60));
        }
    }
    min
}

/// Query points near a curve, far from it, on it, at its ends, in its middle and on its evolute.
fn query(rng: &mut Rng, points: &[DVec3], dimension: usize) -> DVec3 {
    let on: Curve<DVec3> = curve(points);
    let (size, t) = (extent(points), rng.unit());
    let near = |rng: &mut Rng, reach: f64| rng.point(dimension) * (size * reach);
    match rng.below(9) {
        0 | 1 => points[0] + near(rng, 2.0),
        2 => on.eval(t),
        3 => {
            let reach = rng.magnitude(-15.0, -1.0);
            on.eval(t) + near(rng, reach)
        }
        4 => rng.pick(points),
        5 => (points[0] + points[points.len() - 1]) * 0.5,
        6 => points.iter().sum::<DVec3>() / real(points.len()),
        7 => {
            let radius = (1.0 / on.curvature(t)).min(1e3 * size);
            let finite = radius.is_finite();
            on.eval(t)
                + if finite {
                    on.normal(t) * radius
                } else {
                    DVec3::ZERO
                }
        }
        _ => {
            let reach = rng.magnitude(1.0, 7.0);
            points[0] + near(rng, reach)
        }
    }
}

fn check<P: Space>(points: &[DVec3], q: DVec3, samples: usize) {
    let (on, location): (Curve<P>, P) = (curve(points), P::of(q));
    let found = on.nearest(location).expect("finite");
    let size = largest(points).max(q.abs().max_element());
    let slack = 8.0 * (2.0 + real(points.len())) * ulp(size);
    assert!((0.0..=1.0).contains(&found.t), "{found:?}");
    assert_eq!(found.point, on.eval(found.t));
    let there = (found.point - location).norm();
    near_at(there, found.distance, slack, (points, q));
    let min = sampled(&on, location, samples);
    let none_nearer = found.distance <= min + slack;
    assert!(none_nearer, "{found:?}, but {min}: {points:?} from {q:?}");
}

#[test]
fn nothing_sampled_is_nearer() {
    let mut rng = Rng(90);
    for case in 0..cases() {
        let points = hostile(&mut rng, &ORDINARY, 2 + case % 2);
        let q = query(&mut rng, &points, 2 + case % 2);
        let samples = if points.len() > 5 { 60 } else { 120 };
        [check::<DVec2>, check::<DVec3>][case % 2](&points, q, samples);
    }
}

#[test]
fn high_degrees_and_every_size() {
    let mut rng = Rng(91);
    for &kind in &adversarial::ALL {
        for degree in [1, 2, 3, 4, 7, 20, 33, 64] {
            for dimension in [2, 3] {
                let points = adversarial::points(&mut rng, kind, degree, dimension);
                let max = DVec3::splat(casteljau::MAX_COORDINATE);
                let q = query(&mut rng, &points, dimension).clamp(-max, max);
                let found = curve::<DVec3>(&points).nearest(q).expect("finite");
                assert!(found.point.is_finite() && found.distance.is_finite());
                if largest(&points) > 1e-200 && largest(&points) < 1e140 {
                    check::<DVec3>(&points, q, 500);
                }
            }
        }
    }
}

#[test]
fn follows_when_turned_scaled_and_reversed() {
    let mut rng = Rng(92);
    for _ in 0..cases() / 10 {
        let points = hostile(&mut rng, &ORDINARY, 2);
        let q = query(&mut rng, &points, 2);
        let at = |p: DVec3| p.truncate();
        let found = curve::<DVec2>(&points).nearest(at(q)).expect("finite");
        let size = largest(&points).max(q.abs().max_element());
        let slack = 16.0 * (2.0 + real(points.len())) * ulp(size) + 1e-300;
        let turn = DVec2::from_angle(rng.signed());
        for scale in [1.0, 1e9, 1e-9, 1e130, 1e-290] {
            let image = |p: DVec3| turn.rotate(at(p)) * scale;
            let turned: Vec<DVec2> = points.iter().rev().map(|&p| image(p)).collect();
            let turned = Curve::new(&turned).expect("finite");
            let again = turned.nearest(image(q)).expect("finite").distance / scale;
            near_at(again, found.distance, slack, (&points, q, scale));
        }
    }
}

#[test]
fn of_equally_near_points_the_first() {
    for (points, q, t, x, distance) in [
        ("-1 0, -1 2, 1 2, 1 0", "0 0", Some(0.0), Some(-1.0), 1.0),
        // Two minima inside: the parabola y = x² from above.
        (
            "-2 4, 0 -4, 2 4",
            "0 2",
            None,
            Some(-(1.5_f64.sqrt())),
            1.75_f64.sqrt(),
        ),
        // At the centre of curvature of the vertex three minima coincide.
        ("-2 4, 0 -4, 2 4", "0 0.5", None, None, 0.5),
        ("0 0, 3 1, -1 2, 0 0", "0 0", Some(0.0), Some(0.0), 0.0),
        ("1 1, 1 1, 1 1, 1 1", "4 5", Some(0.0), Some(1.0), 5.0),
    ] {
        let found = bezier(points).nearest(xy(q)[0]).expect("finite");
        assert!(t.is_none_or(|t| found.t == t), "{found:?}");
        near_at(found.point.x, x.unwrap_or(found.point.x), 1e-15, points);
        near_at(found.distance, distance, 1e-15, points);
    }
}

#[test]
fn a_query_on_the_curve_is_found() {
    let mut rng = Rng(93);
    for _ in 0..2000 {
        let points = hostile(&mut rng, &[adversarial::Kind::Random], 3);
        let (on, t): (Curve<DVec3>, f64) = (curve(&points), rng.unit());
        let found = on.nearest(on.eval(t)).expect("finite");
        near_at(found.distance, 0.0, 1e-15 * real(points.len()), points);
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let line = bezier("0 0, 1 0");
        refused(line.nearest(DVec2::new(0.0, bad)), "NotFinite p 0");
    }
}

#[test]
fn on_a_spline_the_nearest_of_all_segments() {
    let mut rng = Rng(94);
    for case in 0..cases() / 20 {
        let dimension = 2 + case % 2;
        let (degree, closed) = (1 + rng.below(3), rng.chance(0.5));
        let count = degree * (1 + rng.below(9)) + usize::from(!closed);
        let points: Vec<DVec3> = (0..count).map(|_| rng.point(dimension)).collect();
        let chain = Spline::new(&points, degree, closed).expect("fits");
        let q = rng.point(dimension) * rng.pick(&[0.5, 1.5, 100.0]);
        let found = chain.nearest(q).expect("finite");
        let of_all = chain
            .segments()
            .map(|s| s.nearest(q).expect("finite").distance);
        assert_eq!(found.distance, of_all.fold(f64::INFINITY, f64::min));
        near_at(found.point, chain.eval(found.t), 1e-13, points);
    }
}
