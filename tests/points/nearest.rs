//! Nearest points, compared with sampling and refinement, on difficult curves and query points.

use crate::points::{cases, extent, hostile, steps};
use crate::support::adversarial::{self, ORDINARY};
use crate::support::{Rng, Space, curve, largest, plane, real, ulp};
use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Error, Point, Spline};

/// The minimum distance by samples and golden-section search around the best of them; never below the true minimum.
fn sampled<P: Point>(curve: &Curve<P>, q: P, samples: usize) -> f64 {
    let distance = |t: f64| (curve.eval(t) - q).length();
    let all: Vec<f64> = steps(samples).map(distance).collect();
    let mut min = all.iter().copied().fold(f64::INFINITY, f64::min);
    for i in 0..=samples {
        let valley = all[i] <= all[i.saturating_sub(1)] && all[i] <= all[(i + 1).min(samples)];
        if valley {
            let (lo, hi) = (i.saturating_sub(1), (i + 1).min(samples));
            min = min.min(golden(
                real(lo) / real(samples),
                real(hi) / real(samples),
                distance,
            ));
        }
    }
    min
}

fn golden(mut lo: f64, mut hi: f64, f: impl Fn(f64) -> f64) -> f64 {
    let share = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (hi - share * (hi - lo), lo + share * (hi - lo));
    let (mut fa, mut fb) = (f(a), f(b));
    for _ in 0..60 {
        if fa < fb {
            (hi, b, fb) = (b, a, fa);
            a = hi - share * (hi - lo);
            fa = f(a);
        } else {
            (lo, a, fa) = (a, b, fb);
            b = lo + share * (hi - lo);
            fb = f(b);
        }
    }
    fa.min(fb)
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
        6 => points
            .iter()
            .fold(DVec3::ZERO, |sum, &p| sum + p / real(points.len())),
        7 => {
            let (bend, normal) = (on.curvature(t), on.normal(t));
            let radius = (1.0 / bend).min(1e3 * size);
            on.eval(t)
                + if radius.is_finite() {
                    normal * radius
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
    assert!((found.distance - (found.point - location).length()).abs() <= slack);
    let min = sampled(&on, location, samples);
    assert!(
        found.distance <= min + slack,
        "{found:?}, but {min} is nearer ({:e}): {points:?} from {q:?}",
        found.distance - min
    );
}

#[test]
fn nothing_sampled_is_nearer() {
    let mut rng = Rng(90);
    for case in 0..cases() {
        let dimension = 2 + case % 2;
        let points = hostile(&mut rng, &ORDINARY, dimension);
        let q = query(&mut rng, &points, dimension);
        let samples = if points.len() > 5 { 60 } else { 120 };
        if dimension == 2 {
            check::<DVec2>(&points, q, samples);
        } else {
            check::<DVec3>(&points, q, samples);
        }
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
        let found = curve::<DVec2>(&points)
            .nearest(q.truncate())
            .expect("finite");
        let (sin, cos) = rng.signed().sin_cos();
        for scale in [1.0, 1e9, 1e-9, 1e140, 1e-290] {
            let turn = |p: DVec3| DVec2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y) * scale;
            let turned: Vec<DVec2> = points.iter().rev().map(|&p| turn(p)).collect();
            let again = Curve::new(&turned)
                .expect("finite")
                .nearest(turn(q))
                .expect("finite");
            let slack = 16.0
                * (2.0 + real(points.len()))
                * ulp(largest(&points).max(q.abs().max_element()));
            assert!(
                (again.distance / scale - found.distance).abs() <= slack + 1e-300,
                "{points:?} from {q}, {scale}"
            );
        }
    }
}

#[test]
fn of_equally_near_points_the_first() {
    let arch = plane(&[(-1.0, 0.0), (-1.0, 2.0), (1.0, 2.0), (1.0, 0.0)]);
    let middle = arch.nearest(DVec2::ZERO).expect("finite");
    assert_eq!(
        (middle.t, middle.point, middle.distance),
        (0.0, DVec2::new(-1.0, 0.0), 1.0)
    );
    // Two minima inside: the parabola y = x² from above.
    let parabola = plane(&[(-2.0, 4.0), (0.0, -4.0), (2.0, 4.0)]);
    let found = parabola.nearest(DVec2::new(0.0, 2.0)).expect("finite");
    assert!((found.point.x + 1.5_f64.sqrt()).abs() < 1e-15, "{found:?}");
    // At the centre of curvature of the vertex three minima coincide.
    let found = parabola.nearest(DVec2::new(0.0, 0.5)).expect("finite");
    assert!((found.distance - 0.5).abs() < 1e-15, "{found:?}");
    let closed = plane(&[(0.0, 0.0), (3.0, 1.0), (-1.0, 2.0), (0.0, 0.0)]);
    assert_eq!(closed.nearest(DVec2::ZERO).expect("finite").t, 0.0);
    let point = plane(&[(1.0, 1.0); 4]);
    let found = point.nearest(DVec2::new(4.0, 5.0)).expect("finite");
    assert_eq!((found.t, found.distance), (0.0, 5.0));
}

#[test]
fn a_query_on_the_curve_is_found() {
    let mut rng = Rng(93);
    for _ in 0..2000 {
        let points = hostile(&mut rng, &[adversarial::Kind::Random], 3);
        let (on, t): (Curve<DVec3>, f64) = (curve(&points), rng.unit());
        let found = on.nearest(on.eval(t)).expect("finite");
        assert!(
            found.distance < 1e-15 * real(points.len()),
            "{found:?} {points:?}"
        );
    }
}

#[test]
fn a_query_that_is_not_finite_is_refused() {
    let line = plane(&[(0.0, 0.0), (1.0, 0.0)]);
    for bad in [f64::NAN, f64::INFINITY] {
        let refused = line.nearest(DVec2::new(0.0, bad));
        assert!(
            matches!(refused, Err(Error::NotFinite { what: "p", .. })),
            "{refused:?}"
        );
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
        let segments = chain.segments().collect::<Vec<_>>();
        let of_all = segments
            .iter()
            .map(|s| s.nearest(q).expect("finite").distance);
        assert_eq!(found.distance, of_all.fold(f64::INFINITY, f64::min));
        assert!((found.point - chain.eval(found.t)).length() < 1e-13);
    }
}
