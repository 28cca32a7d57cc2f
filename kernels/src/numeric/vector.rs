//! What algorithms ask of control points: sums and multiples, or a length too.

use crate::numeric::order::larger;
use glam::{DVec2, DVec3};
use std::ops::{Add, Div, Mul, Sub};

/// What can be added and multiplied by numbers: a number, a point, a homogeneous point.
///
/// Evaluation, de Casteljau's algorithm, elevation, products and B-splines need nothing else. Lengths, tolerances and
/// bounds need a [`Euclidean`] vector.
pub trait Vector:
    Copy + Default + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self>
{
    /// Σ wᵢ pᵢ of three vectors.
    #[inline(always)]
    fn blend3([a, b, c]: [Self; 3], [u, v, w]: [f64; 3]) -> Self {
        a * u + b * v + c * w
    }

    /// Σ wᵢ pᵢ of four vectors.
    #[inline(always)]
    fn blend4([a, b, c, d]: [Self; 4], [u, v, w, s]: [f64; 4]) -> Self {
        a * u + b * v + c * w + d * s
    }
}

impl Vector for f64 {}

/// What has others between itself and a second one: vectors, and control points with weights.
///
/// De Casteljau's algorithm, degree elevation and B-splines need nothing else.
pub trait Interpolate: Copy {
    /// The value at t between this one (t = 0) and the other (t = 1), exact at both ends.
    fn interpolate(self, other: Self, t: f64) -> Self;
}

impl<V: Vector> Interpolate for V {
    /// (1 − t)·a + t·b.
    #[inline(always)]
    fn interpolate(self, other: Self, t: f64) -> Self {
        self * (1.0 - t) + other * t
    }
}

// The sums are written out by coordinates, because a build optimized for size would call every operator.
impl Vector for DVec2 {
    #[inline(always)]
    fn blend3([a, b, c]: [Self; 3], [u, v, w]: [f64; 3]) -> Self {
        Self {
            x: a.x * u + b.x * v + c.x * w,
            y: a.y * u + b.y * v + c.y * w,
        }
    }

    #[inline(always)]
    fn blend4([a, b, c, d]: [Self; 4], [u, v, w, s]: [f64; 4]) -> Self {
        Self {
            x: a.x * u + b.x * v + c.x * w + d.x * s,
            y: a.y * u + b.y * v + c.y * w + d.y * s,
        }
    }
}

impl Vector for DVec3 {
    #[inline(always)]
    fn blend3([a, b, c]: [Self; 3], [u, v, w]: [f64; 3]) -> Self {
        Self {
            x: a.x * u + b.x * v + c.x * w,
            y: a.y * u + b.y * v + c.y * w,
            z: a.z * u + b.z * v + c.z * w,
        }
    }

    #[inline(always)]
    fn blend4([a, b, c, d]: [Self; 4], [u, v, w, s]: [f64; 4]) -> Self {
        Self {
            x: a.x * u + b.x * v + c.x * w + d.x * s,
            y: a.y * u + b.y * v + c.y * w + d.y * s,
            z: a.z * u + b.z * v + c.z * w + d.z * s,
        }
    }
}

/// A vector that has a length: a number, a vector in the plane or in space.
pub trait Euclidean: Vector + Div<f64, Output = Self> {
    /// The scalar product.
    fn dot(self, other: Self) -> f64;

    /// The largest absolute coordinate.
    fn max_abs(self) -> f64;

    /// The length; it overflows or underflows only if the true value does.
    #[inline(always)]
    fn norm(self) -> f64 {
        let square = self.dot(self);
        if (1e-280..1e280).contains(&square) {
            return square.sqrt();
        }
        let scale = self.max_abs();
        if scale == 0.0 {
            return 0.0;
        }
        // The reciprocal of a very small scale would overflow.
        let unit = self / scale;
        unit.dot(unit).sqrt() * scale
    }

    /// The vector of length 1 in this direction, for a length of at least 10⁻³⁰⁸; zero for the zero vector.
    #[inline(always)]
    fn unit(self) -> Self {
        let length = self.norm();
        if length == 0.0 {
            return Self::default();
        }
        self * (1.0 / length)
    }
}

/// A number is a vector of one coordinate.
impl Euclidean for f64 {
    #[inline(always)]
    fn dot(self, other: Self) -> f64 {
        self * other
    }

    #[inline(always)]
    fn max_abs(self) -> f64 {
        self.abs()
    }
}

impl Euclidean for DVec2 {
    #[inline(always)]
    fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    #[inline(always)]
    fn max_abs(self) -> f64 {
        larger(self.x.abs(), self.y.abs())
    }
}

impl Euclidean for DVec3 {
    #[inline(always)]
    fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    #[inline(always)]
    fn max_abs(self) -> f64 {
        larger(larger(self.x.abs(), self.y.abs()), self.z.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_near_the_limits_of_f64() {
        for size in [5e-324, 1e-310, 1e-200, 1.0, 1e200, 1e307] {
            let length = Euclidean::norm(DVec2::new(3.0, -4.0) * size) / size;
            assert!((length - 5.0).abs() < 1e-9, "{size}: {length}");
        }
        assert_eq!(Euclidean::norm(DVec3::ZERO), 0.0);
    }
}
