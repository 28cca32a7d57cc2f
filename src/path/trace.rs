//! Handing a path to something that draws.

use super::Path;
use crate::curve::Curve;
use crate::curve::trace::PathSink;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;

impl Path {
    /// Sends the path to `sink`: for each subpath a `move_to` and its segments; closed ones are closed.
    ///
    /// # Errors
    /// As [`Curve::trace`].
    pub fn trace(&self, sink: &mut impl PathSink, tolerance: Option<f64>) -> Result<(), Error> {
        self.check_trace(tolerance)?;
        for part in self.parts() {
            sink.move_to(part.points[0]);
            for points in part.segments() {
                Curve::from_slice(points).trace_on(sink, tolerance);
            }
            if part.closed {
                sink.close();
            }
        }
        Ok(())
    }

    /// Refuses a tolerance that cannot be kept.
    pub(crate) fn check_trace(&self, tolerance: Option<f64>) -> Result<(), Error> {
        tolerance.map_or(Ok(()), |tolerance| {
            check_tolerance(tolerance, self.max_abs())
        })
    }
}
