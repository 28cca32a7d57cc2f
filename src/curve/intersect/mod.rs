//! Intersections of two curves.
//!
//! [`pair`] moves both curves to the origin and scales them to size 1, so that one small distance, the slack, bounds
//! the effect of rounding. The search in the kernels (`clipping`) cuts the curves down to crossings and to intervals of
//! contact; [`contact_interval`] joins contacts that belong together, and [`classify`] decides what an interval is: a
//! tangency, an overlap, or crossings that are too close for the search.

mod classify;
mod constants;
mod contact_interval;
mod exact;
pub(crate) mod intersection;
mod near;
pub(crate) mod pair;
pub(crate) mod plane_curve;
pub(crate) mod self_intersections;
mod solve;

pub use intersection::{Intersection, IntersectionKind, SelfIntersection};

use super::Curve;
use glam::DVec2;
use pair::{ClassifiedContact, NormalizedPair};

impl Curve<DVec2> {
    /// All intersections of this curve with another one, sorted by t, then by u.
    ///
    /// A(t) = B(u) with t and u in [0, 1], end points included. There is one entry for each pair of parameters: two
    /// where a curve passes a point twice. A shared segment is one [`IntersectionKind::Overlap`] with its two ends.
    ///
    /// Curves intersect where their distance is below rounding: about 2ε (L + (n + 1) S), where ε is 2.2e-16, L the
    /// largest coordinate, S the size of the box around both curves, and n the higher degree. It is at least 2 ulps of the
    /// largest coordinate, also if the curves are small and far from the origin. Curves that run along each other count
    /// as one up to four times this distance. So two crossings closer together than about 1e-8 of the size of the curves
    /// are reported as one tangency. A(t) and B(u) are at most 64 (n + 2) ulps of the largest coordinate apart.
    ///
    /// The search processes at most 4096 pairs of segments, and 256 more for each degree above 3; the cost of each is
    /// the square of the degree. Only curves that nearly coincide over long ranges need more. After the limit,
    /// undecided pairs of segments are not cut any further, and each of them gives at most one intersection.
    ///
    /// Source: Sederberg and Nishita, "Curve intersection using Bézier clipping", CAD 22 (1990), for crossings.
    pub fn intersections(&self, other: &Self) -> Vec<Intersection> {
        self.intersections_and_steps(other).0
    }

    /// All intersections with another curve, and the number of pairs of segments that the search processed.
    pub(crate) fn intersections_and_steps(&self, other: &Self) -> (Vec<Intersection>, usize) {
        let Some(pair) = NormalizedPair::new(self, other) else {
            return (Vec::new(), 0);
        };
        let (locations, steps) = pair.solve();
        let at = |location: ClassifiedContact| location.on(|t| self.eval(t), |u| other.eval(u));
        (locations.into_iter().map(at).collect(), steps)
    }
}
