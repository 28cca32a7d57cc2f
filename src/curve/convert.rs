//! Constructors of lines, quadratics and cubics, and affine maps as factors.

use super::Curve;
use crate::geometry::check::{expect_image, is_within_limit};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::list::points_of;
use glam::{DAffine2, DAffine3, DVec2, DVec3};
use std::ops::Mul;

impl<P: Point> Curve<P> {
    /// The line segment from `p0` to `p1`, of degree 1.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let line = Curve::line(DVec2::ZERO, DVec2::new(4.0, 2.0));
    /// assert_eq!(line.eval(0.5), DVec2::new(2.0, 1.0));
    /// ```
    ///
    /// # Panics
    /// If a coordinate is NaN, infinite or beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE). [`Curve::new`] returns an error instead.
    #[track_caller]
    pub fn line(p0: P, p1: P) -> Self {
        Self::of_finite([p0, p1])
    }

    /// The quadratic curve with three control points.
    ///
    /// # Panics
    /// If a coordinate is NaN, infinite or beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE). [`Curve::new`] returns an error instead.
    #[track_caller]
    pub fn quad(p0: P, p1: P, p2: P) -> Self {
        Self::of_finite([p0, p1, p2])
    }

    /// The cubic curve with four control points.
    ///
    /// # Panics
    /// If a coordinate is NaN, infinite or beyond [`MAX_COORDINATE`](crate::MAX_COORDINATE). [`Curve::new`] returns an error instead.
    #[track_caller]
    pub fn cubic(p0: P, p1: P, p2: P, p3: P) -> Self {
        Self::of_finite([p0, p1, p2, p3])
    }

    #[track_caller]
    fn of_finite<const N: usize>(points: [P; N]) -> Self {
        for (index, point) in points.iter().enumerate() {
            assert!(
                is_within_limit(*point),
                "p{index}: expected coordinates from -2^500 to 2^500, got {point:?}"
            );
        }
        Self {
            points: points_of(&points),
        }
    }
}

impl<P: Point, const N: usize> TryFrom<[P; N]> for Curve<P> {
    type Error = Error;

    /// Same as [`Curve::new`].
    fn try_from(points: [P; N]) -> Result<Self, Error> {
        Self::new(&points)
    }
}

impl Mul<Curve<DVec2>> for DAffine2 {
    type Output = Curve<DVec2>;

    /// The image of the curve; same as [`Curve::transform`].
    ///
    /// # Panics
    /// If the image is not finite, because an operator cannot return an error.
    #[track_caller]
    fn mul(self, curve: Curve<DVec2>) -> Curve<DVec2> {
        self * &curve
    }
}

impl Mul<&Curve<DVec2>> for DAffine2 {
    type Output = Curve<DVec2>;

    /// The image of the curve; same as [`Curve::transform`].
    ///
    /// # Panics
    /// If the image is not finite, because an operator cannot return an error.
    #[track_caller]
    fn mul(self, curve: &Curve<DVec2>) -> Curve<DVec2> {
        expect_image(curve.transform(&self))
    }
}

impl Mul<&Curve<DVec3>> for DAffine3 {
    type Output = Curve<DVec3>;

    /// The image of the curve; same as [`Curve::transform`].
    ///
    /// # Panics
    /// If the image is not finite, because an operator cannot return an error.
    #[track_caller]
    fn mul(self, curve: &Curve<DVec3>) -> Curve<DVec3> {
        expect_image(curve.transform(&self))
    }
}
