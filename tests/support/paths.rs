//! Paths from texts and points, and points from texts.

use super::{Rng, adversarial, de_casteljau, numbers, real};
use casteljau::glam::DVec2;
use casteljau::path::PathBuilder;
use casteljau::{Curve, Path, Spline};
use std::f64::consts::TAU;

/// A path from SVG path data.
#[track_caller]
pub(crate) fn path(d: &str) -> Path {
    d.parse().expect("path data")
}

/// Points of the plane from a text: two numbers for each.
pub(crate) fn points(text: &str) -> Vec<DVec2> {
    let numbers = numbers(text);
    numbers
        .as_chunks()
        .0
        .iter()
        .copied()
        .map(DVec2::from_array)
        .collect()
}

/// Lines from point to point.
pub(crate) fn lines(points: &[DVec2], closed: bool) -> Path {
    let mut builder = PathBuilder::new();
    builder.move_to(points[0]);
    for &p in &points[1..] {
        builder.line_to(p);
    }
    if closed {
        builder.close();
    }
    builder.build().expect("finite points")
}

/// A closed outline of segments of one degree.
pub(crate) fn closed(points: &[DVec2], degree: usize) -> Path {
    Path::from(Spline::new(points, degree, true).expect("valid points"))
}

/// The coordinates of points as bits, so that −0 differs from 0.
pub(crate) fn bits(points: &[DVec2]) -> Vec<u64> {
    let numbers = points.iter().flat_map(|p| p.to_array());
    numbers.map(f64::to_bits).collect()
}

/// Random numbers and points of the plane.
pub(crate) trait RandomPlane {
    fn between(&mut self, low: f64, high: f64) -> f64;
    fn spot(&mut self, size: f64) -> DVec2;
    fn direction(&mut self) -> DVec2;
}

impl RandomPlane for Rng {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A point of the square from −size to size.
    fn spot(&mut self, size: f64) -> DVec2 {
        self.point(2).truncate() * size
    }

    /// A unit vector.
    fn direction(&mut self) -> DVec2 {
        DVec2::from_angle(self.between(0.0, TAU))
    }
}

/// The vertices of polygons within a tolerance of a path, one for each subpath, computed without the library: a chord is
/// off by at most an eighth of the square of its step times the largest second derivative.
pub(crate) fn polygons(path: &Path, tolerance: f64) -> Vec<Vec<DVec2>> {
    let of_curve = |curve: Curve<DVec2>| {
        let points = curve.control_points().to_vec();
        let n = real(points.len() - 1);
        let second = points
            .windows(3)
            .map(|p| (p[0] - p[1] * 2.0 + p[2]).length());
        let bend = n * (n - 1.0) * second.fold(0.0, f64::max);
        let steps = (1..).find(|&k: &u32| f64::from(k * k) * 8.0 * tolerance >= bend);
        let steps = steps.expect("few steps");
        (0..=steps).map(move |k| de_casteljau(&points, f64::from(k) / f64::from(steps)))
    };
    let ring = |spline: Spline<DVec2>| spline.segments().flat_map(of_curve).collect();
    path.subpaths().map(ring).collect()
}

/// The sides of a polygon.
pub(crate) fn sides(points: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> {
    let next = points.iter().skip(1).chain(&points[..1]);
    points.iter().copied().zip(next.copied())
}

/// A spline of random degrees, on a coarse grid or not, with straight, coincident and folded pieces.
pub(crate) fn random_spline(rng: &mut Rng) -> Spline<DVec2> {
    let closed = rng.chance(0.5);
    let degree = |rng: &mut Rng| rng.pick(&[1, 1, 2, 3, 3, 3, 4, 7]);
    let degrees: Vec<usize> = (0..=rng.below(4)).map(|_| degree(rng)).collect();
    let mut points = Vec::new();
    for &degree in &degrees {
        let kind = rng.pick(&adversarial::ORDINARY);
        let curve = adversarial::points(rng, kind, degree, 2);
        points.extend(curve.iter().skip(1).map(|p| p.truncate()));
    }
    if rng.chance(0.5) {
        points.iter_mut().for_each(|p| *p = (*p * 4.0).round());
    }
    if !closed {
        points.push(rng.spot(1.0));
    }
    Spline::with_degrees(points, &degrees, closed).expect("matching counts")
}

pub(crate) fn random_splines(rng: &mut Rng, count: usize) -> Vec<Spline<DVec2>> {
    (0..count).map(|_| random_spline(rng)).collect()
}
