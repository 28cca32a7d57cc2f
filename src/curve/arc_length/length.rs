//! How long is the curve?
//!
//! The length is ∫ |B′(t)| dt. For lines and quadratics it has a closed form. Else Gauss–Legendre rules integrate the
//! speed, which they do very well where it is smooth and badly where the curve all but stops; so the curve is cut there.

use super::integral::ArcLengthTable;
use crate::curve::Curve;
use crate::geometry::check::{check_tolerance, max_abs};
use crate::geometry::error::Error;
use crate::geometry::point::{CrossProduct, Point};
use crate::numeric::list::Points;
use casteljau_kernels::plane_cubic_length;

impl<P: Point> Curve<P> {
    /// The length of the curve from t = 0 to 1.
    ///
    /// ∫ |B′(t)| dt, by a closed form for lines and quadratics, else by Gauss–Legendre rules on pieces that end where the
    /// speed is least. It is right to 10⁻¹² of itself, at cusps and turn-backs too. `tolerance` is the greatest error, in
    /// the unit of the points, and makes sense where it asks for more than that; below some roundings of the length
    /// nothing gets better. At most 4096 intervals are looked at, of which moderate numbers need less than a tenth. A curve that is a point has length 0, exactly; beyond the range of f64 the length is infinite.
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
        Ok(self.arc_length(tolerance.unwrap_or(f64::INFINITY)))
    }

    /// The same; the tolerance was checked before, and is infinite if there is none.
    pub(crate) fn arc_length(&self, tolerance: f64) -> f64 {
        if let Some(points) = self.plane_cubic() {
            let length = plane_cubic_length(&points);
            if tolerance >= KERNEL_PART * length {
                return length;
            }
        }
        let (slopes, unit) = hodograph(&self.points);
        if unit == 0.0 {
            return 0.0;
        }
        let length = match *slopes {
            [d] => d.length(),
            [d, e] => line_integral(d, e),
            _ => ArcLengthTable::new(&slopes, tolerance / unit).length(),
        };
        length * unit
    }
}

/// What the kernel for plane cubics may be off, as a part of the length.
const KERNEL_PART: f64 = 5e-13;

impl<P: Point> Curve<P> {
    /// The points of a cubic of the plane, or of space at z = 0.
    #[inline]
    fn plane_cubic(&self) -> Option<[[f64; 2]; 4]> {
        match *self.points {
            [a, b, c, d] if self.points.iter().all(|p| p.to_3d().z == 0.0) => {
                Some([a, b, c, d].map(|p| p.to_2d().to_array()))
            }
            _ => None,
        }
    }
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
    let (r0, r1) = (d.length(), e.length());
    let chord = e - d;
    let a = chord.length();
    // The speed is even but for the square of a.
    if a <= 1e-9 * (r0 + r1) {
        return r0 + r1;
    }
    let along = chord / a;
    let (mut s0, mut s1) = (d.dot(along), e.dot(along));
    if s0 + s1 < 0.0 {
        (s0, s1) = (-s1, -s0);
    }
    let h = d.cross(along).size();
    let square = h * h;
    let [r0, r1] = [s0, s1].map(|s| (s * s + square).sqrt());
    let ratio = (s0 + s1) / (r0 + r1);
    let lengths = 0.5 * ((r0 + r1) + (s0 + s1) * ratio);
    // Too near to the line to be seen, and to be known.
    if square < 1e-30 * r1 * r1 {
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
