//! Evaluation of a curve at parameters.

use super::Curve;
use crate::bernstein::evaluate::{evaluate, weigh3, weigh4};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use casteljau_kernels::curve::sample_plane_cubic::sample_plane_cubic;

/// The maximum length of one bulk result in f64 values: 1 GiB.
pub(crate) const MAX_OUTPUT_F64: usize = 1 << 27;

impl<P: Point> Curve<P> {
    /// The point B(t).
    ///
    /// t in [0, 1] runs along the curve, other values extrapolate; the end points are exact. Up to degree 3 the result
    /// is within 3 ulps of the largest coordinate of the true point (de Casteljau's algorithm: within 2.6); above
    /// degree 3 within one ulp for each degree. Source: Farin, *Curves and Surfaces for CAGD*, 5th ed., §4.2 and §5.1.
    #[inline]
    pub fn eval(&self, t: f64) -> P {
        evaluate(&self.points, t)
    }

    /// `segments` + 1 points at t = i / `segments`, both ends included.
    ///
    /// Equal steps of t are not equal steps of arc length.
    ///
    /// # Errors
    /// [`Error::Range`] for 0 segments, [`Error::TooMany`] above 1 GiB of numbers.
    pub fn sample(&self, segments: usize) -> Result<Vec<P>, Error> {
        check_segments(segments, P::DIMENSION)?;
        let mut points = vec![P::default(); segments + 1];
        self.sample_into(&mut points);
        Ok(points)
    }

    /// Same as [`sample`](Self::sample), but writes into a buffer of `segments` + 1 points. Nothing is written into an
    /// empty buffer; a buffer of one point receives the start.
    pub fn sample_into(&self, out: &mut [P]) {
        let segments = out.len().saturating_sub(1);
        match *self.points {
            [p0, p1, p2] => fill(out, segments, |t| weigh3([p0, p1, p2], t)),
            [p0, p1, p2, p3] => match P::plane_points(out) {
                Some(out) => sample_plane_cubic([p0, p1, p2, p3].map(P::to_2d), out),
                None => fill(out, segments, |t| weigh4([p0, p1, p2, p3], t)),
            },
            _ => fill(out, segments, |t| self.eval(t)),
        }
    }

    /// The points at the given parameters.
    pub fn eval_at(&self, ts: &[f64]) -> Vec<P> {
        ts.iter().map(|&t| self.eval(t)).collect()
    }
}

#[inline(always)]
fn fill<P: Point>(out: &mut [P], segments: usize, eval: impl Fn(f64) -> P) {
    let last = segments.max(1) as f64;
    let mut i = 0.0;
    for point in out {
        // i / n and not a running sum of t, so that the last t is 1.
        *point = eval(i / last);
        i += 1.0;
    }
}

/// Returns an error for 0 segments, and for more than the limit on output allows.
pub(crate) fn check_segments(segments: usize, dimension: usize) -> Result<(), Error> {
    let limit = MAX_OUTPUT_F64 / dimension - 1;
    if segments < 1 {
        return Err(Error::Range {
            what: "segments",
            expected: "a whole number from 1",
            got: 0.0,
        });
    }
    if segments > limit {
        Err(Error::too_many("segments", limit, segments))
    } else {
        Ok(())
    }
}
