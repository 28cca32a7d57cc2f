//! Paths and splines as large as maps and scans: 50,000 segments, a million with `CASTELJAU_DEEP=1`.

use crate::support::deep;
use crate::support::{Rng, real};
use casteljau::glam::DVec2;
use casteljau::path::{FillRule, OffsetOptions, PathBuilder, StrokeOptions};
use casteljau::spline::{Interpolation, OffsetJoin};
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
    (0..count)
        .map(|k| TAU * real(k) / real(count))
        .map(|angle| DVec2::from_angle(angle) * radius(angle))
        .collect()
}

fn polygon(points: &[DVec2]) -> Path {
    let mut builder = PathBuilder::new();
    builder.move_to(points[0]);
    points[1..].iter().for_each(|&p| builder.line_to(p));
    builder.close();
    builder.build().expect("finite points")
}

fn sides(points: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> {
    let next = points.iter().skip(1).chain(&points[..1]);
    points.iter().copied().zip(next.copied())
}

#[test]
fn queries_of_a_coast() {
    let points = coast(count());
    let path = polygon(&points);
    let area: f64 = sides(&points).map(|(a, b)| 0.5 * a.perp_dot(b)).sum();
    assert!((path.area() - area).abs() <= 1e-9 * area);
    let around: f64 = sides(&points).map(|(a, b)| a.distance(b)).sum();
    let length = path.length(None).expect("no tolerance");
    assert!((length - around).abs() <= 1e-9 * around);
    let lines = path.flatten(1e-3).expect("few vertices");
    assert_eq!(lines[0].points.len(), points.len() + 1);
    assert_eq!(path.self_intersections(), []);
    for p in [
        DVec2::new(3.0, 4.0),
        DVec2::new(101.0, 2.0),
        DVec2::new(-200.0, 9.0),
    ] {
        let nearest = path.nearest(p).expect("a finite point").expect("a path");
        let expected = sides(&points)
            .map(|(a, b)| {
                let t = (p - a).dot(b - a) / (b - a).length_squared();
                p.distance(a + (b - a) * t.clamp(0.0, 1.0))
            })
            .fold(f64::INFINITY, f64::min);
        assert!((nearest.distance - expected).abs() < 1e-12, "{p}");
    }
    assert!(path.contains(DVec2::ZERO, FillRule::NonZero));
    let half = path.time_at_length(0.5 * length, None).expect("a length");
    let t = half.expect("a path").t;
    let passed: f64 = sides(&points)
        .take(points.len() / 2)
        .map(|(a, b)| a.distance(b))
        .sum();
    assert!(
        (t - real(points.len() / 2)).abs() < 0.2 * real(points.len()),
        "{t} {passed}"
    );
    let again = Path::from_svg(&path.to_svg(None, None).expect("no tolerance"));
    assert_eq!(again.expect("own text"), path);
}

#[test]
fn dashes_of_a_coast() {
    let path = polygon(&coast(count()));
    let length = path.length(None).expect("no tolerance");
    let dashes = path.dash(&[0.01, 0.02], 0.0).expect("few dashes");
    let expected = length / 0.03;
    let got = real(dashes.subpath_count());
    assert!(
        (got - expected).abs() <= 2.0,
        "{got} dashes, {expected} expected"
    );
    let dashed = dashes.length(None).expect("no tolerance");
    assert!((dashed - length / 3.0).abs() < 0.1, "{dashed} of {length}");
}

#[test]
fn two_coasts() {
    let points = coast(count());
    let turned: Vec<DVec2> = points
        .iter()
        .map(|p| DVec2::from_angle(0.3).rotate(*p))
        .collect();
    let (a, b) = (polygon(&points), polygon(&turned));
    let crossings = a.intersections(&b);
    assert!(crossings.len() >= 2 && crossings.len().is_multiple_of(2));
    let [both, either] = [Path::intersect, Path::union].map(|apply| {
        apply(&a, &b, FillRule::NonZero)
            .expect("few contacts")
            .area()
    });
    let sum = a.area() + b.area();
    assert!((both + either - sum).abs() < 1e-6 * sum);
}

#[test]
fn strokes_and_offsets_of_a_coast() {
    let points = coast(count() / 10);
    let path = polygon(&points);
    let stroke = path.stroke(0.1, &StrokeOptions::default());
    let length = path.length(None).expect("no tolerance");
    let area = stroke.expect("few segments").area();
    assert!(
        (area - 0.1 * length).abs() < 0.02 * length * 0.1,
        "{area} of {length}"
    );
    let grown = path.offset(0.05, &OffsetOptions::default());
    let more = grown.expect("few segments").area() - path.area();
    assert!(
        (more - 0.05 * length).abs() < 0.02 * length * 0.05,
        "{more} of {length}"
    );
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
    let bspline_length = b_spline.length(None).expect("no tolerance");
    let length = through.length(None).expect("no tolerance");
    assert!((bspline_length - length).abs() < 0.01 * length);
    let tolerance = 0.01;
    let near = Spline::fit(&points, tolerance, None, true).expect("a tolerance");
    assert!(
        near.segment_count() < points.len() / 4,
        "{}",
        near.segment_count()
    );
    for p in points.iter().step_by(points.len() / 50) {
        let distance = near.nearest(*p).expect("a finite point").distance;
        assert!(distance <= tolerance, "{distance}");
    }
    let simple = through.simplify(tolerance).expect("a tolerance");
    assert!(simple.segment_count() < points.len() / 4);
    for p in points.iter().step_by(points.len() / 50) {
        let distance = simple.nearest(*p).expect("a finite point").distance;
        assert!(distance <= tolerance, "{distance}");
    }
    let beside = through
        .offset(0.01, None, OffsetJoin::Round)
        .expect("a distance");
    assert!(beside.segment_count() >= points.len());
}
