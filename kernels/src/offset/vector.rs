//! Vec2 vectors.

use std::ops::{Add, Mul, Neg, Sub};

/// A point or a vector in the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec2 {
    /// The x coordinate, to the right.
    pub x: f64,
    /// The y coordinate, up.
    pub y: f64,
}

impl Vec2 {
    /// The vector (x, y).
    #[inline(always)]
    pub fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }
    #[inline(always)]
    pub(crate) fn dot(self, o: Self) -> f64 {
        self.x * o.x + self.y * o.y
    }
    #[inline(always)]
    pub(crate) fn cross(self, o: Self) -> f64 {
        self.x * o.y - self.y * o.x
    }
    #[inline(always)]
    pub(crate) fn square(self) -> f64 {
        self.dot(self)
    }
    #[inline(always)]
    pub(crate) fn length(self) -> f64 {
        self.square().sqrt()
    }
    /// The vector rotated by +90°.
    #[inline(always)]
    pub(crate) fn turned(self) -> Self {
        Self {
            x: -self.y,
            y: self.x,
        }
    }
    /// The unit vector; zero for the zero vector.
    #[inline(always)]
    pub(crate) fn unit(self) -> Self {
        let length = self.length();
        if length > 0.0 {
            self * (1.0 / length)
        } else {
            self
        }
    }
}

impl Add for Vec2 {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self {
            x: self.x + o.x,
            y: self.y + o.y,
        }
    }
}

impl Sub for Vec2 {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self {
            x: self.x - o.x,
            y: self.y - o.y,
        }
    }
}

impl Mul<f64> for Vec2 {
    type Output = Self;
    #[inline(always)]
    fn mul(self, k: f64) -> Self {
        Self {
            x: self.x * k,
            y: self.y * k,
        }
    }
}

impl Neg for Vec2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            x: -self.x,
            y: -self.y,
        }
    }
}
