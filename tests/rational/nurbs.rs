//! NURBS curves: closed forms, operations that keep the curve, and de Boor's recursion as a reference.

use super::within;
use crate::support::Rng;
use casteljau::curve::IntersectionKind;
use casteljau::glam::{DMat3, DVec2, DVec3};
use casteljau::{Curve, Error, NurbsCurve, Spline};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The value of a B-spline by its recursion, as a definition.
fn b_spline(i: usize, p: usize, knots: &[f64], t: f64) -> f64 {
    if p == 0 {
        return f64::from(u8::from(knots[i] <= t && t < knots[i + 1]));
    }
    let share = |a: f64, b: f64, value: f64| if b > a { value / (b - a) } else { 0.0 };
    share(
        knots[i],
        knots[i + p],
        (t - knots[i]) * b_spline(i, p - 1, knots, t),
    ) + share(
        knots[i + 1],
        knots[i + p + 1],
        (knots[i + p + 1] - t) * b_spline(i + 1, p - 1, knots, t),
    )
}

/// A random curve, clamped or not, with some equal knots.
fn random_curve(rng: &mut Rng, clamped: bool, closed: bool) -> NurbsCurve<DVec2> {
    let p = 1 + rng.below(4);
    let count = if closed {
        1 + rng.below(9)
    } else {
        p + 1 + rng.below(7)
    };
    let points: Vec<DVec2> = (0..count)
        .map(|_| DVec2::new(rng.signed(), rng.signed()))
        .collect();
    let weights: Vec<f64> = (0..count).map(|_| within(rng, -2.0, 2.0).exp2()).collect();
    loop {
        let needed = if closed { count + 1 } else { count + p + 1 };
        let mut knots = vec![within(rng, -2.0, 2.0)];
        while knots.len() < needed {
            let step = if rng.chance(0.25) {
                0.0
            } else {
                within(rng, 0.1, 1.0)
            };
            knots.push(knots[knots.len() - 1] + step);
        }
        if clamped && !closed {
            for i in 0..p {
                knots[i] = knots[p];
                knots[needed - 1 - i] = knots[needed - 1 - p];
            }
        }
        if let Ok(curve) = NurbsCurve::new(p, &points, Some(&weights), &knots, closed) {
            return curve;
        }
    }
}

/// Asserts that two curves have the same domain and the same points.
fn assert_same(a: &NurbsCurve<DVec2>, b: &NurbsCurve<DVec2>, tolerance: f64, what: &str) {
    assert_eq!(a.domain(), b.domain(), "{what}");
    let [from, to] = a.domain();
    for i in 0..=60 {
        let t = from + (to - from) * f64::from(i) / 60.0;
        let off = (a.eval(t) - b.eval(t)).length();
        assert!(off <= tolerance, "{what}: {off:e} at {t}\n{a:?}\n{b:?}");
    }
}

#[test]
fn points_are_those_of_the_definition() {
    let mut rng = Rng(11);
    for round in 0..300 {
        let curve = random_curve(&mut rng, round % 2 == 0, false);
        let [from, to] = curve.domain();
        for i in 0..20 {
            let t = from + (to - from) * f64::from(i) / 20.0;
            let (mut sum, mut weight) = (DVec2::ZERO, 0.0);
            for (k, (&p, w)) in curve
                .control_points()
                .iter()
                .zip(curve.weights())
                .enumerate()
            {
                let share = w * b_spline(k, curve.degree(), curve.knots(), t);
                (sum, weight) = (sum + p * share, weight + share);
            }
            assert!((curve.eval(t) - sum / weight).length() < 1e-13, "{round}");
        }
    }
}

