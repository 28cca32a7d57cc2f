//! Intersections and self-intersections of paths.

use super::{Path, PathTime};
use crate::curve::intersect::intersection::IntersectionKind;
use crate::spline::spline_set::{SplineIntersection, SplineSet};
use glam::DVec2;

/// An intersection of two paths.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct PathIntersection {
    /// The index of the subpath of the first path.
    pub subpath: usize,
    /// The parameter on it; for an overlap, the parameter of its start.
    pub t: f64,
    /// The index of the subpath of the second path.
    pub other_subpath: usize,
    /// The parameter on it at the same point.
    pub u: f64,
    /// The point.
    pub point: DVec2,
    /// The kind of contact.
    pub kind: IntersectionKind,
}

impl PathIntersection {
    /// The position on the first path.
    pub const fn time(&self) -> PathTime {
        PathTime::new(self.subpath, self.t)
    }

    /// The position on the second path.
    pub const fn other_time(&self) -> PathTime {
        PathTime::new(self.other_subpath, self.u)
    }
}

impl Path {
    /// All intersections with another path, sorted by the subpath of this path, the subpath of the other one, t and u.
    ///
    /// As [`Spline::intersections`](crate::Spline::intersections), for each pair of subpaths; the lines that would
    /// close open subpaths do not count. A spline or a curve is converted to a path by `Path::from`. Pairs of curves
    /// are found with a tree of bounding boxes: for long paths the time is about n log n in the number n of segments.
    /// In the worst case all boxes overlap and each pair of segments costs one
    /// [`Curve::intersections`](crate::Curve::intersections).
    pub fn intersections(&self, other: &Self) -> Vec<PathIntersection> {
        path_intersections(
            SplineSet::new(self.subpaths()).intersections_with(&SplineSet::new(other.subpaths())),
        )
    }

    /// The self-intersections of the path, on one subpath or on two; the smaller position of each pair comes first.
    ///
    /// As [`Spline::self_intersections`](crate::Spline::self_intersections), with the kind of contact. Overlaps are
    /// omitted.
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
