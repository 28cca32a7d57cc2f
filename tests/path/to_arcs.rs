//! Approximation by arcs: two-sided distances, tangents, numbers of arcs, and degenerate input.

use crate::support::paths::path;
use crate::support::{Rng, near};
use casteljau::glam::DVec2;
use casteljau::path::CircularArc;
use casteljau::{Curve, Path};
use std::f64::consts::PI;

fn point(arc: &CircularArc, u: f64) -> DVec2 {
    match arc.center {
        None => arc.start.lerp(arc.end, u),
        Some(center) => {
            let angle = arc.start_angle + u * (arc.end_angle - arc.start_angle);
            center + DVec2::from_angle(angle) * arc.radius
        }
    }
}

/// The distance of a point from an arc.
fn distance(p: DVec2, arc: &CircularArc) -> f64 {
    let ends = p.distance(arc.start).min(p.distance(arc.end));
    match arc.center {
        None => {
            let along = arc.end - arc.start;
            let u = (p - arc.start).dot(along) / along.length_squared();
            if (0.0..=1.0).contains(&u) {
                p.distance(point(arc, u))
            } else {
                ends
            }
        }
        Some(center) => {
            let turn = arc.end_angle - arc.start_angle;
            let from_start = ((p - center).to_angle() - arc.start_angle) * turn.signum();
            if from_start.rem_euclid(2.0 * PI) <= turn.abs() {
                (p.distance(center) - arc.radius).abs()
            } else {
                ends
            }
        }
    }
}

/// What the rounding of centre, radius and angles moves a point of an arc.
fn rounding(arc: &CircularArc) -> f64 {
    arc.center.map_or(0.0, |_| 1e-15 * arc.radius)
}

/// Checks the promises for one open curve; the result is the number of arcs.
fn checked(curve: &Curve<DVec2>, tolerance: f64) -> usize {
    let given = Path::from(curve.clone());
    let arcs = given.to_arcs(tolerance).expect("a tolerance").remove(0);
    assert_eq!(
        (arcs[0].start, arcs[arcs.len() - 1].end),
        (curve.start(), curve.end())
    );
    let allowed = tolerance * (1.0 + 1e-9) + 1e-13 * size(curve);
    for pair in arcs.windows(2) {
        assert!(
            pair[0].end.distance(pair[1].start) <= 1e-12 * size(curve),
            "{pair:?}"
        );
    }
    for arc in &arcs {
        for u in [0.0, 0.2, 0.5, 0.9, 1.0] {
            let p = point(arc, u);
            let found = curve.nearest(p).expect("finite").distance;
            assert!(
                found <= allowed + rounding(arc),
                "{arc:?} at {u} of {curve:?}: {found}"
            );
        }
        near(
            (point(arc, 0.0) - arc.start).length() + (point(arc, 1.0) - arc.end).length(),
            0.0,
            1e-12 * size(curve) + rounding(arc),
        );
        assert!((arc.end_angle - arc.start_angle).abs() <= PI * 1.001);
    }
    for k in 0..=400 {
        let p = curve.eval(f64::from(k) / 400.0);
        let found = arcs
            .iter()
            .map(|arc| distance(p, arc))
            .fold(f64::INFINITY, f64::min);
        assert!(found <= allowed, "{curve:?} at {k}: {found}");
    }
    arcs.len()
}

fn size(curve: &Curve<DVec2>) -> f64 {
    curve
        .control_points()
        .iter()
        .map(|p| p.length())
        .fold(0.0, f64::max)
}

#[test]
fn curves_stay_within_the_tolerance_both_ways() {
    let mut rng = Rng(7);
    for case in 0..crate::support::cases(400, 20_000) {
        let degree = 2 + rng.below(6);
        let scale = rng.magnitude(-6.0, 6.0);
        let mut points: Vec<DVec2> = (0..=degree)
            .map(|_| DVec2::new(rng.signed(), rng.signed()) * scale)
            .collect();
        match case % 8 {
            0 => points[1] = points[0],
            1 => points[degree] = points[0],
            2 => points.iter_mut().for_each(|p| p.y = 0.5 * p.x), // on a line, with reversals
            3 => points[1..].iter_mut().for_each(|p| p.y *= 1e-7),
            _ => {}
        }
        let curve = Curve::new(&points).expect("a curve");
        let coarse = checked(&curve, 1e-2 * scale);
        let fine = checked(&curve, 1e-5 * scale);
        // A thousandth of the tolerance takes about ten times as many arcs.
        assert!(fine <= 14 * coarse + 20, "{curve:?}: {coarse} and {fine}");
    }
}

#[test]
fn cusps_and_points() {
    let cusp =
        Curve::new(&[(0., 0.), (3., 1.), (0., 1.), (3., 0.)].map(DVec2::from)).expect("a curve");
    let count = checked(&cusp, 1e-4);
    assert!(count < 60, "{count}");
    let single = path("M1 2L1 2")
        .to_arcs(0.1)
        .expect("a tolerance")
        .remove(0);
    assert_eq!(
        (single.len(), single[0].center, single[0].radius),
        (1, None, f64::INFINITY)
    );
    assert!(
        Path::default()
            .to_arcs(0.1)
            .expect("a tolerance")
            .is_empty()
    );
}

#[test]
fn arcs_have_common_tangents_within_a_segment() {
    let curve = path("M0 0C3 4 6 -4 9 2");
    let arcs = curve.to_arcs(1e-3).expect("a tolerance").remove(0);
    assert!(arcs.len() > 4);
    let direction = |arc: &CircularArc, u: f64| {
        let center = arc.center.expect("an arc");
        let turn = (arc.end_angle - arc.start_angle).signum();
        (point(arc, u) - center).perp() * turn / arc.radius
    };
    for pair in arcs.windows(2) {
        near(
            direction(&pair[0], 1.0).dot(direction(&pair[1], 0.0)),
            1.0,
            1e-9,
        );
    }
}

#[test]
fn circles_and_lines_are_few_arcs() {
    let circle = Path::circle(DVec2::new(-7.0, 3.0), 5.0).expect("a circle");
    for tolerance in [1.0, 1e-2, 1e-3] {
        let arcs = circle.to_arcs(tolerance).expect("a tolerance").remove(0);
        assert_eq!(arcs.len(), 2, "{tolerance}: {arcs:?}");
        for arc in &arcs {
            near(arc.radius, 5.0, 1e-4);
            near(arc.end_angle - arc.start_angle, PI, 1e-3);
        }
    }
    let rounded = path("M0 0H10V10H0Z").round_corners(2.0).expect("a radius");
    let arcs = rounded.to_arcs(1e-4).expect("a tolerance").remove(0);
    assert_eq!(arcs.iter().filter(|arc| arc.center.is_none()).count(), 4);
    assert_eq!(arcs.len(), 8);
    let length: f64 = arcs
        .iter()
        .map(|arc| (arc.end_angle - arc.start_angle).abs())
        .sum();
    near(length, 2.0 * PI, 1e-6);
}

#[test]
fn the_number_grows_with_the_cube_root_of_the_tolerance() {
    let wave = path("M0 0C30 40 60 -40 90 20");
    let count = |tolerance| wave.to_arcs(tolerance).expect("a tolerance")[0].len() as f64;
    let (coarse, fine) = (count(1e-2), count(1e-8));
    assert!(
        (60.0..140.0).contains(&(fine / coarse)),
        "{coarse} and {fine}"
    );
}
