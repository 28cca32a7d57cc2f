//! The sealed trait [`Point`] for `DVec2` and `DVec3`: the operations that curves need.

use casteljau_kernels::numeric::vector::Vector;
use casteljau_kernels::spline::fit_run::{FitRun, plane_handles, space_handles};
use glam::{DAffine2, DAffine3, DMat3, DMat4, DVec2, DVec3};
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

mod sealed {
    use super::{DVec2, DVec3, FitRun, Vector, plane_handles, space_handles};

    /// What the crate needs of a point and programs do not: the kernels for the plane or for space.
    pub trait Kernels: Vector {
        /// The same points, if they are points in the plane.
        fn plane_points(points: &mut [Self]) -> Option<&mut [DVec2]>;
        /// The inner control points of a cubic along a run of points, or `None` if none was found.
        fn fit_handles(run: &FitRun<Self>) -> Option<[Self; 2]>;
    }

    impl Kernels for DVec2 {
        #[inline]
        fn plane_points(points: &mut [Self]) -> Option<&mut [DVec2]> {
            Some(points)
        }
        fn fit_handles(run: &FitRun<Self>) -> Option<[Self; 2]> {
            plane_handles(run)
        }
    }

    impl Kernels for DVec3 {
        #[inline]
        fn plane_points(_points: &mut [Self]) -> Option<&mut [DVec2]> {
            None
        }
        fn fit_handles(run: &FitRun<Self>) -> Option<[Self; 2]> {
            space_handles(run)
        }
    }
}

/// A point or a vector in the plane or in space: glam's `DVec2` or `DVec3`. The trait is sealed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a point: expected `DVec2` or `DVec3` of glam",
    label = "expected `DVec2` or `DVec3`",
    note = "a `Vec2` or `Vec3` converts with `as_dvec2()` or `as_dvec3()`, a pair or an array with `DVec2::from`"
)]
pub trait Point:
    sealed::Kernels
    + Copy
    + Debug
    + Default
    + PartialEq
    + Add<Output = Self>
    + AddAssign
    + Sub<Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The number of coordinates, 2 or 3.
    const DIMENSION: usize;
    /// The origin.
    const ZERO: Self;
    /// The affine maps of this space.
    type Affine: Copy + Debug;
    /// The projective maps of this space: `DMat3` for the plane, `DMat4` for space.
    type Projective: Copy + Debug;
    /// The type of A×B: a number in the plane (the signed area), a vector in space.
    type CrossProduct: CrossProduct;

    /// The point whose coordinates are all equal to a number.
    fn splat(value: f64) -> Self;
    /// The point in space; z = 0 for a plane point.
    fn to_3d(self) -> DVec3;
    /// The point in the plane; drops the z of a point in space.
    fn to_2d(self) -> DVec2;
    /// One coordinate: 0 is x, 1 is y, 2 is z.
    fn coordinate(self, axis: usize) -> f64;
    /// This point with one coordinate replaced.
    #[must_use]
    fn with_coordinate(self, axis: usize, value: f64) -> Self;
    /// The scalar product.
    fn dot(self, other: Self) -> f64;
    /// The cross product.
    fn cross(self, other: Self) -> Self::CrossProduct;
    /// The largest absolute coordinate.
    fn max_abs(self) -> f64;
    /// The component-wise minimum.
    fn min(self, other: Self) -> Self;
    /// The component-wise maximum.
    fn max(self, other: Self) -> Self;
    /// The image of this point under an affine map.
    fn transform(self, map: &Self::Affine) -> Self;
    /// The numerator and the denominator of the image of this point under a projective map.
    fn project(self, map: &Self::Projective) -> (Self, f64);
    /// The normal of a unit tangent: the tangent rotated by +90° in the plane; in space the normalized component of
    /// `bend` perpendicular to the tangent (zero if there is none).
    fn normal_of(tangent: Self, bend: Self) -> Self;

    /// (1 − t)·self + t·other, exact at both ends; cannot overflow for t in [0, 1].
    #[inline]
    fn lerp(self, other: Self, t: f64) -> Self {
        self * (1.0 - t) + other * t
    }

    /// The Euclidean distance of two points.
    #[inline]
    fn distance(self, other: Self) -> f64 {
        Point::norm(self - other)
    }

    /// The Euclidean length; it overflows or underflows only if the true value does.
    #[inline]
    fn norm(self) -> f64 {
        let square = self.dot(self);
        if (1e-280..1e280).contains(&square) {
            return square.sqrt();
        }
        let scale = self.max_abs();
        if scale == 0.0 {
            return 0.0;
        }
        let unit = self / scale;
        unit.dot(unit).sqrt() * scale
    }

    /// The vector of length 1 in this direction; zero for the zero vector.
    #[inline]
    fn unit(self) -> Self {
        let scale = self.max_abs();
        if scale == 0.0 {
            return Self::default();
        }
        let direction = self / scale;
        direction / direction.dot(direction).sqrt()
    }

    /// Whether every coordinate is finite.
    #[inline]
    fn is_finite(self) -> bool {
        self.max_abs().is_finite()
    }
}

