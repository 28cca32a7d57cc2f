//! Splitting, degree elevation, and the standard form.

use super::{RationalCurve, check_weights};
use crate::curve::elevate::elevate_once;
use crate::curve::split::ends_of;
use crate::geometry::check::check_points;
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, exponent};
use crate::numeric::list::Scalars;
use casteljau_kernels::bernstein::de_casteljau::{keep_between, split};
use std::ops::RangeBounds;

/// Newton's method for the n-th root doubles the number of digits in each step, after some that reduce the first guess.
const ROOT_STEPS: usize = 64;

impl<P: Point> RationalCurve<P> {
    /// Splits the curve at t into two curves of the same degree, by de Casteljau's algorithm on points with weights.
    ///
    /// Both share the point B(t), and the outer ends are exact. For t outside [0, 1], one result extends beyond the
    /// curve and the other runs backwards.
    ///
    /// # Errors
    /// For a t outside [0, 1] [`Error::Item`] if a new weight is not above 0, or a new coordinate is beyond
    /// [`MAX_COORDINATE`](crate::MAX_COORDINATE), and [`Error::NotFinite`] for a t that is not finite.
    ///
    /// Source: Farin, *Curves and Surfaces for CAGD*, §13.3.
    pub fn split(&self, t: f64) -> Result<(Self, Self), Error> {
        check_parameter(t)?;
        let (before, after) = self.split_unchecked(t);
        Ok((before.checked()?, after.checked()?))
    }

    pub(super) fn split_unchecked(&self, t: f64) -> (Self, Self) {
        let mut left = self.weighted();
        let mut right = left.clone();
        split(&mut left, &mut right, t);
        (Self::from_weighted(&left), Self::from_weighted(&right))
    }

    /// The two halves at t = ½.
    #[doc(alias = "subdivide")]
    pub fn halve(&self) -> (Self, Self) {
        self.split_unchecked(0.5)
    }

    /// The segment in a range of parameters from t₀ to t₁, as a curve of the same degree; t₀ > t₁ gives the reversed
    /// segment.
    ///
    /// Its end points are B(t₀) and B(t₁). For t₀ = t₁ it is a point. A range without a start begins at 0, one without
    /// an end ends at 1.
    ///
    /// # Errors
    /// As [`split`](Self::split).
    pub fn subsegment(&self, range: impl RangeBounds<f64>) -> Result<Self, Error> {
        let [t0, t1] = ends_of(&range, 1.0);
        check_parameter(t0)?;
        check_parameter(t1)?;
        if t0 > t1 {
            return Ok(self.part(t1, t0).checked()?.reverse());
        }
        self.part(t0, t1).checked()
    }

    /// The segment from t₀ to t₁, t₀ ≤ t₁.
    pub(super) fn part(&self, t0: f64, t1: f64) -> Self {
        let mut parts = self.weighted();
        keep_between(&mut parts, t0, t1);
        let last = parts.len() - 1;
        // The same bits as `eval` gives, so that separately computed segments join without a gap.
        parts[0].point = self.eval(t0);
        parts[last].point = self.eval(t1);
        Self::from_weighted(&parts)
    }

    /// The curve if all its points and weights are valid: an extrapolation may have others.
    pub(super) fn checked(self) -> Result<Self, Error> {
        check_weights(&self.weights, self.points.len())?;
        check_points("points", &self.points)?;
        Ok(self)
    }

    /// The same curve with degree n + 1, and so with one more control point and weight.
    ///
    /// The weights are elevated as the coefficients of a polynomial, the points as wᵢPᵢ. Source: Farin, *Curves and Surfaces for
    /// CAGD*, §13.4.
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
        let mut parts = self.weighted();
        elevate_once(&mut parts);
        Ok(Self::from_weighted(&parts))
    }

    /// The same curve in standard form: its first and last weight are 1.
    ///
    /// The points stay, t is replaced by the t′ with t′/(1 − t′) = ρ t/(1 − t), and wᵢ by wᵢ/(w₀ ρⁱ), where ρⁿ = wₙ/w₀. The ratios
    /// wᵢ₋₁ wᵢ₊₁/wᵢ², which make up the shape, stay up to rounding.
    ///
    /// # Errors
    /// [`Error::Item`] if a weight would be beyond 2⁵⁰⁰ or below 2⁻⁵⁰⁰.
    ///
    /// Source: Patterson, "Projective transformations of the parameter of a Bernstein–Bézier curve", ACM TOG 4 (1985).
    pub fn reparametrize(&self) -> Result<Self, Error> {
        let n = self.degree();
        let (first, last) = (self.weights[0], self.weights[n]);
        let ratio = nth_root(first / last, n);
        let mut power = 1.0 / first;
        let mut weights: Scalars = self
            .weights
            .iter()
            .map(|w| {
                let weight = w * power;
                power *= ratio;
                weight
            })
            .collect();
        (weights[0], weights[n]) = (1.0, 1.0);
        check_weights(&weights, n + 1)?;
        let points = self.points.clone();
        Ok(Self { points, weights })
    }
}

fn check_parameter(t: f64) -> Result<(), Error> {
    Error::unless_finite("t", &[t])
}

/// x^(1/n) for x > 0, by Newton's method from above.
pub(super) fn nth_root(x: f64, n: usize) -> f64 {
    if n == 1 || x == 1.0 {
        return x;
    }
    let power = |r: f64| (1..n).fold(1.0, |product, _| product * r);
    // 2ᵏ with k·n above the exponent of x, so that the first guess is at least the root.
    let steps = (f64::from(exponent(x) + 1) / as_f64(n)).ceil();
    let factor = if steps < 0.0 { 0.5 } else { 2.0 };
    let mut root = 1.0;
    let mut left = steps.abs();
    while left > 0.0 {
        root *= factor;
        left -= 1.0;
    }
    for _ in 0..ROOT_STEPS {
        let next = root - (root - x / power(root)) / as_f64(n);
        if next >= root {
            break;
        }
        root = next;
    }
    root
}
