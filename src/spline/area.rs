//! Signed area of a spline.

use super::Spline;
use crate::curve::area::{area_about, triangle_area};
use crate::geometry::point::Point;
use glam::DVec2;

impl Spline<DVec2> {
    /// The signed area ½ ∫ (x dy − y dx), swept by the segment from the origin to the moving point of the spline; for a
    /// closed spline, the enclosed area.
    ///
    /// Positive if the spline turns counter-clockwise (x right, y up). A region that a closed spline encloses twice
    /// counts twice. Exact up to rounding, also far from the origin. See [`Curve::area`](crate::Curve::area).
    pub fn area(&self) -> f64 {
        self.area_xy()
    }
}

impl<P: Point> Spline<P> {
    /// [`area`](Spline::area) of the projection along z.
    pub(crate) fn area_xy(&self) -> f64 {
        // About the start, nothing cancels far from the origin. The area about the origin differs by ½ start × end.
        let start = self.points[0];
        let mut area: f64 = (0..self.segment_count())
            .map(|k| area_about(self.curve(k).control_points(), start))
            .sum();
        if !self.closed {
            area += triangle_area(start, self.points[self.points.len() - 1]);
        }
        area
    }
}
