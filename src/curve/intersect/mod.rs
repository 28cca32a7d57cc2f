//! Where do two curves meet?
//!
//! [`pair`] moves both curves to the origin and to size 1, so that one small distance, the slack, says what rounding may
//! have moved. The search in `kernels/src/clipping` cuts the curves down to crossings and to zones of contact; [`interval`] joins
//! what belongs together and [`classify`] says what an interval is: a tangency, a shared piece, or crossings too close for the
//! search.

mod classify;
mod contact_interval;
mod exact;
mod near;
mod pair;
mod pieces;
mod selves;

use super::Curve;
use glam::DVec2;
use pair::NormalizedPair;

/// A place that two curves share.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Intersection {
    /// The parameter on the first curve; of an overlap that of its start.
    pub t: f64,
    /// The parameter on the second curve at the same place.
    pub u: f64,
    /// The point.
    pub point: DVec2,
    /// How they meet.
    pub kind: IntersectionKind,
}

/// How two curves meet.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case", rename_all_fields = "camelCase")
)]
pub enum IntersectionKind {
    /// At an angle. An end that lies on the other curve is of this kind too, and a curve that is a point.
    Cross,
    /// With the same direction or the opposite one.
    Tangent,
    /// They share a piece, from (t, u) to this place; u runs backwards where the curves do so against each other.
    Overlap {
        /// The parameter on the first curve at its end.
        t_end: f64,
        /// The parameter on the second curve there.
        u_end: f64,
    },
}

/// A point that a curve passes twice.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct SelfIntersection {
    /// The parameter of the first time.
    pub t: f64,
    /// The parameter of the second time; t < u.
    pub u: f64,
    /// The point.
    pub point: DVec2,
}

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
