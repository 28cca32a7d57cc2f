//! Simplification: which joints stay corners, what stays a line, and how few segments are left.

use crate::support::measure::from_polyline;
use crate::support::paths::{lines, path};
use crate::support::{real, refused};
use casteljau::glam::{DVec2, DVec3};
use casteljau::spline::{FitEffort, FitOptions, SimplifyOptions};
use casteljau::{Curve, Path, Spline};
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
    simplified_with(original, &SimplifyOptions::new(tolerance))
}

fn simplified_with(original: &Path, options: &SimplifyOptions) -> Path {
    let tolerance = options.tolerance;
    let simple = original.simplify_with(options).expect("options");
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

/// The number of joints with handles that are both horizontal or both vertical.
fn aligned_joints(path: &Path) -> usize {
    let segments: Vec<_> = path.segments().collect();
    let mut count = 0;
    for (before, after) in segments.iter().zip(segments.iter().cycle().skip(1)) {
        let (a, b) = (before.control_points(), after.control_points());
        let (arriving, leaving) = (a[a.len() - 1] - a[a.len() - 2], b[1] - b[0]);
        let is_aligned = |axis: usize| arriving[axis] == 0.0 && leaving[axis] == 0.0;
        count += usize::from(is_aligned(0) || is_aligned(1));
    }
    count
}

#[test]
fn extrema_become_joints() {
    let circle = Path::circle(DVec2::new(3.1, 7.3), 50.0).expect("a circle");
    let turned = casteljau::glam::DAffine2::from_angle(0.4);
    let shapes = [
        circle.transform(&turned).expect("finite"),
        lines(&around(400, |_| 100.0), true),
        lines(&around(900, lobed), true),
        path("M0 0C40 80 60 -80 100 0S130 60 90 80L20 90C0 90 -30 40 0 0Z"),
    ];
    for (shape, joints) in shapes.iter().zip([4, 4, 10, 4]) {
        for tolerance in [0.05, 0.5] {
            let options = SimplifyOptions::new(tolerance).extrema(true);
            let simple = simplified_with(shape, &options);
            for curve in simple.segments() {
                let is_monotone = |axis| curve.extrema(axis).expect("an axis").is_empty();
                assert!(is_monotone(0) && is_monotone(1), "{simple}");
            }
            let aligned = aligned_joints(&simple);
            assert!(aligned >= joints, "{aligned} of {joints}: {simple}");
        }
    }
    let [round, _, _, _] = &shapes;
    let options = SimplifyOptions::new(0.05).extrema(true);
    assert_eq!(simplified_with(round, &options).segment_count(), 4);
}

/// Control points on a grid, within the tolerance after rounding; straight parts stay lines.
#[test]
fn control_points_have_the_wanted_decimals() {
    let outline = lines(&around(300, lobed), true);
    for (decimals, tolerance) in [(0, 0.75), (0, 3.0), (1, 0.1), (2, 0.01), (6, 0.01)] {
        let options = SimplifyOptions::new(tolerance).precision(decimals);
        for options in [options, options.extrema(true)] {
            let simple = simplified_with(&outline, &options);
            let steps = 10_f64.powi(i32::from(decimals));
            for p in simple
                .segments()
                .flat_map(|curve| curve.control_points().to_vec())
            {
                let near = p.to_array().map(|x| (x * steps).round() / steps);
                assert_eq!(p.to_array(), near, "{decimals} decimals");
            }
            let exact = simplified(&outline, tolerance).segment_count();
            let count = simple.segment_count();
            assert!(
                options.extrema || count <= 2 * exact,
                "{count} instead of {exact}"
            );
        }
    }
    let bent = path("M0.2 0.3L33.2 10.2L66.2 20.1L99.2 30V77.7");
    let whole = SimplifyOptions::new(0.8).precision(0);
    assert_eq!(
        simplified_with(&bent, &whole).to_string(),
        "M0,0 L99,30 L99,78"
    );
    // What becomes a point is left out.
    let small = path("M0 0C1.2 4.4 5.6 7.8 9.9 9.9L10.1 10.1L20.3 0");
    let rounded = simplified_with(&small, &SimplifyOptions::new(0.74).precision(0));
    assert_eq!(rounded.to_string(), "M0,0 C1,5 6,8 10,10 L20,0");
    let point = path("M0.1 0.2L0.3 0.4")
        .simplify_with(&whole)
        .expect("a path");
    assert_eq!(point.to_string(), "M0,0 L0,0");
    let flat = Spline::from(Curve::line(
        DVec3::new(0.1, 0.2, 0.0),
        DVec3::new(9.1, 0.2, 0.0),
    ));
    let rounded = flat.simplify_with(&SimplifyOptions::new(0.74).precision(0));
    assert_eq!(
        rounded.expect("z = 0 is not moved").control_points(),
        [DVec3::ZERO, DVec3::X * 9.0]
    );
    let square = Spline::new(&around(4, |_| 1.0), 1, true).expect("points");
    for decimals in [0, 16, 255] {
        let options = SimplifyOptions::new(0.73).precision(decimals);
        refused(square.simplify_with(&options), "Range precision");
    }
}

/// As many segments, and closer.
#[test]
fn the_best_effort_is_closer() {
    let outline = lines(&around(400, lobed), true);
    for tolerance in [0.05, 0.5, 2.0] {
        let options = SimplifyOptions::new(tolerance).effort(FitEffort::Best);
        let [fast, best] = [
            simplified(&outline, tolerance),
            simplified_with(&outline, &options),
        ];
        assert!(best.segment_count() <= fast.segment_count());
        let original: Vec<DVec2> = around(400, lobed);
        let farthest = |path: &Path| {
            let line = &path.flatten(0.001).expect("a tolerance")[0].points;
            let far = original.iter().map(|&p| from_polyline(p, line));
            far.fold(0.0, f64::max)
        };
        assert!(farthest(&best) < 0.95 * farthest(&fast), "{tolerance}");
    }
    let points = around(200, lobed);
    let options = FitOptions::new(0.5).closed(true);
    let [fast, best] = [FitEffort::Fast, FitEffort::Best]
        .map(|effort| Spline::fit(&points, &options.effort(effort)).expect("points"));
    assert!(best.segment_count() <= fast.segment_count());
    let farthest = |spline: &Spline<DVec2>| {
        let far = points
            .iter()
            .map(|&p| spline.nearest(p).expect("finite").distance);
        far.fold(0.0, f64::max)
    };
    assert!(farthest(&best) < farthest(&fast));
}

/// A closed outline begins at a corner, so that the first segments are as long as the others.
#[test]
fn closed_outlines_begin_at_a_corner() {
    let teardrop = path("M50 0A50 50 0 1 1 0 -50L80 -50Z");
    let inside = teardrop.subpaths().next().expect("a subpath");
    let points: Vec<DVec2> = (0..200)
        .map(|k| inside.eval(real(k) / 200.0 * real(inside.segment_count())))
        .collect();
    let simple = simplified(&lines(&points, true), 0.5);
    let start = simple.subpaths().next().expect("a subpath").eval(0.0);
    assert!(
        [DVec2::new(80.0, -50.0), DVec2::new(50.0, 0.0)]
            .iter()
            .any(|corner| start.distance(*corner) < 1.0),
        "{start}"
    );
}
