//! How long is it?

use super::Path;
use crate::curve::{Curve, check_tolerance, plane_cubic_length};
use crate::error::Error;
use crate::point::Point;
use glam::DVec2;

impl Path {
    /// The sum of the lengths of all segments; the gaps between subpaths do not count, nor do open ends.
    ///
    /// `tolerance` is the greatest error, in the unit of the points; without one the length is right to 10⁻¹² of itself.
    /// Of the empty path 0. Source: as [`Curve::length`].
    ///
    /// # Errors
    /// As [`Curve::length`].
    pub fn length(&self, tolerance: Option<f64>) -> Result<f64, Error> {
        if let Some(tolerance) = tolerance {
            check_tolerance(tolerance, self.max_abs())?;
        }
        let share = tolerance.map(|tolerance| tolerance / self.segment_count().max(1) as f64);
        let lengths = self.segments().map(|points| segment_length(points, share));
        Ok(lengths.fold(0.0, |sum, length| sum + length))
    }
}

/// The length of one segment.
fn segment_length(points: &[DVec2], tolerance: Option<f64>) -> f64 {
    if let &[a, b, c, d] = points {
        return plane_cubic_length([a, b, c, d].map(|p| p.to_array()));
    }
    // In space, as all lengths but those of plane cubics are computed.
    let points = points.iter().map(|p| p.in_space()).collect();
    Curve::from_points(points).arc_length(tolerance)
}
