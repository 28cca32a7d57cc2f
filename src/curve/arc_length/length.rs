//! Arc length of a curve.
//!
//! The length is ∫ |B′(t)| dt. For lines and quadratics it has a closed form. For other curves, Gauss–Legendre rules
//! integrate the speed. They converge fast where the speed is smooth and slowly where it is close to zero, so the curve
//! is cut at the minima of the speed.

use super::integral::{ArcLengthTable, PolynomialSpeed};
use crate::curve::Curve;
use crate::curve::hodograph::Hodograph;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::{CrossProduct, Point};
use casteljau_kernels::curve::arc_length::plane_cubic::plane_cubic_length;

impl<P: Point> Curve<P> {
    /// The length of the curve from t = 0 to 1.
    ///
    /// ∫ |B′(t)| dt, by a closed form for lines and quadratics, otherwise by Gauss–Legendre rules on intervals that are
    /// cut at the minima of the speed. The relative error is at most 10⁻¹², also for curves with cusps and reversals.
    /// At most 4096 intervals are integrated; curves with moderate numbers need less than a tenth of them. A curve that is a point has length exactly 0;
    /// beyond the range of f64 the length is infinite.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let line = Curve::new(&[DVec2::new(0.0, 0.0), DVec2::new(3.0, 4.0)])?;
    /// assert_eq!(line.length(), 5.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// Source: Gravesen, "Adaptive subdivision and the length and energy of Bézier curves", Computational Geometry 8
    /// (1997); Trefethen, *Approximation Theory and Approximation Practice*, ch. 19, for the error of the rules.
    #[doc(alias = "arclen")]
    pub fn length(&self) -> f64 {
        self.arc_length(f64::INFINITY)
    }

    /// [`length`](Self::length) with a maximum error, in the unit of the points.
    ///
    /// It has an effect only if it is finer than the 10⁻¹² of the length that `length` keeps; no accuracy is gained
    /// below 10⁻¹⁴ of the length.
    ///
    /// # Errors
    /// [`Error::Range`] for a tolerance that is not above 0, [`Error::Tolerance`] for one below 4 ulps of the largest
    /// coordinate.
    pub fn length_within(&self, tolerance: f64) -> Result<f64, Error> {
        check_tolerance(tolerance, self.max_abs())?;
        Ok(self.arc_length(tolerance))
    }

    /// [`length`](Curve::length) for a tolerance that is already checked, or infinite if there is none.
    pub(crate) fn arc_length(&self, tolerance: f64) -> f64 {
        if let Some(points) = self.plane_cubic() {
            let length = plane_cubic_length(&points);
            if tolerance >= PLANE_CUBIC_REL_ERROR * length {
                return length;
            }
        }
        let Hodograph { vectors, unit } = Hodograph::of(&self.points);
        if unit == 0.0 {
            return 0.0;
        }
        let length = match *vectors {
            [d] => d.norm(),
            [d, e] => line_integral(d, e),
            _ => ArcLengthTable::new(PolynomialSpeed::new(&vectors), tolerance / unit).length(),
        };
        length * unit
    }
}

/// Relative error bound of the kernel for plane cubics.
const PLANE_CUBIC_REL_ERROR: f64 = 5e-13;

impl<P: Point> Curve<P> {
    /// The points of a cubic in the plane, or in space with z = 0.
    #[inline]
    pub(super) fn plane_cubic(&self) -> Option<[[f64; 2]; 4]> {
        match *self.points {
            [a, b, c, d] if self.points.iter().all(|p| p.to_3d().z == 0.0) => {
                Some([a, b, c, d].map(|p| p.to_2d().to_array()))
            }
            _ => None,
        }
    }
}

/// 2 ∫ |d (1 − t) + e t| dt over [0, 1]: the length of the quadratic with the differences d and e.
///
/// With a = |e − d|, h the distance of the line through d and e from 0, and s the coordinate along it, from `s₀` at d
/// to s₁ = s₀ + a at e, it is [s √(s² + h²) + h² arsinh(s/h)] / a. Both differences are computed without cancellation,
/// so that the result is accurate for a nearly constant speed and for a reversal (h = 0).
fn line_integral<P: Point>(d: P, e: P) -> f64 {
    let (r0, r1) = (d.norm(), e.norm());
    let chord = e - d;
    let a = chord.norm();
    // The speed is constant up to terms of a².
    if a <= 1e-9 * (r0 + r1) {
        return r0 + r1;
    }
    let along = chord / a;
    let (mut s0, mut s1) = (d.dot(along), e.dot(along));
    // The integrand depends on |s| only, so the range may be reflected; then |s₀| ≤ s₁.
    if s0 + s1 < 0.0 {
        (s0, s1) = (-s1, -s0);
    }
    let h = d.cross(along).size();
    let square = h * h;
    let [r0, r1] = [s0, s1].map(|s| (s * s + square).sqrt());
    // (s₁r₁ − s₀r₀)/a = ½ [r₀ + r₁ + (s₀ + s₁)(r₁ − r₀)/a], and (r₁ − r₀)/a = (s₀ + s₁)/(r₀ + r₁).
    let ratio = (s0 + s1) / (r0 + r1);
    let lengths = 0.5 * ((r0 + r1) + (s0 + s1) * ratio);
    // h² is below rounding: its term is negligible, and its value is not known.
    if square < 1e-30 * r1 * r1 {
        return lengths;
    }
    // (s₁ + r₁) / (s₀ + r₀) − 1; the sum s₀ + r₀ would cancel for a negative s₀.
    let start = if s0 < 0.0 {
        square / (r0 - s0)
    } else {
        s0 + r0
    };
    lengths + square * log_of_one_more(a * (1.0 + ratio) / start) / a
}

/// ln(1 + x) for x ≥ 0, accurate to a few ulps also for small x. Source: Goldberg, "What every computer scientist
/// should know about floating-point arithmetic", ACM Computing Surveys 23 (1991), theorem 4.
fn log_of_one_more(x: f64) -> f64 {
    let sum = 1.0 + x;
    if sum == 1.0 {
        x
    } else {
        x * sum.ln() / (sum - 1.0)
    }
}
