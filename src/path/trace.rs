//! Sending a path to a `PathSink`.

use super::Path;
use crate::curve::Curve;
use crate::curve::trace::PathSink;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;

impl Path {
    /// Sends the path to `sink`: for each subpath a `move_to`, its segments, and `close` if it is closed.
    pub fn trace(&self, sink: &mut (impl PathSink + ?Sized)) {
        self.trace_all(sink, None);
    }

    /// [`trace`](Self::trace) with the largest distance of cubics from segments above degree 3.
    ///
    /// # Errors
    /// As [`Curve::trace_within`].
    pub fn trace_within(
        &self,
        sink: &mut (impl PathSink + ?Sized),
        tolerance: f64,
    ) -> Result<(), Error> {
        check_tolerance(tolerance, self.max_abs())?;
        self.trace_all(sink, Some(tolerance));
        Ok(())
    }

    fn trace_all(&self, sink: &mut (impl PathSink + ?Sized), tolerance: Option<f64>) {
        for part in self.parts() {
            sink.move_to(part.points[0]);
            for points in part.segments() {
                Curve::from_slice(points).trace_on(sink, tolerance);
            }
            if part.closed {
                sink.close();
            }
        }
    }
}
