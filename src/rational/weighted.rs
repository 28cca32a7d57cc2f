//! Control points with weights, and homogeneous points.
//!
//! A point P with the weight w has the homogeneous coordinates (wP, w). Algorithms that only interpolate keep point and
//! weight apart, so that P comes back without rounding; sums of several points use homogeneous coordinates.

use crate::geometry::point::Point;
use crate::numeric::float::unit_scale;
use casteljau_kernels::numeric::vector::{Interpolate, Vector};
use std::ops::{Add, AddAssign, Mul, Sub};

/// A control point and its weight.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct WeightedPoint<P> {
    pub(crate) point: P,
    pub(crate) weight: f64,
}

impl<P: Point> Interpolate for WeightedPoint<P> {
    /// Homogeneous interpolation: w = (1 − t)w₀ + t w₁ and P = (1 − s)P₀ + s P₁ with s = t w₁/w. For t in [0, 1] both are
    /// convex combinations. Source: Farin, *Curves and Surfaces for CAGD*, §13.3.
    #[inline]
    fn interpolate(self, other: Self, t: f64) -> Self {
        let weight = self.weight.interpolate(other.weight, t);
        Self {
            point: self.point.lerp(other.point, t * other.weight / weight),
            weight,
        }
    }
}

/// A point in homogeneous coordinates, or a sum of such points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Homogeneous<P> {
    pub(crate) vector: P,
    pub(crate) weight: f64,
}

impl<P: Point> Homogeneous<P> {
    #[inline]
    pub(crate) fn new(point: P, weight: f64) -> Self {
        Self {
            vector: point * weight,
            weight,
        }
    }

    /// The point; NaN unless the weight is above 0.
    #[inline]
    pub(crate) fn point(self) -> P {
        if self.weight > 0.0 {
            self.vector / self.weight
        } else {
            P::splat(f64::NAN)
        }
    }
}

impl<P: Point> Add for Homogeneous<P> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            vector: self.vector + other.vector,
            weight: self.weight + other.weight,
        }
    }
}

impl<P: Point> AddAssign for Homogeneous<P> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<P: Point> Sub for Homogeneous<P> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self {
            vector: self.vector - other.vector,
            weight: self.weight - other.weight,
        }
    }
}

impl<P: Point> Mul<f64> for Homogeneous<P> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: f64) -> Self {
        Self {
            vector: self.vector * factor,
            weight: self.weight * factor,
        }
    }
}

impl<P: Point> Vector for Homogeneous<P> {}

/// A net with rows and columns exchanged, where `columns` is the length of a row.
#[cfg(feature = "surfaces")]
pub(super) fn transposed<T: Copy>(net: &[T], columns: usize) -> Vec<T> {
    (0..columns)
        .flat_map(|i| net.iter().skip(i).step_by(columns).copied())
        .collect()
}

/// The power of two that makes the largest weight 1 to 2.
pub(super) fn weight_scale(weights: &[f64]) -> f64 {
    unit_scale(weights.iter().copied().fold(0.0, f64::max))
}

/// Whether lists of numbers are equal within `tolerance` times the largest one.
pub(super) fn are_close(a: &[f64], b: &[f64], tolerance: f64) -> bool {
    let size = a.iter().chain(b).fold(0.0, |max: f64, x| max.max(x.abs()));
    let mut pairs = a.iter().zip(b);
    a.len() == b.len() && pairs.all(|(a, b)| (a - b).abs() <= tolerance * size)
}

/// Whether weights are equal up to a common factor, each within `tolerance` times the largest one.
pub(super) fn are_proportional(a: &[f64], b: &[f64], tolerance: f64) -> bool {
    let (scale_a, scale_b) = (weight_scale(a), weight_scale(b));
    // The ratio of the first weights is the common factor.
    let factor = (a[0] * scale_a) / (b[0] * scale_b);
    let close =
        |(v, w): (&f64, &f64)| (v * scale_a - w * scale_b * factor).abs() <= 2.0 * tolerance;
    a.len() == b.len() && a.iter().zip(b).all(close)
}
