//! Where is the point at t?
//!
//! Degrees 1 to 3 weigh their control points with the Bernstein polynomials written out. In [0, 1] the weights are
//! positive and sum to 1, so nothing cancels and nothing overflows that is not too large itself. Higher degrees use
//! de Casteljau's algorithm, which the closed forms agree with.

use super::{Curve, Scalars, evaluate_by_casteljau};
use crate::error::Error;
use crate::point::Point;
use casteljau_kernels::sample_plane_cubic;

/// The most numbers that one bulk result may hold: 1 GiB of f64.
pub(crate) const MAX_OUTPUT_F64: usize = 1 << 27;

/// The point at t of the curve with these control points (at least one).
#[inline]
pub(crate) fn evaluate<P: Point>(points: &[P], t: f64) -> P {
    match *points {
        [p0, p1] => p0.lerp(p1, t),
        [p0, p1, p2] => weigh3([p0, p1, p2], t),
        [p0, p1, p2, p3] => weigh4([p0, p1, p2, p3], t),
        _ => evaluate_by_casteljau(points, t),
    }
}

#[inline(always)]
fn weigh3<P: Point>(points: [P; 3], t: f64) -> P {
    let s = 1.0 - t;
    P::blend3(points, [s * s, 2.0 * s * t, t * t])
}

#[inline(always)]
fn weigh4<P: Point>(points: [P; 4], t: f64) -> P {
    P::blend4(points, weights4(t))
}

#[inline(always)]
fn weights4(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    let (ss, tt) = (s * s, t * t);
    [ss * s, 3.0 * ss * t, 3.0 * s * tt, tt * t]
}

/// One coordinate of a cubic at t.
#[inline(always)]
pub(crate) fn cubic_scalar([a, b, c, d]: [f64; 4], t: f64) -> f64 {
    let [u, v, w, s] = weights4(t);
    a * u + b * v + c * w + d * s
}

/// The value at t of a polynomial with these Bernstein coefficients (at least one); the same numbers as a coordinate of
/// [`evaluate`].
pub(crate) fn evaluate_scalar(coefficients: &[f64], t: f64) -> f64 {
    let s = 1.0 - t;
    match *coefficients {
        [a, b] => a * s + b * t,
        [a, b, c] => a * (s * s) + b * (2.0 * s * t) + c * (t * t),
        [a, b, c, d] => cubic_scalar([a, b, c, d], t),
        _ => {
            let mut row = Scalars::from(coefficients);
            for last in (1..row.len()).rev() {
                for i in 0..last {
                    row[i] = row[i] * s + row[i + 1] * t;
                }
            }
            row[0]
        }
    }
}

impl<P: Point> Curve<P> {
    /// The point B(t).
    ///
    /// t in [0, 1] runs along the curve, other values extrapolate; the end points come back exactly. Up to degree 3
    /// within 3 ulps of the largest coordinate of the true point, de Casteljau's algorithm being within 2.6; above, within
    /// one ulp for each degree. Source: Farin, *Curves and Surfaces for CAGD*, 5th ed., §4.2 and §5.1.
    #[inline]
    pub fn eval(&self, t: f64) -> P {
        evaluate(&self.points, t)
    }

    /// `segments` + 1 points at t = i / `segments`, both ends included.
    ///
    /// Even steps of t are not even steps along the curve.
    ///
    /// # Errors
    /// [`Error::Range`] for 0 segments, [`Error::TooMany`] above 1 GiB of numbers.
    pub fn sample(&self, segments: usize) -> Result<Vec<P>, Error> {
        check_segments(segments, P::DIMENSION)?;
        let mut points = vec![P::default(); segments + 1];
        self.sample_into(&mut points);
        Ok(points)
    }

    /// As [`sample`](Self::sample), into a buffer: its length less one is the number of segments. Nothing is written
    /// into an empty buffer; a buffer of one gets the start.
    pub fn sample_into(&self, out: &mut [P]) {
        let segments = out.len().saturating_sub(1);
        match *self.points {
            [p0, p1, p2] => fill(out, segments, |t| weigh3([p0, p1, p2], t)),
            [p0, p1, p2, p3] if P::DIMENSION == 2 => {
                let points = [p0, p1, p2, p3].map(|p| p.to_2d().to_array());
                sample_plane_cubic(&points, bytemuck::cast_slice_mut(out));
            }
            [p0, p1, p2, p3] => fill(out, segments, |t| weigh4([p0, p1, p2, p3], t)),
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
        // i / n, not a running sum of t, so that the last t is 1.
        *point = eval(i / last);
        i += 1.0;
    }
}

/// Refuses 0 segments, and more than the limit on output allows.
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
        Err(Error::TooMany {
            what: "segments",
            limit,
            needed: segments,
        })
    } else {
        Ok(())
    }
}
