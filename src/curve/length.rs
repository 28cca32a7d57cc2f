//! How long is the curve?
//!
//! The length is ∫ |B′(t)| dt. For lines and quadratics it has a closed form. Else Gauss–Legendre rules integrate the
//! speed, which they do very well where it is smooth and badly where the curve all but stops; so the curve is cut there.

use super::arc::Arc;
use super::{Curve, Points, check_tolerance, max_abs};
use crate::error::Error;
use crate::point::{Cross, Point};
use glam::DVec2;

impl<P: Point> Curve<P> {
    /// The length of the curve from t = 0 to 1.
    ///
    /// ∫ |B′(t)| dt, by a closed form for lines and quadratics, else by Gauss–Legendre rules on pieces that end where the
    /// speed is least. `tolerance` is the greatest error, in the unit of the points; without one the length is right to
    /// 10⁻¹² of itself, at cusps and turn-backs too. A curve that is a point has length 0, exactly; beyond the range of
    /// f64 the length is infinite.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let line = Curve::new(&[DVec2::new(0.0, 0.0), DVec2::new(3.0, 4.0)])?;
    /// assert_eq!(line.length(None)?, 5.0);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// For a tolerance: [`Error::Range`] unless it is above 0, [`Error::Tolerance`] below 4 ulps of the largest coordinate.
    ///
    /// Source: Gravesen, "Adaptive subdivision and the length and energy of Bézier curves", Computational Geometry 8
    /// (1997); Trefethen, *Approximation Theory and Approximation Practice*, ch. 19, for the error of the rules.
    pub fn length(&self, tolerance: Option<f64>) -> Result<f64, Error> {
        if let Some(tolerance) = tolerance {
            check_tolerance(tolerance, self.max_abs())?;
        }
        Ok(self.arc_length(tolerance))
    }

    /// The same; the tolerance was checked before.
    pub(crate) fn arc_length(&self, tolerance: Option<f64>) -> f64 {
        if let [a, b, c, d] = *self.points
            && P::DIMENSION == 2
        {
            return plane_cubic_length([a, b, c, d].map(|p| p.in_plane().to_array()));
        }
        let (slopes, unit) = hodograph(&self.points);
        if unit == 0.0 {
            return 0.0;
        }
        let length = match *slopes {
            [d] => d.norm(),
            [d, e] => line_integral(d, e),
            _ => Arc::new(&slopes, tolerance.map(|tolerance| tolerance / unit)).length(),
        };
        length * unit
    }
}

/// The length of a plane cubic.
#[inline]
pub(crate) fn plane_cubic_length(points: [[f64; 2]; 4]) -> f64 {
    let step = |i: usize| {
        points[i + 1]
            .iter()
            .zip(&points[i])
            .map(|(b, a)| (b - a).abs())
    };
    let way = step(0).chain(step(1)).chain(step(2)).fold(0.0, f64::max);
    // The kernel needs fourth powers.
    if (1e-70..1e70).contains(&way) {
        casteljau_kernels::plane_cubic_length(&points)
    } else {
        scaled_cubic_length(points)
    }
}

/// The same for very large and very small ones, and for points.
#[inline(never)]
fn scaled_cubic_length(points: [[f64; 2]; 4]) -> f64 {
    let (slopes, unit) = hodograph(&points.map(DVec2::from_array));
    if unit == 0.0 {
        return 0.0;
    }
    let (d, e, f) = (slopes[0], slopes[1], slopes[2]);
    let points = [DVec2::ZERO, d, d + e, d + e + f].map(|p| p.to_array());
    casteljau_kernels::plane_cubic_length(&points) * unit
}

/// The differences Pᵢ₊₁ − Pᵢ in a unit, a power of two, that makes the largest coordinate 1 to 2; the unit is 0 if all
/// points coincide.
pub(crate) fn hodograph<P: Point>(points: &[P]) -> (Points<P>, f64) {
    // The distance of ±1e308 is no number; that of their halves is.
    let part = if max_abs(points) < 1e300 { 1.0 } else { 0.5 };
    let mut slopes: Points<P> = points
        .windows(2)
        .map(|pair| pair[1] * part - pair[0] * part)
        .collect();
    let unit = power_of_two(max_abs(&slopes));
    for slope in &mut slopes {
        *slope = *slope / unit.max(f64::MIN_POSITIVE);
    }
    (slopes, unit / part)
}

/// The largest power of two that is not above x, but a normal number; 0 for 0.
fn power_of_two(x: f64) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    f64::from_bits(x.to_bits() & f64::INFINITY.to_bits()).max(f64::MIN_POSITIVE)
}

/// 2 ∫ |d (1 − t) + e t| dt over [0, 1]: the length of the quadratic with these differences.
///
/// With a = |e − d|, h the distance of the line through d and e from 0, and s the place along it, from `s₀` at d to
/// s₁ = s₀ + a at e, it is [s √(s² + h²) + h² arsinh(s/h)] / a. Both differences are taken without cancellation, so that
/// neither a nearly even speed nor a turn-back (h = 0) does harm.
fn line_integral<P: Point>(d: P, e: P) -> f64 {
    let (r0, r1) = (d.norm(), e.norm());
    let way = e - d;
    let a = way.norm();
    // Of the order of a² apart.
    if a <= 1e-9 * (r0 + r1) {
        return r0 + r1;
    }
    let along = way / a;
    let (mut s0, mut s1) = (d.dot(along), e.dot(along));
    if s0 + s1 < 0.0 {
        (s0, s1) = (-s1, -s0);
    }
    // s₁ is farther from 0 than s₀.
    let (r0, r1) = (r0.min(r1), r0.max(r1));
    let ratio = (s0 + s1) / (r0 + r1);
    let lengths = 0.5 * ((r0 + r1) + (s0 + s1) * ratio);
    let h = d.cross(along).size();
    let square = h * h;
    // Too near to the line to be seen.
    if square < 1e-32 * (r0 + r1) * (r0 + r1) {
        return lengths;
    }
    // (s₁ + r₁) / (s₀ + r₀) − 1; a negative s₀ would cancel.
    let start = if s0 < 0.0 {
        square / (r0 - s0)
    } else {
        s0 + r0
    };
    lengths + square * log_of_one_more(a * (1.0 + ratio) / start) / a
}

/// ln(1 + x) for x ≥ 0, to a few ulps also where x is small. Source: Goldberg, "What every computer scientist should
/// know about floating-point arithmetic", ACM Computing Surveys 23 (1991), theorem 4.
fn log_of_one_more(x: f64) -> f64 {
    let sum = 1.0 + x;
    if sum == 1.0 {
        x
    } else {
        x * sum.ln() / (sum - 1.0)
    }
}
