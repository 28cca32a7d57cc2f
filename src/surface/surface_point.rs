//! Results of point queries on surfaces.

use super::query_patch::QueryPatch;
use crate::geometry::point::Point;
use crate::patch::patch_point::PatchPoint;
use glam::DVec3;

/// A point of a surface, returned by a query.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct SurfacePoint {
    /// The index of the patch.
    pub patch: usize,
    /// The parameters on the patch, from 0 to 1.
    pub u: f64,
    /// See `u`.
    pub v: f64,
    /// The point of the surface.
    pub point: DVec3,
    /// Its distance from the query point or from the ray's origin.
    pub distance: f64,
}

impl SurfacePoint {
    /// The point at (u, v) of a patch, with its distance from p.
    pub(crate) fn at(on: &impl QueryPatch, patch: usize, u: f64, v: f64, p: DVec3) -> Self {
        let point = on.eval(u, v);
        Self {
            patch,
            u,
            v,
            point,
            distance: Point::norm(point - p),
        }
    }

    /// The point without the index of its patch.
    pub(crate) fn on_patch(self) -> PatchPoint {
        PatchPoint {
            u: self.u,
            v: self.v,
            point: self.point,
            distance: self.distance,
        }
    }
}
