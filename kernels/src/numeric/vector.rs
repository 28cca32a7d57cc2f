//! What algorithms ask of control points: sums and multiples, or a length too.

use crate::numeric::order::larger;
use glam::{DVec2, DVec3};
use std::ops::{Add, Mul, Sub};

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
pub trait Euclidean: Vector {
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
        let unit = self * (1.0 / scale);
        unit.dot(unit).sqrt() * scale
    }

    /// The vector of length 1 in this direction; zero for the zero vector.
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
