//! Paths and splines as large as maps and scans: 50,000 segments, a million with `CASTELJAU_DEEP=1`.

use crate::support::measure::from_segment;
use crate::support::paths::{lines, sides};
use crate::support::{Rng, deep, near, real};
use casteljau::glam::DVec2;
use casteljau::path::{FillRule, OffsetOptions, StrokeOptions};
use casteljau::spline::{FitOptions, Interpolation, Join};
use casteljau::{Path, Spline};
use std::f64::consts::TAU;

/// The number of segments.
fn count() -> usize {
    if deep() { 1_000_000 } else { 50_000 }
}

/// The corners of a coast: a circle with bays of every size, seen from its centre without overlaps.
fn coast(count: usize) -> Vec<DVec2> {
    let mut rng = Rng(1);
    let phases: Vec<f64> = (0..12).map(|_| rng.unit() * TAU).collect();
    let radius = |angle: f64| {
        let waves = phases.iter().zip(0..).map(|(phase, k)| {
            let frequency = f64::from(1 << k);
            (angle * frequency + phase).sin() / (frequency + 8.0)
        });
        100.0 + 20.0 * waves.sum::<f64>()
    };
    let angles = (0..count).map(|k| TAU * real(k) / real(count));
    let points = angles.map(|angle| DVec2::from_angle(angle) * radius(angle));
    points.collect()
}

#[test]
fn queries_of_a_coast() {
    let points = coast(count());
    let path = lines(&points, true);
    let area: f64 = sides(&points).map(|(a, b)| 0.5 * a.perp_dot(b)).sum();
    assert!((path.area() - area).abs() <= 1e-9 * area);
    let around: f64 = sides(&points).map(|(a, b)| a.distance(b)).sum();
    let length = path.length();
    assert!((length - around).abs() <= 1e-9 * around);
    let polylines = path.flatten(1e-3).expect("few vertices");
    assert_eq!(polylines[0].points.len(), points.len() + 1);
    assert_eq!(path.self_intersections(), []);
    for p in [[3.0, 4.0], [101.0, 2.0], [-200.0, 9.0]].map(DVec2::from) {
        let nearest = path.nearest(p).expect("a finite point").expect("a path");
        let distances = sides(&points).map(|(a, b)| from_segment(p, a, b));
        let expected = distances.fold(f64::INFINITY, f64::min);
        near(nearest.distance, expected, 1e-12);
    }
    assert!(path.contains(DVec2::ZERO, FillRule::NonZero));
    let half = path.time_at_length(0.5 * length);
    let t = half.expect("a path").t;
    near(t, real(points.len() / 2), 0.2 * real(points.len()));
    let again = Path::from_svg(&path.to_svg());
    assert_eq!(again.expect("own text"), path);
}

/// Two grids of squares, one moved by half a square: each side is shared with four others.
#[test]
fn overlaps_of_many_squares() {
    let (rows, columns) = (count() / 500, 100);
    let grid = |left: f64| {
        let square = |k: usize| {
            let corner = DVec2::new(left + real(k % columns), real(k / columns));
            Path::rect(corner, DVec2::ONE).expect("finite")
        };
        let squares = (0..rows * columns).flat_map(|k| square(k).subpaths().collect::<Vec<_>>());
        Path::new(&squares.collect::<Vec<_>>())
    };
    let found = grid(0.0).intersections(&grid(0.5));
    assert_eq!(found.len(), (2 * columns - 1) * (4 * rows - 2));
}

#[test]
fn dashes_of_a_coast() {
    let path = lines(&coast(count()), true);
    let length = path.length();
    let dashes = path.dash(&[0.01, 0.02], 0.0).expect("few dashes");
    let expected = length / 0.03;
    near(real(dashes.subpath_count()), expected, 2.0);
    let dashed = dashes.length();
    near(dashed, length / 3.0, 0.1);
}

#[test]
fn two_coasts() {
    let points = coast(count());
    let turn = DVec2::from_angle(0.3);
    let turned: Vec<DVec2> = points.iter().map(|&p| turn.rotate(p)).collect();
    let (a, b) = (lines(&points, true), lines(&turned, true));
    let crossings = a.intersections(&b);
    assert!(crossings.len() >= 2 && crossings.len().is_multiple_of(2));
    let regions = [Path::intersect, Path::union].map(|apply| apply(&a, &b, FillRule::NonZero));
    let [both, either] = regions.map(|region| region.expect("few contacts").area());
    let sum = a.area() + b.area();
    assert!((both + either - sum).abs() < 1e-6 * sum);
}

#[test]
fn strokes_and_offsets_of_a_coast() {
    let points = coast(count() / 10);
    let path = lines(&points, true);
    let stroke = path.stroke(0.1, &StrokeOptions::default());
    let length = path.length();
    let area = stroke.expect("few segments").area();
    near(area, 0.1 * length, 0.02 * length * 0.1);
    let grown = path.offset(0.05, &OffsetOptions::default());
    let more = grown.expect("few segments").area() - path.area();
    near(more, 0.05 * length, 0.02 * length * 0.05);
}

#[test]
fn splines_through_and_near_many_points() {
    let points = coast(count());
    let through = Spline::interpolate(&points, Interpolation::default(), true);
    let through = through.expect("finite points");
    assert_eq!(through.segment_count(), points.len());
    assert_eq!(through.eval(1234.0), points[1234]);
    let b_spline = Spline::from_bspline(&points, 3, None, true).expect("uniform knots");
    assert_eq!(b_spline.segment_count(), points.len());
    let bspline_length = b_spline.length();
    let length = through.length();
    assert!((bspline_length - length).abs() < 0.01 * length);
    let tolerance = 0.01;
    let near = Spline::fit(&points, &FitOptions::new(tolerance).closed(true)).expect("a tolerance");
    let simple = through.simplify(tolerance).expect("a tolerance");
    for spline in [near, simple] {
        assert!(spline.segment_count() < points.len() / 4);
        for p in points.iter().step_by(points.len() / 50) {
            let distance = spline.nearest(*p).expect("a finite point").distance;
            assert!(distance <= tolerance, "{distance}");
        }
    }
    let beside = through.offset(0.01, Join::Round);
    assert!(beside.expect("a distance").segment_count() >= points.len());
}
