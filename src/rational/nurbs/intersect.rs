//! Intersections of NURBS curves in the plane.

use super::NurbsCurve;
use crate::curve::{Intersection, IntersectionKind, SelfIntersection};
use crate::numeric::float::whole_and_rest;
use crate::rational::RationalCurve;
use crate::rational::intersect::sorted;
use crate::spline::spline_set::SplineSet;
use glam::DVec2;

impl NurbsCurve<DVec2> {
    /// All intersections with another curve, sorted by t, then by u, which are in the domains.
    ///
    /// Pairs of segments are found with a tree of bounding boxes, and intersect as by [`RationalCurve::intersections`]. An
    /// intersection at a joint is reported once, and so is one at the start of a curve of several segments that ends there, as
    /// a circle does; overlaps that continue across joints are one; see
    /// [`Spline::intersections`](crate::Spline::intersections). Lines, Bézier curves and splines convert with `From`.
    ///
    /// ```
    /// use casteljau::{Curve, NurbsCurve, glam::DVec2};
    ///
    /// let circle = NurbsCurve::circle(DVec2::ZERO, 5.0)?;
    /// let line = Curve::line(DVec2::new(3.0, -9.0), DVec2::new(3.0, 9.0));
    /// let ys: Vec<f64> = circle.intersections(&(&line).into()).iter().map(|found| found.point.y).collect();
    /// assert_eq!(ys.len(), 2);
    /// assert!((ys[0] - 4.0).abs() < 1e-14 && (ys[1] + 4.0).abs() < 1e-14);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn intersections(&self, other: &Self) -> Vec<Intersection> {
        let set = |curve: &Self| {
            let ends_at_start = curve.segments.len() > 1 && curve.start() == curve.end();
            curve.set(curve.closed || ends_at_start)
        };
        let found = set(self).intersections_with(&set(other));
        let at = |mut at: Intersection| {
            (at.t, at.u) = (self.time_of(at.t), other.time_of(at.u));
            if let IntersectionKind::Overlap { t_end, u_end } = &mut at.kind {
                (*t_end, *u_end) = (self.time_of(*t_end), other.time_of(*u_end));
            }
            at
        };
        sorted(found.into_iter().map(|found| at(found.at)).collect())
    }

    /// The points that the curve passes twice, sorted by t; t < u. The joint of neighbouring segments does not count, nor
    /// does the start of a closed curve. An open curve that ends where it starts has a self-intersection there.
    pub fn self_intersections(&self) -> Vec<SelfIntersection> {
        let found = self.set(self.closed).intersections_within();
        let at = |Intersection { t, u, point, .. }| SelfIntersection {
            t: self.time_of(t),
            u: self.time_of(u),
            point,
        };
        found.into_iter().map(|found| at(found.at)).collect()
    }

    fn set(&self, closed: bool) -> SplineSet<RationalCurve<DVec2>> {
        SplineSet::of_segments(self.segments.clone(), closed)
    }

    /// The t of a position that counts segments.
    fn time_of(&self, position: f64) -> f64 {
        let (k, s) = whole_and_rest(position, self.segments.len() - 1);
        self.time(k, s)
    }
}
