//! Handing a path to something that draws.

use super::Path;
use crate::curve::{Curve, Pen, check_tolerance};
use crate::error::Error;

impl Path {
    /// Draws the path with `pen`: for each subpath a `move_to` and its segments; closed ones are closed.
    ///
    /// # Errors
    /// As [`Curve::trace`].
    pub fn trace(&self, pen: &mut impl Pen, tolerance: Option<f64>) -> Result<(), Error> {
        self.check_trace(tolerance)?;
        for part in self.parts() {
            pen.move_to(part.points[0]);
            for points in part.segments() {
                Curve::from_slice(points).trace_on(pen, tolerance);
            }
            if part.closed {
                pen.close();
            }
        }
        Ok(())
    }

    /// Refuses a tolerance that cannot be kept.
    pub(super) fn check_trace(&self, tolerance: Option<f64>) -> Result<(), Error> {
        tolerance.map_or(Ok(()), |tolerance| {
            check_tolerance(tolerance, self.max_abs())
        })
    }
}
