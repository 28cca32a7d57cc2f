//! Queries, answered by the segments.

use super::NurbsCurve;
use crate::curve::arc_length::point_at_length::PointAtLength;
use crate::curve::eval::check_segments;
use crate::curve::flatten::MAX_VERTICES;
use crate::curve::trace::PathSink;
use crate::curve::{Nearest, Polyline};
use crate::geometry::bounds::Bounds;
use crate::geometry::check::{check_points, check_tolerance, max_abs};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use crate::rational::RationalCurve;
use crate::spline::Spline;
use glam::DVec2;

/// The interval between joints that contains t, and the place of t in it from 0 to 1; the end belongs to the last interval.
pub(in crate::rational) fn locate(joints: &[f64], t: f64) -> (usize, f64) {
    let k = joints[1..joints.len() - 1].partition_point(|&u| u <= t);
    let (from, to) = (joints[k], joints[k + 1]);
    // Exact at both ends.
    (
        k,
        if t == to {
            1.0
        } else {
            (t - from) / (to - from)
        },
    )
}

impl<P: Point> NurbsCurve<P> {
    /// The segment that contains t and the parameter on it; the end belongs to the last segment.
    fn locate(&self, t: f64) -> (usize, f64) {
        locate(&self.joints, t)
    }

    /// The t of a parameter on a segment.
    pub(super) fn time(&self, k: usize, s: f64) -> f64 {
        let (from, to) = (self.joints[k], self.joints[k + 1]);
        if s == 1.0 { to } else { from + s * (to - from) }
    }

    fn segment_at(&self, t: f64) -> (&RationalCurve<P>, f64) {
        let (k, s) = self.locate(t);
        (&self.segments[k], s)
    }

    /// The point at t. Outside the domain the first and the last segment are extrapolated; the result is NaN where their
    /// denominator is not above 0.
    pub fn eval(&self, t: f64) -> P {
        let (segment, s) = self.segment_at(t);
        segment.eval(s)
    }

    /// The points at the given parameters.
    pub fn eval_at(&self, ts: &[f64]) -> Vec<P> {
        ts.iter().map(|&t| self.eval(t)).collect()
    }

    /// `segments` + 1 points at even steps of t over the domain, both ends included.
    ///
    /// # Errors
    /// As [`RationalCurve::sample`].
    pub fn sample(&self, segments: usize) -> Result<Vec<P>, Error> {
        check_segments(segments, P::DIMENSION)?;
        let [from, to] = self.domain();
        let at = |i| {
            let part = ratio(i, segments);
            self.eval(from * (1.0 - part) + to * part)
        };
        Ok((0..=segments).map(at).collect())
    }

    /// The k-th derivative by t; k = 0 is the point itself. At a joint it is that of the segment that starts there.
    ///
    /// # Errors
    /// As [`RationalCurve::derivative_at`].
    pub fn derivative_at(&self, t: f64, k: usize) -> Result<P, Error> {
        let (i, s) = self.locate(t);
        let length = self.joints[i + 1] - self.joints[i];
        let derivative = self.segments[i].derivative_at(s, k)?;
        Ok((0..k).fold(derivative, |sum, _| sum / length))
    }

    /// The unit tangent at t; see [`RationalCurve::tangent`].
    pub fn tangent(&self, t: f64) -> P {
        let (segment, s) = self.segment_at(t);
        segment.tangent(s)
    }

    /// The unit normal at t; see [`RationalCurve::normal`].
    pub fn normal(&self, t: f64) -> P {
        let (segment, s) = self.segment_at(t);
        segment.normal(s)
    }

    /// The curvature at t, in 1 / unit of length; see [`RationalCurve::curvature`].
    pub fn curvature(&self, t: f64) -> f64 {
        let (segment, s) = self.segment_at(t);
        segment.curvature(s)
    }

    /// The smallest box that contains the curve.
    #[doc(alias = "bounding_box")]
    pub fn bounds(&self) -> Bounds<P> {
        let first = self.segments[0].bounds();
        let others = self.segments[1..].iter();
        others.fold(first, |bounds, segment| bounds.union(segment.bounds()))
    }

    /// The box of the control points, which contains the curve and is cheaper than [`bounds`](Self::bounds).
    pub fn control_bounds(&self) -> Bounds<P> {
        Bounds::from_points(&self.points)
    }

    /// The point of the curve that is nearest to p: the minimum over all segments of [`RationalCurve::nearest`], with t in
    /// the domain; of equally near points the one with the smallest t. Segments whose control points' box is farther away than
    /// the best point so far are skipped.
    ///
    /// # Errors
    /// As [`RationalCurve::nearest`].
    #[doc(alias = "closest")]
    pub fn nearest(&self, p: P) -> Result<Nearest<P>, Error> {
        check_points("p", &[p])?;
        let ends = self.segments.iter();
        let mut max = ends.fold(f64::INFINITY, |max, segment| {
            max.min(segment.start().distance(p))
        });
        let mut best: Option<Nearest<P>> = None;
        for (k, segment) in self.segments.iter().enumerate() {
            if segment.control_bounds().distance(p) * (1.0 - 8.0 * f64::EPSILON) > max {
                continue;
            }
            let found = segment.nearest(p)?;
            if best.is_none_or(|best| found.distance < best.distance) {
                max = max.min(found.distance);
                best = Some(Nearest {
                    t: self.time(k, found.t),
                    ..found
                });
            }
        }
        // The segment with the nearest start is not skipped.
        Ok(best.unwrap_or(Nearest {
            t: self.joints[0],
            point: self.start(),
            distance: self.start().distance(p),
        }))
    }

