//! Arc length of a spline, and parameters at given arc lengths.

use super::Spline;
use crate::curve::arc_length::inverse::{ArcLengthInverse, check_length};
use crate::curve::eval::check_segments;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;

impl<P: Point> Spline<P> {
    /// The arc length of the spline: the sum over its segments.
    ///
    /// `tolerance` is the maximum error of the sum, in the unit of the points; the default is 10⁻¹² of the length. See
    /// [`Curve::length`](crate::Curve::length).
    ///
    /// # Errors
    /// As [`Curve::length`](crate::Curve::length).
    pub fn length(&self, tolerance: Option<f64>) -> Result<f64, Error> {
        let share = match tolerance {
            Some(tolerance) => {
                check_tolerance(tolerance, self.max_abs())?;
                tolerance / self.segment_count() as f64
            }
            None => f64::INFINITY,
        };
        Ok((0..self.segment_count())
            .map(|k| self.curve(k).arc_length(share))
            .sum())
    }

    /// The parameter t, from 0 to the number of segments, at the arc length s from the start.
    ///
    /// If s lies outside 0 to the total length the result is the nearer end; for a spline that is a point it is 0.
    /// `tolerance` as in [`length`](Self::length).
    ///
    /// # Errors
    /// As [`Curve::time_at_length`](crate::Curve::time_at_length).
    pub fn time_at_length(&self, s: f64, tolerance: Option<f64>) -> Result<f64, Error> {
        check_length(s)?;
        if let Some(tolerance) = tolerance {
            check_tolerance(tolerance, self.max_abs())?;
        }
        let ends = self.cumulative_lengths();
        if s <= 0.0 {
            return Ok(0.0);
        }
        let count = self.segment_count();
        let k = ends[1..].partition_point(|&end| end <= s);
        if k == count {
            return Ok(count as f64);
        }
        Ok(k as f64 + ArcLengthInverse::new(&self.curve(k), tolerance).time(s - ends[k]))
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
        let (ends, count) = (self.cumulative_lengths(), self.segment_count());
        let whole = ends[count];
        let mut ts = vec![0.0; segments + 1];
        let mut table: Option<(usize, ArcLengthInverse)> = None;
        let mut k = 0;
        for i in 1..segments {
            let part = i as f64 / segments as f64;
            if whole == 0.0 {
                ts[i] = part * count as f64;
                continue;
            }
            let s = part * whole;
            while k + 1 < count && ends[k + 1] <= s {
                k += 1;
            }
            let (_, curve) = match table.take().filter(|&(of, _)| of == k) {
                Some(table) => table,
                None => (k, ArcLengthInverse::new(&self.curve(k), None)),
            };
            ts[i] = ts[i - 1].max(k as f64 + curve.time(s - ends[k]));
            table = Some((k, curve));
        }
        ts[segments] = count as f64;
        Ok(ts)
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
    /// let t = segment.time_at_length(6.0 - ends[k], None)?;
    /// assert_eq!(k as f64 + t, spline.time_at_length(6.0, None)?);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn cumulative_lengths(&self) -> Vec<f64> {
        let mut whole = 0.0;
        let mut ends = vec![0.0];
        for k in 0..self.segment_count() {
            whole += self.curve(k).arc_length(f64::INFINITY);
            ends.push(whole);
        }
        ends
    }
}