#[test]
fn a_closed_curve_is_the_open_one_with_repeated_points() {
    let mut rng = Rng(12);
    for _ in 0..200 {
        let curve = random_curve(&mut rng, false, true);
        assert_eq!(curve.start(), curve.end());
        let (n, p) = (curve.control_points().len(), curve.degree());
        let period = curve.knots()[n] - curve.knots()[0];
        // Knot −k of the period is knot n − k, one period before.
        let knot = |i: usize| {
            let from_far = i + 8 * n - p;
            curve.knots()[from_far % n] + period * ((from_far / n) as f64 - 8.0)
        };
        let knots: Vec<f64> = (0..n + 2 * p + 1).map(knot).collect();
        let repeat = |i: usize| (curve.control_points()[i % n], curve.weights()[i % n]);
        let (points, weights): (Vec<DVec2>, Vec<f64>) = (0..n + p).map(repeat).unzip();
        let Ok(open) = NurbsCurve::new(p, &points, Some(&weights), &knots, false) else {
            continue; // rounding of a period separated two equal knots
        };
        for (a, b) in curve.segments().iter().zip(open.segments()) {
            assert!(a.approx_eq(b, 1e-11), "{a:?}\n{b:?}");
        }
    }
}

#[test]
fn knots_degrees_and_parts_keep_the_curve() {
    let mut rng = Rng(13);
    for round in 0..400 {
        let curve = random_curve(&mut rng, round % 3 == 0, round % 3 == 1);
        let [from, to] = curve.domain();
        let ts: Vec<f64> = (0..3).map(|_| within(&mut rng, from, to)).collect();
        let refined = curve.refine(&ts).expect("inside");
        assert_eq!(
            refined.control_points().len(),
            curve.control_points().len() + 3
        );
        assert_same(&curve, &refined, 1e-12, "refine");
        let raised = curve.elevate().expect("below 64");
        assert_eq!(raised.degree(), curve.degree() + 1);
        assert_same(&curve, &raised, 1e-11, "elevate");
        let reversed = curve.reverse();
        let t = within(&mut rng, from, to);
        let mirrored = reversed.eval(from + (to - t));
        assert!((curve.eval(t) - mirrored).length() < 1e-12, "{round}");
        let (left, right) = curve.split(t).expect("inside");
        let part = curve.subsegment(ts[0]..ts[1]).expect("different");
        for i in 0..=20 {
            let s = f64::from(i) / 20.0;
            let (a, b) = (from + (t - from) * s, t + (to - t) * s);
            assert!(
                (left.eval(a) - curve.eval(a)).length() < 1e-12,
                "left {round}"
            );
            assert!(
                (right.eval(b) - curve.eval(b)).length() < 1e-12,
                "right {round}"
            );
            let c = ts[0] + (ts[1] - ts[0]) * s;
            let d = if ts[0] < ts[1] {
                c
            } else {
                ts[1] + (ts[0] - c)
            };
            assert!(
                (part.eval(d) - curve.eval(c)).length() < 1e-12,
                "part {round}"
            );
        }
        if curve.knots().contains(&t) || curve.degree() == 1 {
            continue;
        }
        let (back, error) = curve
            .insert_knot(t, 1)
            .and_then(|c| c.remove_knot(t, None))
            .expect("a knot");
        assert!(error < 1e-9, "{round}: {error:e}");
        assert!(back.approx_eq(&curve, 1e-8), "{round}");
    }
}

#[test]
fn the_bound_of_a_removed_knot_holds() {
    let mut rng = Rng(14);
    let (mut found, mut refused) = (0, 0);
    for round in 0..400 {
        let curve = random_curve(&mut rng, round % 2 == 0, round % 3 == 1);
        let [from, to] = curve.domain();
        let inner: Vec<f64> = curve
            .joints()
            .iter()
            .copied()
            .filter(|&t| t > from && t < to)
            .collect();
        if inner.is_empty() {
            continue;
        }
        let t = rng.pick(&inner);
        // With a tolerance, the knot stays where the bound is above it or there is no bound.
        let kept = |tolerance| curve.remove_knot(t, Some(tolerance)).expect("a knot");
        let Ok((removed, error)) = curve.remove_knot(t, None) else {
            assert_eq!(kept(1e9), (curve.clone(), f64::INFINITY));
            refused += 1;
            continue;
        };
        if error > 1e-12 {
            assert_eq!(kept(error), (removed.clone(), error));
            assert_eq!(kept(0.5 * error), (curve.clone(), error));
        }
        found += 1;
        assert_eq!(
            removed.control_points().len() + 1,
            curve.control_points().len()
        );
        assert_same(&curve, &removed, error * (1.0 + 1e-9) + 1e-12, "remove");
    }
    assert!(found > 100 && refused > 0, "{found} {refused}");
    let curve = random_curve(&mut rng, false, false);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = curve.remove_knot(curve.domain()[0], Some(bad));
        assert!(matches!(
            error,
            Err(Error::Range {
                what: "tolerance",
                ..
            })
        ));
    }
}