    /// The length of the curve: the sum of those of its segments; see [`RationalCurve::length`].
    #[doc(alias = "arclen")]
    pub fn length(&self) -> f64 {
        self.segments.iter().map(RationalCurve::length).sum()
    }

    /// The parameter t at the arc length s from the start; see [`RationalCurve::time_at_length`].
    ///
    /// s runs from 0 to the whole length; outside this range the result is the nearer end of the domain. NaN for NaN.
    #[doc(alias = "inv_arclen")]
    pub fn time_at_length(&self, s: f64) -> f64 {
        let mut rest = s;
        let last = self.segments.len() - 1;
        for (k, segment) in self.segments.iter().enumerate() {
            let length = segment.length();
            if rest < length || k == last || s.is_nan() {
                return self.time(k, segment.time_at_length(rest));
            }
            rest -= length;
        }
        self.joints[last + 1]
    }

    /// The point at the arc length s from the start, with tangent and normal.
    pub fn point_at_length(&self, s: f64) -> PointAtLength<P> {
        let t = self.time_at_length(s);
        PointAtLength {
            t,
            point: self.eval(t),
            tangent: self.tangent(t),
            normal: self.normal(t),
        }
    }

    /// The parameters inside the domain where a coordinate (0 is x, 1 is y, 2 is z) has a local extremum inside a segment, in
    /// ascending order; see [`RationalCurve::extrema`].
    ///
    /// # Errors
    /// As there.
    pub fn extrema(&self, axis: usize) -> Result<Vec<f64>, Error> {
        let mut all = Vec::new();
        for (k, segment) in self.segments.iter().enumerate() {
            let found = segment.extrema(axis)?;
            all.extend(found.into_iter().map(|s| self.time(k, s)));
        }
        Ok(all)
    }

    /// A polyline whose distance from every point of the curve is at most `tolerance`; every joint is a vertex. See
    /// [`RationalCurve::flatten`].
    ///
    /// # Errors
    /// As there.
    pub fn flatten(&self, tolerance: f64) -> Result<Polyline<P>, Error> {
        check_tolerance(tolerance, max_abs(&self.points))?;
        let mut line = Polyline::default();
        for (k, segment) in self.segments.iter().enumerate() {
            let part = segment.flatten(tolerance)?;
            let skipped = usize::from(k > 0);
            let ts = part.ts.iter().skip(skipped);
            line.ts.extend(ts.map(|&s| self.time(k, s)));
            line.points.extend_from_slice(&part.points[skipped..]);
            if line.ts.len() > MAX_VERTICES {
                return Err(Error::too_many("vertices", MAX_VERTICES, line.ts.len()));
            }
        }
        Ok(line)
    }

    /// A spline of cubics within `tolerance` of the curve; segments whose weights are equal stay as they are. See
    /// [`RationalCurve::to_spline`].
    ///
    /// The spline is closed if the curve is, or if it ends at the point where it starts.
    ///
    /// # Errors
    /// As there.
    pub fn to_spline(&self, tolerance: f64) -> Result<Spline<P>, Error> {
        check_tolerance(tolerance, max_abs(&self.points))?;
        let mut points = vec![self.start()];
        let mut degrees = Vec::new();
        for segment in &self.segments {
            segment.for_each_polynomial(tolerance, &mut |curve| {
                degrees.push(curve.degree());
                points.extend_from_slice(&curve.control_points()[1..]);
            });
        }
        let closed = points.len() > 2 && self.start() == self.end();
        if closed {
            points.pop();
        }
        Ok(Spline::from_parts(points, &degrees, closed))
    }
}

impl NurbsCurve<DVec2> {
    /// The signed area that the segment from the origin to the curve sweeps; see [`RationalCurve::area`]. For a closed curve
    /// it is the enclosed area.
    pub fn area(&self) -> f64 {
        self.segments.iter().map(RationalCurve::area).sum()
    }

    /// Sends the curve to `sink` as lines and cubics within `tolerance`, beginning with a `move_to` its start; a curve that ends
    /// where it starts is closed.
    ///
    /// # Errors
    /// As [`flatten`](Self::flatten) for the tolerance.
    pub fn trace_within(
        &self,
        sink: &mut (impl PathSink + ?Sized),
        tolerance: f64,
    ) -> Result<(), Error> {
        self.to_spline(tolerance)?.trace_within(sink, tolerance)
    }
}
