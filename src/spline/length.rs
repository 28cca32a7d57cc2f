//! Arc length of a spline, and parameters at given arc lengths.

use super::Spline;
use crate::curve::arc_length::segments::SegmentLengths;
use crate::curve::eval::check_segments;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;

impl<P: Point> Spline<P> {
    /// The arc length of the spline: the sum over its segments.
    ///
    /// The relative error is at most 10⁻¹². See [`Curve::length`](crate::Curve::length).
    #[doc(alias = "arclen")]
    pub fn length(&self) -> f64 {
        self.arc_length(f64::INFINITY)
    }

    /// [`length`](Self::length) with a maximum error of the sum, in the unit of the points.
    ///
    /// # Errors
    /// As [`Curve::length_within`](crate::Curve::length_within).
    pub fn length_within(&self, tolerance: f64) -> Result<f64, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        Ok(self.arc_length(tolerance / as_f64(self.segment_count())))
    }

    /// The sum of the lengths of the segments, each within `share`.
    fn arc_length(&self, share: f64) -> f64 {
        self.segments().map(|curve| curve.arc_length(share)).sum()
    }

    /// The parameter t, from 0 to the number of segments, at the arc length s from the start.
    ///
    /// If s lies outside 0 to the total length the result is the nearer end; for a spline that is a point it is 0; for
    /// NaN it is NaN.
    #[doc(alias = "inv_arclen")]
    pub fn time_at_length(&self, s: f64) -> f64 {
        self.time_at(s, None)
    }

    /// [`time_at_length`](Self::time_at_length) with a maximum error, as a length in the unit of the points.
    ///
    /// # Errors
    /// As [`Curve::length_within`](crate::Curve::length_within).
    pub fn time_at_length_within(&self, s: f64, tolerance: f64) -> Result<f64, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        Ok(self.time_at(s, Some(tolerance)))
    }

    fn time_at(&self, s: f64, tolerance: Option<f64>) -> f64 {
        let mut lengths = self.segment_lengths();
        let (k, t) = lengths.position(s, 0.0, tolerance, &|k| self.curve(k));
        as_f64(k) + t
    }

    /// `segments` + 1 values of t that divide the spline into arcs of equal length; the first is 0, the last is the
    /// number of segments of the spline.
    ///
    /// The arc lengths are equal to within 10⁻¹² of the total length; the values do not depend on where the joints are.
    /// For a spline that is a point: even steps of t.
    ///
    /// # Errors
    /// As [`Curve::equidistant_times`](crate::Curve::equidistant_times).
    pub fn equidistant_times(&self, segments: usize) -> Result<Vec<f64>, Error> {
        check_segments(segments, 1)?;
        let lengths = self.segment_lengths();
        let positions = lengths.even_positions(segments, &|k| self.curve(k));
        // Rounding of the inverses must not make the parameters decrease.
        let mut before = 0.0_f64;
        let monotone = positions.into_iter().map(|(k, t)| {
            before = before.max(as_f64(k) + t);
            before
        });
        Ok(monotone.collect())
    }

    /// The arc length from the start to the end of each segment: 0, then one number per segment; the last is the total.
    ///
    /// Many questions about one spline need its lengths only once: s lies on the segment k with `ends[k]` ≤ s <
    /// `ends[k + 1]`, and [`time_at_length`](Self::time_at_length) is k plus
    /// [`Curve::time_at_length`](crate::Curve::time_at_length) of segment k for s − `ends[k]`. Accuracy as
    /// [`length`](Self::length) without a tolerance; a spline that is a point has only zeros.
    ///
    /// ```
    /// use casteljau::{Spline, glam::DVec2};
    ///
    /// let points = [(0., 0.), (3., 4.), (3., 6.)].map(DVec2::from);
    /// let spline = Spline::new(&points, 1, false)?;
    /// let ends = spline.cumulative_lengths();
    /// assert_eq!(ends, [0.0, 5.0, 7.0]);
    /// let k = ends[1..].partition_point(|&end| end <= 6.0);
    /// let segment = spline.segment(k).expect("6 is on the spline");
    /// let t = segment.time_at_length(6.0 - ends[k]);
    /// assert_eq!(k as f64 + t, spline.time_at_length(6.0));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn cumulative_lengths(&self) -> Vec<f64> {
        self.segment_lengths().ends().to_vec()
    }

    pub(crate) fn segment_lengths(&self) -> SegmentLengths {
        SegmentLengths::new(self.segments().map(|curve| curve.arc_length(f64::INFINITY)))
    }
}
