//! Evaluation, sampling, flattening and bounding boxes of splines.

use super::Spline;
use crate::curve::eval::check_segments;
use crate::curve::flatten::{MAX_VERTICES, Polyline, check_vertices, visit_vertices};
use crate::curve::trace::PathSink;
use crate::geometry::bounds::Bounds;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, whole_and_rest};
use glam::DVec2;

impl<P: Point> Spline<P> {
    /// The point at t: segment ⌊t⌋ at the fractional part of t. t runs from 0 to the number of segments; values outside
    /// extrapolate the first and the last segment.
    pub fn eval(&self, t: f64) -> P {
        let (k, rest) = self.locate(t);
        self.curve(k).eval(rest)
    }

    /// The segment that contains t and the local parameter on it; the end belongs to the last segment.
    pub(crate) fn locate(&self, t: f64) -> (usize, f64) {
        whole_and_rest(t, self.segment_count() - 1)
    }

    /// Points at even steps of t, `per_curve` steps per segment, both ends included.
    ///
    /// # Errors
    /// As [`Curve::sample`](crate::Curve::sample).
    pub fn sample(&self, per_curve: usize) -> Result<Vec<P>, Error> {
        let total = per_curve.saturating_mul(self.segment_count());
        check_segments(total, P::DIMENSION)?;
        let mut points = vec![P::default(); total + 1];
        for k in 0..self.segment_count() {
            self.curve(k)
                .sample_into(&mut points[k * per_curve..=(k + 1) * per_curve]);
        }
        Ok(points)
    }

    /// The points at the given parameters.
    pub fn eval_at(&self, ts: &[f64]) -> Vec<P> {
        ts.iter().map(|&t| self.eval(t)).collect()
    }

    /// A polyline within `tolerance` of the spline; every joint is a vertex.
    ///
    /// # Errors
    /// As [`Curve::flatten`](crate::Curve::flatten).
    pub fn flatten(&self, tolerance: f64) -> Result<Polyline<P>, Error> {
        self.check_flatten(tolerance)?;
        let mut line = Polyline::default();
        for (k, curve) in self.segments().enumerate() {
            line.append(&curve, as_f64(k), tolerance);
        }
        Ok(line)
    }

    /// Same as [`flatten`](Self::flatten), but passes each vertex to `vertex` instead of collecting them.
    ///
    /// # Errors
    /// As [`Curve::flatten_with`](crate::Curve::flatten_with).
    pub fn flatten_with(
        &self,
        tolerance: f64,
        mut vertex: impl FnMut(f64, P),
    ) -> Result<(), Error> {
        self.check_flatten(tolerance)?;
        for (k, curve) in self.segments().enumerate() {
            let shifted = |t, p| vertex(as_f64(k) + t, p);
            visit_vertices(curve.control_points(), k > 0, tolerance, shifted);
        }
        Ok(())
    }

    fn check_flatten(&self, tolerance: f64) -> Result<(), Error> {
        check_tolerance(tolerance, self.max_abs())?;
        self.check_vertices(tolerance, MAX_VERTICES)
    }

    /// Returns an error if flattening gives more vertices than the limit.
    pub(super) fn check_vertices(&self, tolerance: f64, limit: usize) -> Result<(), Error> {
        let all = (self.points.len(), self.max_abs());
        check_vertices(all, || self.segments(), tolerance, limit)
    }

    /// The tight bounding box of the spline.
    #[doc(alias = "bounding_box")]
    pub fn bounds(&self) -> Bounds<P> {
        let first = self.curve(0).bounds();
        (1..self.segment_count()).fold(first, |bounds, k| bounds.union(self.curve(k).bounds()))
    }

    /// The bounding box of the control points.
    pub fn control_bounds(&self) -> Bounds<P> {
        Bounds::from_points(&self.points)
    }
}

impl Spline<DVec2> {
    /// Sends the spline to `sink`: one `move_to`, then its segments; a closed spline is closed.
    pub fn trace(&self, sink: &mut (impl PathSink + ?Sized)) {
        self.trace_all(sink, None);
    }

    /// [`trace`](Self::trace) with the largest distance of cubics from segments above degree 3.
    ///
    /// # Errors
    /// As [`Curve::trace_within`](crate::Curve::trace_within).
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
        sink.move_to(self.points[0]);
        for k in 0..self.segment_count() {
            self.curve(k).trace_on(sink, tolerance);
        }
        if self.closed {
            sink.close();
        }
    }
}
