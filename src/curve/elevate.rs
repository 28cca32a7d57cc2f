//! Degree elevation, and its inverse for curves that are elevated.

use super::Curve;
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use crate::numeric::list::{Points, points_of};
use casteljau_kernels::bernstein::de_casteljau::lerp;
use casteljau_kernels::numeric::vector::{Interpolate, Vector};

impl<P: Point> Curve<P> {
    /// The same curve with degree n + 1, and so with one more control point.
    ///
    /// Qᵢ = (i Pᵢ₋₁ + (n + 1 − i) Pᵢ) / (n + 1), Q₀ = P₀, Qₙ₊₁ = Pₙ. Source: Farin, *Curves and Surfaces for CAGD*, 5th
    /// ed., §6.1.
    ///
    /// # Errors
    /// [`Error::Range`] at degree 64.
    pub fn elevate(&self) -> Result<Self, Error> {
        if self.degree() >= MAX_DEGREE {
            return Err(Error::Range {
                what: "degree",
                expected: "a degree below 64",
                got: 64.0,
            });
        }
        Ok(self.elevated())
    }

    /// [`elevate`](Self::elevate) for a curve whose degree is known to be below 64.
    pub(crate) fn elevated(&self) -> Self {
        let mut points = self.points.clone();
        elevate_once(&mut points);
        Self { points }
    }
}

/// Replaces the Bernstein coefficients (numbers, points, points with weights) by those of degree n + 1.
pub(crate) fn elevate_once<T: Interpolate>(points: &mut Points<T>) {
    let count = points.len();
    points.push(points[count - 1]);
    for i in (1..count).rev() {
        points[i] = lerp(points[i], points[i - 1], ratio(i, count));
    }
}

/// The control points of the curve whose elevation is given, computed from both ends to the middle, where errors do not
/// grow.
pub(crate) fn unelevated<P: Vector>(high: &[P]) -> Points<P> {
    let n = high.len() - 1;
    let mut low: Points<P> = points_of(&high[..n]);
    for i in 1..n.div_ceil(2) {
        let (all, part) = (ratio(n, n - i), ratio(i, n - i));
        low[i] = high[i] * all - low[i - 1] * part;
    }
    low[n - 1] = high[n];
    for i in (n.div_ceil(2)..n - 1).rev() {
        let (all, part) = (ratio(n, i + 1), ratio(n - i - 1, i + 1));
        low[i] = high[i + 1] * all - low[i + 1] * part;
    }
    low
}