/// The result of a cross product; the algorithms use only its size and linear combinations.
pub trait CrossProduct: Copy + Debug + Add<Output = Self> + Mul<f64, Output = Self> {
    /// The size: absolute value or length.
    fn size(self) -> f64;
    /// The sign of the curvature: ±1 in the plane, 1 in space.
    fn curvature_sign(self) -> f64;
    /// The square of the size.
    fn size_squared(self) -> f64;
    /// The scalar product.
    fn dot(self, other: Self) -> f64;
}

impl CrossProduct for f64 {
    #[inline]
    fn size(self) -> f64 {
        self.abs()
    }
    #[inline]
    fn curvature_sign(self) -> f64 {
        if self < 0.0 { -1.0 } else { 1.0 }
    }
    #[inline]
    fn size_squared(self) -> f64 {
        self * self
    }
    #[inline]
    fn dot(self, other: Self) -> f64 {
        self * other
    }
}

impl CrossProduct for DVec3 {
    #[inline]
    fn size(self) -> f64 {
        Point::norm(self)
    }
    #[inline]
    fn curvature_sign(self) -> f64 {
        1.0
    }
    #[inline]
    fn size_squared(self) -> f64 {
        self.length_squared()
    }
    #[inline]
    fn dot(self, other: Self) -> f64 {
        DVec3::dot(self, other)
    }
}

impl Point for DVec2 {
    const DIMENSION: usize = 2;
    const ZERO: Self = DVec2::ZERO;
    type Affine = DAffine2;
    type Projective = DMat3;
    type CrossProduct = f64;

    #[inline]
    fn splat(value: f64) -> Self {
        DVec2::splat(value)
    }
    #[inline]
    fn to_3d(self) -> DVec3 {
        self.extend(0.0)
    }
    #[inline]
    fn to_2d(self) -> DVec2 {
        self
    }
    #[inline]
    fn coordinate(self, axis: usize) -> f64 {
        if axis == 0 { self.x } else { self.y }
    }
    #[inline]
    fn with_coordinate(self, axis: usize, value: f64) -> Self {
        if axis == 0 {
            Self::new(value, self.y)
        } else {
            Self::new(self.x, value)
        }
    }
    #[inline]
    fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }
    #[inline]
    fn cross(self, other: Self) -> f64 {
        self.perp_dot(other)
    }
    #[inline]
    fn max_abs(self) -> f64 {
        nan_max(self.x.abs(), self.y.abs())
    }
    #[inline]
    fn min(self, other: Self) -> Self {
        DVec2::min(self, other)
    }
    #[inline]
    fn max(self, other: Self) -> Self {
        DVec2::max(self, other)
    }
    #[inline]
    fn transform(self, map: &DAffine2) -> Self {
        map.transform_point2(self)
    }
    #[inline]
    fn project(self, map: &DMat3) -> (Self, f64) {
        let image = *map * self.extend(1.0);
        (image.truncate(), image.z)
    }
    #[inline]
    fn normal_of(tangent: Self, _bend: Self) -> Self {
        // 0 − y, so that a zero tangent does not become a normal of −0.
        DVec2::new(0.0 - tangent.y, tangent.x)
    }
}

impl Point for DVec3 {
    const DIMENSION: usize = 3;
    const ZERO: Self = DVec3::ZERO;
    type Affine = DAffine3;
    type Projective = DMat4;
    type CrossProduct = DVec3;

    #[inline]
    fn splat(value: f64) -> Self {
        DVec3::splat(value)
    }
    #[inline]
    fn to_3d(self) -> DVec3 {
        self
    }
    #[inline]
    fn to_2d(self) -> DVec2 {
        self.truncate()
    }
    #[inline]
    fn coordinate(self, axis: usize) -> f64 {
        match axis {
            0 => self.x,
            1 => self.y,
            _ => self.z,
        }
    }
    #[inline]
    fn with_coordinate(mut self, axis: usize, value: f64) -> Self {
        self[axis.min(2)] = value;
        self
    }
    #[inline]
    fn dot(self, other: Self) -> f64 {
        DVec3::dot(self, other)
    }
    #[inline]
    fn cross(self, other: Self) -> DVec3 {
        DVec3::cross(self, other)
    }
    #[inline]
    fn max_abs(self) -> f64 {
        nan_max(nan_max(self.x.abs(), self.y.abs()), self.z.abs())
    }
    #[inline]
    fn min(self, other: Self) -> Self {
        DVec3::min(self, other)
    }
    #[inline]
    fn max(self, other: Self) -> Self {
        DVec3::max(self, other)
    }
    #[inline]
    fn transform(self, map: &DAffine3) -> Self {
        map.transform_point3(self)
    }
    #[inline]
    fn project(self, map: &DMat4) -> (Self, f64) {
        let image = *map * self.extend(1.0);
        (image.truncate(), image.w)
    }
    #[inline]
    fn normal_of(tangent: Self, bend: Self) -> Self {
        let across = |v: Self| Point::unit(v - tangent * v.dot(tangent));
        // If `bend` is almost parallel to the tangent, rounding leaves a component along the tangent; a second
        // projection removes it ("twice is enough", Kahan).
        across(across(Point::unit(bend)))
    }
}

/// The larger of two numbers, or NaN if either is NaN (`f64::max` would ignore it).
#[inline]
fn nan_max(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}
