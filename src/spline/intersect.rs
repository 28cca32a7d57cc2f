//! Intersections and self-intersections of splines.

use super::Spline;
use super::spline_set::{SplineIntersection, SplineSet};
use crate::curve::Curve;
use crate::curve::intersect::intersection::{Intersection, SelfIntersection};
use glam::DVec2;

impl Spline<DVec2> {
    /// All intersections with another spline, sorted by t, then by u.
    ///
    /// As [`Curve::intersections`], with t and u from 0 to the numbers of segments. An intersection at a joint of the
    /// other spline is reported once, with the kind [`Tangent`](crate::curve::IntersectionKind::Tangent) if either of
    /// the curves at the joint touches; at the start of a closed spline t or u is 0. An overlap that continues across
    /// joints is reported once, except across the start of a closed spline.
    ///
    /// Pairs of curves are found with a tree of bounding boxes: for long splines the time is about n log n in the
    /// number n of curves. Each pair of curves whose boxes overlap (in the worst case all pairs) costs one curve-curve
    /// intersection, with the same limit.
    pub fn intersections(&self, other: &Self) -> Vec<Intersection> {
        intersections_of(SplineSet::new([self]).intersections_with(&SplineSet::new([other])))
    }

    /// All intersections with a curve; see [`intersections`](Self::intersections).
    pub fn intersections_with_curve(&self, other: &Curve<DVec2>) -> Vec<Intersection> {
        intersections_of(SplineSet::new([self]).intersections_with(&SplineSet::of_curve(other)))
    }

    /// The self-intersections of the spline, sorted by t; t < u.
    ///
    /// As [`Curve::self_intersections`]. The shared point of neighbouring segments does not count, nor does the start
    /// of a closed spline. An open spline that ends at its start has a self-intersection there.
    pub fn self_intersections(&self) -> Vec<SelfIntersection> {
        let found = SplineSet::new([self]).intersections_within();
        let self_intersection = |m: SplineIntersection| SelfIntersection {
            t: m.at.t,
            u: m.at.u,
            point: m.at.point,
        };
        found.into_iter().map(self_intersection).collect()
    }
}

impl Curve<DVec2> {
    /// All intersections with a spline; u is the parameter of the spline. See [`Spline::intersections`].
    pub fn intersections_with_spline(&self, other: &Spline<DVec2>) -> Vec<Intersection> {
        intersections_of(SplineSet::of_curve(self).intersections_with(&SplineSet::new([other])))
    }
}

fn intersections_of(found: Vec<SplineIntersection>) -> Vec<Intersection> {
    found.into_iter().map(|crossing| crossing.at).collect()
}
