//! Where do paths meet?

use super::Path;
use crate::curve::intersect::intersection::IntersectionKind;
use crate::spline::spline_set::{SplineIntersection, SplineSet};
use glam::DVec2;

/// A place that two paths share.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct PathIntersection {
    /// The subpath of the first path.
    pub subpath: usize,
    /// The parameter on it; of an overlap that of its start.
    pub t: f64,
    /// The subpath of the second path.
    pub other_subpath: usize,
    /// The parameter on it, at the same place.
    pub u: f64,
    /// The point.
    pub point: DVec2,
    /// How they meet.
    pub kind: IntersectionKind,
}

impl Path {
    /// All places that this path shares with another one: sorted by subpath, then the other's, then t, then u.
    ///
    /// As [`Spline::intersections`](crate::Spline::intersections), for each pair of subpaths; the lines that would close open ones
    /// do not count. A spline or a curve becomes a path by `Path::from`. Pairs of curves are found by a tree of boxes: long
    /// paths take hardly more than their number of segments times its logarithm, and at worst, where all boxes meet, each
    /// segment is intersected with each, at the cost of [`Curve::intersections`](crate::Curve::intersections).
    pub fn intersections(&self, other: &Self) -> Vec<PathIntersection> {
        path_intersections(
            SplineSet::new(self.subpaths()).intersections_with(&SplineSet::new(other.subpaths())),
        )
    }

    /// The places that the path passes twice, on one subpath or on two: of each pair the earlier one first.
    ///
    /// As [`Spline::self_intersections`](crate::Spline::self_intersections); the kind is that of the contact. Pieces along
    /// which the path runs twice are left out.
    pub fn self_intersections(&self) -> Vec<PathIntersection> {
        path_intersections(SplineSet::new(self.subpaths()).intersections_within())
    }
}

fn path_intersections(found: Vec<SplineIntersection>) -> Vec<PathIntersection> {
    let intersection = |m: SplineIntersection| PathIntersection {
        subpath: m.a,
        t: m.at.t,
        other_subpath: m.b,
        u: m.at.u,
        point: m.at.point,
        kind: m.at.kind,
    };
    found.into_iter().map(intersection).collect()
}
