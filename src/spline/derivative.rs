//! Derivatives, tangents, normals, curvature and torsion of a spline at a parameter.

use super::Spline;
use crate::geometry::point::Point;
use glam::DVec3;

impl<P: Point> Spline<P> {
    /// The k-th derivative at t, with respect to t; k = 0 is the point itself.
    ///
    /// t runs from 0 to the number of segments. At a joint the segment that starts there counts, at the end the last
    /// segment; values outside extrapolate the first and the last segment. The result is zero if k exceeds the degree
    /// of the segment.
    pub fn derivative_at(&self, t: f64, k: usize) -> P {
        let (segment, rest) = self.locate(t);
        self.curve(segment).derivative_at(rest, k)
    }

    /// The unit tangent at t; see [`Curve::tangent`](crate::Curve::tangent).
    ///
    /// At a joint the segment that starts there counts, at the end the last segment. Zero if the segment is a point.
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

    /// The unit normal at t; see [`Curve::normal`](crate::Curve::normal).
    ///
    /// In the plane it is the tangent turned by +90°; in space the principal normal, which is zero on straight
    /// segments.
    pub fn normal(&self, t: f64) -> P {
        let (segment, rest) = self.locate(t);
        self.curve(segment).normal(rest)
    }

    /// The curvature at t in 1 / unit of length; see [`Curve::curvature`](crate::Curve::curvature). Signed in the
    /// plane, nonnegative in space.
    ///
    /// It does not depend on the parametrization. At a joint the segment that starts there counts.
    pub fn curvature(&self, t: f64) -> f64 {
        let (segment, rest) = self.locate(t);
        self.curve(segment).curvature(rest)
    }
}

impl Spline<DVec3> {
    /// The torsion at t in 1 / unit of length; see [`Curve::torsion`](crate::Curve::torsion).
    pub fn torsion(&self, t: f64) -> f64 {
        let (segment, rest) = self.locate(t);
        self.curve(segment).torsion(rest)
    }
}
