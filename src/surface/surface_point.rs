//! Points that queries of surfaces find.

use crate::geometry::point::Point;
use crate::patch::Patch;
use crate::patch::patch_point::PatchPoint;
use glam::DVec3;

/// A point of a surface, found by a question.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct SurfacePoint {
    /// The number of the patch.
    pub patch: usize,
    /// The parameters on it, from 0 to 1.
    pub u: f64,
    /// See `u`.
    pub v: f64,
    /// The point of the surface.
    pub point: DVec3,
    /// Its distance from the point that was asked for, or from the ray's origin.
    pub distance: f64,
}

impl SurfacePoint {
    /// The point at (u, v) of a patch, asked for from p.
    pub(crate) fn at(on: &Patch, patch: usize, u: f64, v: f64, p: DVec3) -> Self {
        let point = on.eval(u, v);
        Self {
            patch,
            u,
            v,
            point,
            distance: Point::length(point * 0.5 - p * 0.5) * 2.0,
        }
    }

    /// The same on its patch.
    pub(crate) fn on_patch(self) -> PatchPoint {
        PatchPoint {
            u: self.u,
            v: self.v,
            point: self.point,
            distance: self.distance,
        }
    }
}
