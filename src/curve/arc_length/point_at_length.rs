//! Points at given arc lengths.

use crate::curve::Curve;
use crate::geometry::point::Point;
use crate::spline::Spline;

/// A point at a given arc length, with the tangent and the normal there.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct PointAtLength<P, T = f64> {
    /// The parameter; on a path, the subpath and the parameter on it.
    pub t: T,
    /// The point.
    pub point: P,
    /// The unit tangent; zero if the curve is a point.
    pub tangent: P,
    /// The unit normal.
    pub normal: P,
}

impl<P: Point> Curve<P> {
    /// The point at the arc length s from the start, with tangent and normal; see
    /// [`time_at_length`](Self::time_at_length).
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let line = Curve::line(DVec2::ZERO, DVec2::new(3.0, 4.0));
    /// let found = line.point_at_length(2.5);
    /// assert_eq!((found.t, found.point), (0.5, DVec2::new(1.5, 2.0)));
    /// ```
    pub fn point_at_length(&self, s: f64) -> PointAtLength<P> {
        let t = self.time_at_length(s);
        PointAtLength {
            t,
            point: self.eval(t),
            tangent: self.tangent(t),
            normal: self.normal(t),
        }
    }
}

impl<P: Point> Spline<P> {
    /// The point at the arc length s from the start, with tangent and normal; see
    /// [`time_at_length`](Self::time_at_length).
    pub fn point_at_length(&self, s: f64) -> PointAtLength<P> {
        let t = self.time_at_length(s);
        PointAtLength {
            t,
            point: self.eval(t),
            tangent: self.tangent(t),
            normal: self.normal(t),
        }
    }
}
