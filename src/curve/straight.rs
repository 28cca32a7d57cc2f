//! Straight curves: all control points lie on one line.

use super::Curve;
use crate::bernstein::roots::roots_inside;
use crate::geometry::point::{CrossProduct, Point};
use crate::numeric::float::ulp;
use crate::numeric::list::Scalars;
use glam::DVec2;

/// Control points this close to the line, in ulps of the largest coordinate, count as on it. The distance is limited to
/// a part of the length, for very short curves.
const ULPS: f64 = 4.0;
const LARGEST_PART: f64 = 1e-10;

/// A difference of at most this part of the largest one, times the degree, counts as zero.
const NO_SLOPE: f64 = 1e-15;

/// The line from the first of some points to the one that differs most from it in a coordinate.
pub(crate) struct Chord<P> {
    /// The unit vector along the line; zero if all points are equal.
    pub(crate) direction: P,
    /// The distance of these two points.
    pub(crate) length: f64,
    /// The largest distance of a point from the line.
    pub(crate) width: f64,
}

impl<P: Point> Chord<P> {
    /// Expects at least one point.
    pub(crate) fn of(points: &[P]) -> Self {
        let from_start = || points.iter().map(|&p| p - points[0]);
        let farther = |far: P, v: P| if v.max_abs() > far.max_abs() { v } else { far };
        let far = from_start().fold(P::default(), farther);
        let direction = far.unit();
        let across = from_start().map(|v| direction.cross(v).size());
        Self {
            direction,
            length: far.norm(),
            width: across.fold(0.0, f64::max),
        }
    }
}

impl Curve<DVec2> {
    /// Whether the curve is more than a point.
    pub(crate) fn has_size(&self) -> bool {
        self.points.iter().any(|&p| p != self.points[0])
    }

    /// The unit vector along a straight curve, from its start to the farthest control point; `None` if the curve bends
    /// or is a point.
    pub(crate) fn straight_direction(&self) -> Option<DVec2> {
        let chord = Chord::of(&self.points);
        let noise = (ULPS * ulp(self.max_abs())).min(LARGEST_PART * chord.length);
        (chord.length > 0.0 && chord.width <= noise).then_some(chord.direction)
    }

    /// The parameters inside (0, 1) at which the derivative along a direction is zero, in ascending order.
    pub(crate) fn turns_along(&self, direction: DVec2) -> Scalars {
        roots_inside(&self.slopes_along(direction))
    }

    /// The sign of the derivative along a direction; 0 for a zero derivative.
    pub(crate) fn sign_along(&self, direction: DVec2, t: f64) -> f64 {
        let mut row = self.slopes_along(direction);
        for last in (1..row.len()).rev() {
            for i in 0..last {
                row[i] = row[i] * (1.0 - t) + row[i + 1] * t;
            }
        }
        if row[0] == 0.0 { 0.0 } else { row[0].signum() }
    }

    /// The differences of neighbouring control points along a direction; differences of rounding size are set to 0.
    fn slopes_along(&self, direction: DVec2) -> Scalars {
        let slope = |pair: &[DVec2]| (pair[1] - pair[0]).dot(direction);
        let mut slopes: Scalars = self.points.windows(2).map(slope).collect();
        let longest = slopes.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
        let min = NO_SLOPE * longest * self.degree() as f64;
        for s in &mut slopes {
            *s = if s.abs() <= min { 0.0 } else { *s };
        }
        slopes
    }
}
