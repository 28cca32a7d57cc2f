//! Where do two curves meet?
//!
//! [`pair`] moves both curves to the origin and to size 1, so that one small distance, the slack, says what rounding may
//! have moved. The search in `kernels/src/clipping` cuts the curves down to crossings and to zones of contact; [`interval`] joins
//! what belongs together and [`classify`] says what an interval is: a tangency, a shared piece, or crossings too close for the
//! search.

mod classify;
mod contact_interval;
mod exact;
pub(crate) mod intersection;
mod near;
mod pair;
mod pieces;
mod selves;
mod solve;

pub use intersection::{Intersection, IntersectionKind, SelfIntersection};

use super::Curve;
use glam::DVec2;
use pair::NormalizedPair;

impl Curve<DVec2> {
    /// All places that this curve shares with another one, sorted by t, then by u.
    ///
    /// A(t) = B(u) with t and u in [0, 1]; ends count. Each place comes once for each pair of parameters: where a curve
    /// passes a point twice, two. A shared piece is one [`IntersectionKind::Overlap`] with its two ends.
    ///
    /// Curves count as meeting where they are closer than rounding can tell: some (n + 2)·1e-15 of the largest coordinate,
    /// n being the higher degree, also where the curves are small and far from the origin. So two crossings closer
    /// together than about 1e-8 of the curves' size come back as one tangency. A(t) and B(u) are at most 64 (n + 2) ulps of
    /// the largest coordinate apart.
    ///
    /// At most 4096 pairs of pieces are looked at, and 256 more for each degree above 3, at a cost of the square of the
    /// degree each. Only curves that rounding makes hard to tell apart on long stretches need more: what is undecided then
    /// is not cut any further, and each such pair of pieces counts as one place at most.
    ///
    /// Source: Sederberg and Nishita, "Curve intersection using Bézier clipping", CAD 22 (1990), for what crosses.
    pub fn intersections(&self, other: &Self) -> Vec<Intersection> {
        NormalizedPair::new(&self.points, &other.points)
            .map_or_else(Vec::new, |pair| pair.solve(self, other))
    }
}