#[test]
fn circles_and_ellipses() {
    let circle = NurbsCurve::circle(DVec2::ZERO, 1.0).expect("finite");
    let w = 0.5_f64.sqrt();
    assert_eq!(circle.weights(), [1.0, w, 1.0, w, 1.0, w, 1.0, w, 1.0]);
    assert_eq!(
        circle.knots(),
        [
            0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0
        ]
    );
    let corners = [
        (1, 0),
        (1, 1),
        (0, 1),
        (-1, 1),
        (-1, 0),
        (-1, -1),
        (0, -1),
        (1, -1),
        (1, 0),
    ];
    let corners = corners.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
    assert_eq!(circle.control_points(), corners);
    assert_eq!(circle.reverse().control_points()[1], corners[7]);
    for p in circle.sample(997).expect("a count") {
        assert!((p.length() - 1.0).abs() <= 4.0 * f64::EPSILON);
    }
    assert!((circle.length() - TAU).abs() < 1e-12);
    assert!((circle.area() - PI).abs() < 1e-13);
    let bounds = circle.bounds();
    assert_eq!((bounds.min, bounds.max), (DVec2::NEG_ONE, DVec2::ONE));
    assert!((circle.time_at_length(FRAC_PI_2) - 0.25).abs() < 1e-12);
    let spline = circle.to_spline(1e-4).expect("a tolerance");
    assert!(spline.is_closed());
    assert_eq!(spline.segment_count(), 8);
    for (a, b) in [(2.0_f64, 1.0_f64), (10.0, 1.0), (100.0, 1.0)] {
        // The perimeter by the arithmetic-geometric mean: 2π (a² − Σ 2ⁿ⁻¹ cₙ²) / agm(a, b).
        let (mut x, mut y, mut sum, mut power) = (a, b, a * a, 0.5);
        sum -= power * (a * a - b * b);
        while x - y > 1e-15 * x {
            let c = 0.5 * (x - y);
            (x, y) = (0.5 * (x + y), (x * y).sqrt());
            power *= 2.0;
            sum -= power * c * c;
        }
        let perimeter = TAU * sum / x;
        let ellipse = NurbsCurve::ellipse(DVec2::ONE, DVec2::new(a, b), 0.7).expect("finite");
        let off = ellipse.length() / perimeter - 1.0;
        assert!(off.abs() < 1e-12, "{a}: {off:e}");
        assert!((ellipse.area() - PI * a * b).abs() < 1e-12 * a);
    }
    let arc = NurbsCurve::arc(DVec3::ZERO, DVec3::Y, DVec3::Z, 1.0, -2.0).expect("finite");
    assert!((arc.length() - 3.0).abs() < 1e-13);
    assert!((arc.end() - DVec3::new(0.0, (-2.0_f64).cos(), (-2.0_f64).sin())).length() < 1e-15);
    let nearest = circle.nearest(DVec2::new(-3.0, -4.0)).expect("finite");
    assert!((nearest.distance - 4.0).abs() < 1e-14);
}

#[test]
fn interpolation_passes_through_the_points() {
    let mut rng = Rng(15);
    for _ in 0..50 {
        let degree = 1 + rng.below(5);
        let points: Vec<DVec2> = (0..degree + 1 + rng.below(40))
            .map(|_| DVec2::new(rng.signed(), rng.signed()))
            .collect();
        let curve = NurbsCurve::interpolate(&points, degree).expect("enough points");
        for &p in &points {
            let near = curve.nearest(p).expect("finite");
            assert!(near.distance < 1e-12, "{}", near.distance);
        }
    }
    let line = [DVec2::ZERO; 3];
    assert!(matches!(
        NurbsCurve::interpolate(&line, 2),
        Err(Error::Count { got: 1, .. })
    ));
}

