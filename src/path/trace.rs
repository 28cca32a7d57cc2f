//! Sending a path to a `PathSink`.

use super::Path;
use crate::curve::Curve;
use crate::curve::trace::PathSink;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;

impl Path {
    /// Sends the path to `sink`: for each subpath a `move_to`, its segments, and `close` if it is closed.
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

    /// Returns an error for a tolerance that the coordinates cannot resolve.
    pub(crate) fn check_trace(&self, tolerance: Option<f64>) -> Result<(), Error> {
        tolerance.map_or(Ok(()), |tolerance| {
            check_tolerance(tolerance, self.max_abs())
        })
    }
}
