//! Conversion of curves to splines, and multiplication of affine maps by splines.

use super::Spline;
use crate::curve::Curve;
use crate::geometry::check::expect_image;
use crate::geometry::point::Point;
use glam::{DAffine2, DAffine3, DVec2, DVec3};
use std::ops::Mul;

impl<P: Point> From<Curve<P>> for Spline<P> {
    /// An open spline with one segment.
    fn from(curve: Curve<P>) -> Self {
        Self::from_parts(curve.control_points().to_vec(), &[curve.degree()], false)
    }
}

impl Mul<&Spline<DVec2>> for DAffine2 {
    type Output = Spline<DVec2>;

    /// The image of the spline under the map, as [`Spline::transform`] computes it.
    ///
    /// # Panics
    /// If the image is not finite, because an operator cannot return an error.
    #[track_caller]
    fn mul(self, spline: &Spline<DVec2>) -> Spline<DVec2> {
        expect_image(spline.transform(&self))
    }
}

impl Mul<&Spline<DVec3>> for DAffine3 {
    type Output = Spline<DVec3>;

    /// The image of the spline under the map, as [`Spline::transform`] computes it.
    ///
    /// # Panics
    /// If the image is not finite, because an operator cannot return an error.
    #[track_caller]
    fn mul(self, spline: &Spline<DVec3>) -> Spline<DVec3> {
        expect_image(spline.transform(&self))
    }
}
