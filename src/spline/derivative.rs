//! Derivatives, tangents, normals and curvature of a spline: those of the segment of t.

use super::Spline;
use crate::geometry::point::Point;
use glam::DVec3;

impl<P: Point> Spline<P> {
    /// The k-th derivative at t, with respect to t; k = 0 is the point itself.
    ///
    /// t runs from 0 to the number of segments. At a joint it is the derivative of the segment that starts there, at the
    /// end that of the last segment; values outside extrapolate the first and the last segment. Beyond the degree of the
    /// segment the result is zero.
    pub fn derivative_at(&self, t: f64, k: usize) -> P {
        let (segment, rest) = self.locate(t);
        self.curve(segment).derivative_at(rest, k)
    }

    /// The unit tangent at t, as [`Curve::tangent`](crate::Curve::tangent) gives it for the segment of t.
    ///
    /// At a joint it is the tangent of the segment that starts there, at the end that of the last segment. Zero where the
    /// segment is a point.
    ///
    /// ```
    /// use casteljau::{Spline, glam::DVec2};
    ///
    /// let corner = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0)].map(DVec2::from);
    /// let spline = Spline::new(&corner, 1, false)?;
    /// assert_eq!(spline.tangent(0.5), DVec2::X);
    /// assert_eq!(spline.tangent(1.0), DVec2::Y);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn tangent(&self, t: f64) -> P {
        let (segment, rest) = self.locate(t);
        self.curve(segment).tangent(rest)
    }

    /// The unit normal at t, as [`Curve::normal`](crate::Curve::normal) gives it for the segment of t.
    ///
    /// In the plane the tangent turned by +90°; in space the principal normal, which is zero on straight segments.
    pub fn normal(&self, t: f64) -> P {
        let (segment, rest) = self.locate(t);
        self.curve(segment).normal(rest)
    }

    /// The curvature at t in 1 / unit of length, as [`Curve::curvature`](crate::Curve::curvature) gives it for the segment
    /// of t: signed in the plane, not negative in space.
    ///
    /// It does not depend on how long a segment is in t. At a joint it is the curvature of the segment that starts there.
    pub fn curvature(&self, t: f64) -> f64 {
        let (segment, rest) = self.locate(t);
        self.curve(segment).curvature(rest)
    }
}

impl Spline<DVec3> {
    /// The torsion at t in 1 / unit of length, as [`Curve::torsion`](crate::Curve::torsion) gives it for the segment of t.
    pub fn torsion(&self, t: f64) -> f64 {
        let (segment, rest) = self.locate(t);
        self.curve(segment).torsion(rest)
    }
}
