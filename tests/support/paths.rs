//! Paths from texts and points, and points from texts.

use super::{Rng, numbers};
use casteljau::glam::DVec2;
use casteljau::path::PathBuilder;
use casteljau::{Path, Spline};
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
    points[1..].iter().for_each(|&p| builder.line_to(p));
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
