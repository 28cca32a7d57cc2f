//! Simplification: which joints stay corners, what stays a line, and how few segments are left.

use crate::support::measure::from_polyline;
use crate::support::paths::{lines, path};
use crate::support::{real, refused};
use casteljau::glam::DVec2;
use casteljau::spline::{FitOptions, SimplifyOptions};
use casteljau::{Path, Spline};
use std::f64::consts::{PI, TAU};

/// A closed polygon around the origin, of a radius as a function of the angle.
fn around(count: usize, radius: impl Fn(f64) -> f64) -> Vec<DVec2> {
    let corner = |k| {
        let angle = TAU * real(k) / real(count);
        DVec2::from_angle(angle) * radius(angle)
    };
    (0..count).map(corner).collect()
}

fn lobed(angle: f64) -> f64 {
    100.0 * (1.0 + 0.2 * (5.0 * angle).sin())
}

/// The result, after a check that each one is within the tolerance of the other one.
fn simplified(original: &Path, tolerance: f64) -> Path {
    let simple = original.simplify(tolerance).expect("a tolerance");
    let dense = |path: &Path| {
        let lines = path.flatten(0.01 * tolerance).expect("a tolerance");
        lines
            .into_iter()
            .map(|line| line.points)
            .collect::<Vec<_>>()
    };
    for (from, to) in dense(original).iter().zip(&dense(&simple)) {
        for (points, line) in [(from, to), (to, from)] {
            for &p in points {
                let distance = from_polyline(p, line);
                assert!(distance <= 1.02 * tolerance, "{distance} for {tolerance}");
            }
        }
    }
    simple
}

#[test]
fn regular_polygons_become_circles() {
    for count in [60, 120, 140, 1000] {
        let simple = simplified(&lines(&around(count, |_| 100.0), true), 0.5);
        let segments = simple.segment_count();
        assert!(segments <= 6, "{count} corners: {segments} segments");
    }
}

/// About as few segments as a fit of the corners takes.
#[test]
fn polygons_are_simplified_as_they_are_fitted() {
    let corners = around(300, lobed);
    let outline = lines(&corners, true);
    for tolerance in [0.1, 0.5, 2.0, 5.0] {
        let segments = simplified(&outline, tolerance).segment_count();
        let fit =
            Spline::fit(&corners, &FitOptions::new(tolerance).closed(true)).expect("a tolerance");
        let most = fit.segment_count() + 4;
        assert!(segments <= most, "{tolerance}: {segments}, fitted {most}");
    }
}

/// Rounding of the control points turns every joint by some degrees.
#[test]
fn whole_numbers_do_not_add_corners() {
    let points = around(120, lobed);
    let smooth = Spline::interpolate(&points, Default::default(), true).expect("points");
    let rounded = smooth.control_points().iter().map(|p| p.round()).collect();
    let rounded = Spline::with_degrees(rounded, &smooth.degrees(), true).expect("points");
    let [few, more] =
        [smooth, rounded].map(|spline| simplified(&Path::new(&[spline]), 1.0).segment_count());
    assert!(few <= 12 && more <= 2 * few, "{few} and {more} segments");
}

#[test]
fn straight_parts_are_lines() {
    let square = path("M0 0H30H60H100V50V100H50H0V40Z");
    let simple = simplified(&square, 0.5);
    assert_eq!(simple.to_string(), "M0,0 L100,0 L100,100 L0,100 Z");
    let rounded =
        Path::rounded_rect(DVec2::ZERO, DVec2::new(100.0, 60.0), [10.0; 4]).expect("a rectangle");
    let lines = |path: &Path| path.segments().filter(|curve| curve.degree() == 1).count();
    let simple = simplified(&rounded, 0.1);
    assert_eq!((lines(&rounded), lines(&simple)), (4, 4), "{simple}");
}

#[test]
fn the_corner_angle_decides() {
    let bend = |k: i32| {
        let x = f64::from(k);
        DVec2::new(x, if k < 0 { 0.0 } else { x * (PI / 9.0).tan() })
    };
    let dense = lines(&(-100..=100).map(bend).collect::<Vec<_>>(), false);
    let options = |angle| SimplifyOptions::new(0.5).corner_angle(angle);
    let at = |angle| dense.simplify_with(&options(angle)).expect("a tolerance");
    assert_eq!(at(0.2).segment_count(), 2, "two lines: {}", at(0.2));
    assert!(
        at(PI).segments().any(|curve| curve.degree() == 3),
        "{}",
        at(PI)
    );
    let open = Spline::from_curves(&dense.segments().collect::<Vec<_>>(), false).expect("joined");
    for angle in [0.0, -1.0, 4.0, f64::NAN] {
        refused(open.simplify_with(&options(angle)), "Range corner_angle");
    }
}

#[test]
fn subpaths_stay_open_or_closed() {
    let both = path("M0 0L10 0L20 0M0 50L10 50L20 60L5 70Z");
    let simple = simplified(&both, 0.1);
    assert_eq!(simple.to_string(), "M0,0 L20,0 M0,50 L10,50 L20,60 L5,70 Z");
    assert_eq!(Path::default().simplify(1.0), Ok(Path::default()));
}