#[test]
fn splines_convert() {
    let points = [(0, 0), (0, 2), (2, 2), (2, 0), (2, -2), (4, -2), (4, 0)];
    let points = points.map(|(x, y)| DVec2::new(x.into(), y.into()));
    let spline = Spline::new(&points, 3, false).expect("valid");
    let curve = NurbsCurve::from(&spline);
    assert_eq!(curve.domain(), [0.0, 2.0]);
    for i in 0..=20 {
        let t = f64::from(i) / 10.0;
        assert!((curve.eval(t) - spline.eval(t)).length() < 1e-15);
    }
    assert_eq!(curve.to_spline(1e-6).expect("a tolerance"), spline);
    let again = NurbsCurve::new(3, curve.control_points(), None, curve.knots(), false);
    assert_eq!(again, Ok(curve));
    let line = Curve::line(DVec2::ZERO, DVec2::ONE);
    assert_eq!(NurbsCurve::from(&line).knots(), [0.0, 0.0, 1.0, 1.0]);
}

#[test]
fn maps_move_every_point() {
    let matrix = DMat3::from_cols_array(&[1.0, 0.2, 0.1, -0.3, 1.1, 0.2, 0.4, 0.5, 1.5]);
    let circle = NurbsCurve::circle(DVec2::ZERO, 0.5).expect("finite");
    let image = circle.project(&matrix).expect("in front of the horizon");
    for i in 0..=40 {
        let t = f64::from(i) / 40.0;
        let q = matrix * circle.eval(t).extend(1.0);
        assert!((image.eval(t) - q.truncate() / q.z).length() < 1e-14);
    }
}

#[test]
fn invalid_arguments_are_named() {
    let points = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)].map(DVec2::from);
    let message = |weights: Option<&[f64]>, knots: &[f64]| {
        let error = NurbsCurve::new(2, &points, weights, knots, false).expect_err("invalid");
        error.to_string()
    };
    let knots = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    assert_eq!(
        message(None, &knots[1..5]),
        "knots: expected points + degree + 1 knots (rhino3dm leaves out the first and the last one), got 4"
    );
    assert_eq!(
        message(None, &knots[1..]),
        "knots: expected points + degree + 1 knots (closed: points + 1), got 5"
    );
    assert_eq!(
        message(None, &[0.0, 0.0, 1.0, 0.5, 1.0, 1.0]),
        "knots[3]: expected a knot not below the one before it, got 0.5"
    );
    assert_eq!(
        message(Some(&[1.0, -1.0, 1.0]), &knots),
        "weights[1]: expected a number above 0, from 2^-500 to 2^500, got -1"
    );
}

#[test]
fn circles_meet_lines_circles_and_themselves() {
    let circle = NurbsCurve::circle(DVec2::ZERO, 1.0).expect("finite");
    let other = NurbsCurve::circle(DVec2::new(1.0, 0.0), 1.0).expect("finite");
    let found = circle.intersections(&other);
    assert_eq!(found.len(), 2);
    for at in &found {
        assert!(
            (at.point.x - 0.5).abs() < 1e-14 && (at.point.y.abs() - 0.75_f64.sqrt()).abs() < 1e-14
        );
        assert!((circle.eval(at.t) - at.point).length() < 1e-14);
        assert!((other.eval(at.u) - at.point).length() < 1e-14);
    }
    // A line through a joint of the circle meets it there once.
    let line = NurbsCurve::from(&Curve::line(DVec2::new(-2.0, 0.0), DVec2::new(2.0, 0.0)));
    let found = circle.intersections(&line);
    assert_eq!(
        found.len(),
        2,
        "the start and the end of the circle are one: {found:?}"
    );
    let touching = NurbsCurve::circle(DVec2::new(0.0, 2.0), 1.0).expect("finite");
    let found = circle.intersections(&touching);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!((found[0].point - DVec2::Y).length() < 1e-7);
    // Three quarters of the circle overlap it.
    let part = circle.subsegment(0.1..0.85).expect("inside");
    let found = circle.intersections(&part);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(
        matches!(found[0].kind, IntersectionKind::Overlap { t_end, .. } if (t_end - 0.85).abs() < 1e-9)
    );
    let ends = circle.self_intersections();
    assert_eq!((ends.len(), ends[0].t, ends[0].u), (1, 0.0, 1.0));
}
