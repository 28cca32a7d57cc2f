//! Where does a spline meet others, and itself?

use super::Spline;
use super::spline_set::{SplineIntersection, SplineSet};
use crate::curve::Curve;
use crate::curve::intersect::intersection::{Intersection, SelfIntersection};
use glam::DVec2;

impl Spline<DVec2> {
    /// All places that this spline shares with another one, sorted by t, then by u.
    ///
    /// As [`Curve::intersections`], with t and u from 0 to the numbers of segments. A joint on the other spline is one
    /// place, of the kind [`Tangent`](crate::curve::IntersectionKind::Tangent) if either of its curves touches there; t or u of a
    /// closed spline's start is 0. A shared piece that runs across joints is one, except across the start of a closed
    /// spline.
    ///
    /// Pairs of curves are found by a tree of boxes: long chains take hardly more than their number times its logarithm.
    /// Each pair of curves whose boxes meet, at worst all, costs what it would on its own, with the same limit.
    pub fn intersections(&self, other: &Self) -> Vec<Intersection> {
        intersections_of(SplineSet::new([self]).intersections_with(&SplineSet::new([other])))
    }

    /// All places that this spline shares with a curve; see [`intersections`](Self::intersections).
    pub fn intersections_with_curve(&self, other: &Curve<DVec2>) -> Vec<Intersection> {
        intersections_of(SplineSet::new([self]).intersections_with(&SplineSet::of_curve(other)))
    }

    /// The points that the spline passes twice, sorted by t; t < u.
    ///
    /// As [`Curve::self_intersections`]: neighbours meeting at their joint are no such point, and neither is the start of
    /// a closed spline, where it ends. An open spline that ends where it starts passes that point twice.
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
    /// All places that this curve shares with a spline; u is the spline's t. See [`Spline::intersections`].
    pub fn intersections_with_spline(&self, other: &Spline<DVec2>) -> Vec<Intersection> {
        intersections_of(SplineSet::of_curve(self).intersections_with(&SplineSet::new([other])))
    }
}

fn intersections_of(found: Vec<SplineIntersection>) -> Vec<Intersection> {
    found.into_iter().map(|crossing| crossing.at).collect()
}
