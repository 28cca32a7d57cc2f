//! The parameter at a given arc length.

use super::integral::{ArcLengthTable, PolynomialSpeed, Speed};
use crate::curve::Curve;
use crate::curve::eval::check_segments;
use crate::curve::hodograph::Hodograph;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use casteljau_kernels::curve::arc_length::plane_cubic::PlaneCubicInverse;

/// Without a tolerance, the error of a length is this part of the whole: a few roundings of its sum.
const DEFAULT_SLACK: f64 = 4.0 * f64::EPSILON;

/// The inverse of the arc length of one curve, for several lengths.
pub(crate) enum ArcLengthInverse {
    PlaneCubic(PlaneCubicInverse),
    Table(InverseByTable),
}

impl ArcLengthInverse {
    /// Expects a checked tolerance.
    pub(crate) fn new<P: Point>(curve: &Curve<P>, tolerance: Option<f64>) -> Self {
        let slack = 0.5 * tolerance.unwrap_or(0.0);
        match curve.plane_cubic() {
            Some(points) => Self::PlaneCubic(PlaneCubicInverse::new(&points, slack)),
            None => Self::Table(InverseByTable::of(curve, slack)),
        }
    }

    /// The t up to which the arc length is s; 0 or 1 for an s outside the range, NaN for NaN.
    pub(crate) fn time(&mut self, s: f64) -> f64 {
        match self {
            Self::PlaneCubic(inverse) => inverse.time(s),
            Self::Table(inverse) => inverse.time(s),
        }
    }
}

/// The inverse of the arc length of a curve of any degree; the table is computed once.
pub(crate) struct InverseByTable<S = PolynomialSpeed> {
    arc: Option<ArcLengthTable<S>>,
    /// The curve's length.
    length: f64,
    /// The length according to the table; it may differ by some roundings.
    in_table: f64,
    slack: f64,
}

impl InverseByTable {
    fn of<P: Point>(curve: &Curve<P>, slack: f64) -> Self {
        let Hodograph { vectors, unit } = Hodograph::of(curve.control_points());
        let table = || ArcLengthTable::new(PolynomialSpeed::new(&vectors), f64::INFINITY);
        let arc = (unit > 0.0).then(table);
        Self::new(arc, curve.arc_length(f64::INFINITY), slack / unit)
    }
}

impl<S: Speed> InverseByTable<S> {
    /// The inverse for a curve of a given length; `slack`, an error in the unit of the table, is used where it is more than
    /// rounding.
    pub(crate) fn new(arc: Option<ArcLengthTable<S>>, length: f64, slack: f64) -> Self {
        let in_table = arc.as_ref().map_or(0.0, ArcLengthTable::length);
        Self {
            slack: slack.max(DEFAULT_SLACK * in_table),
            arc,
            length,
            in_table,
        }
    }

    pub(crate) fn time(&self, s: f64) -> f64 {
        let Some(arc) = self.arc.as_ref().filter(|_| s > 0.0) else {
            return if s.is_nan() { s } else { 0.0 };
        };
        if s >= self.length {
            return 1.0;
        }
        // The length may be infinite although the length in the table is finite.
        let part = s / self.length;
        arc.time(part.min(1.0) * self.in_table, self.slack)
    }
}

impl<P: Point> Curve<P> {
    /// The parameter t at a given arc length s: the inverse of the length from 0 to t.
    ///
    /// s runs from 0 to the whole length; outside this range the result is the nearer end, 0 or 1. For a curve that is
    /// a point it is 0; for NaN it is NaN. The error, as a length, is at most 10⁻¹² of the whole length. The method is
    /// Newton's, safeguarded by bisection.
    #[doc(alias = "inv_arclen")]
    pub fn time_at_length(&self, s: f64) -> f64 {
        ArcLengthInverse::new(self, None).time(s)
    }

    /// [`time_at_length`](Self::time_at_length) with a maximum error, as a length in the unit of the points.
    ///
    /// # Errors
    /// As [`length_within`](Self::length_within).
    pub fn time_at_length_within(&self, s: f64, tolerance: f64) -> Result<f64, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        Ok(ArcLengthInverse::new(self, Some(tolerance)).time(s))
    }

    /// `segments` + 1 parameters that divide the curve into segments of equal arc length; the first is 0, the last 1.
    ///
    /// The arc lengths are equal to within 10⁻¹² of the whole length. For a curve that is a point, the steps of t are
    /// equal. The table of the curve is computed once, so the cost grows only with `segments`.
    ///
    /// # Errors
    /// [`Error::Range`] for 0 segments, [`Error::TooMany`] above 1 GiB of numbers.
    pub fn equidistant_times(&self, segments: usize) -> Result<Vec<f64>, Error> {
        check_segments(segments, 1)?;
        let whole = self.arc_length(f64::INFINITY);
        let mut inverse = ArcLengthInverse::new(self, None);
        let mut ts = vec![0.0; segments + 1];
        // Rounding of the inverse must not make the parameters decrease.
        let mut before = 0.0;
        for (i, t) in ts.iter_mut().enumerate().skip(1) {
            let part = ratio(i, segments);
            before = if whole > 0.0 {
                inverse.time(part * whole).max(before)
            } else {
                part
            };
            *t = before;
        }
        ts[segments] = 1.0;
        Ok(ts)
    }
}
