//! Normalised coordinates of size 1, in which squares and products neither overflow nor underflow.

use super::query_patch::QueryPatch;
use crate::geometry::bounds::Bounds;
use crate::geometry::point::Point;
use crate::patch::Patch;
use glam::DVec3;

/// Smallest size of a scaling, as a fraction of its centre's coordinates. Points of a patch are off by a few ulps of the
/// coordinates, and tolerances are measured in ulps of the size.
const COARSE_SHARE: f64 = 1.0 / 8.0;

/// Maps points p to (p − centre)/size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scaling {
    pub(crate) centre: DVec3,
    /// Half of the longest side of the box; 1 for a box that is a point.
    pub(crate) size: f64,
}

impl Scaling {
    /// The scaling that maps a box to one from −1 to 1 along its longest side.
    pub(crate) fn around(bounds: Bounds<DVec3>) -> Self {
        let half = 0.5 * (bounds.max - bounds.min).max_abs();
        Self {
            centre: (bounds.min + bounds.max) * 0.5,
            // Below this size the reciprocal is not finite; a shape of that size counts as a point.
            size: if half < f64::MIN_POSITIVE * 8.0 {
                1.0
            } else {
                half
            },
        }
    }

    /// The scaling itself, or a larger one if its box is so far from the origin that the coordinates have larger rounding
    /// errors than the scaling resolves.
    pub(crate) fn as_coarse_as_its_coordinates(self) -> Self {
        let size = self.size.max(self.centre.max_abs() * COARSE_SHARE);
        Self { size, ..self }
    }

    /// A point in scaled coordinates.
    pub(crate) fn local_point(&self, p: DVec3) -> DVec3 {
        (p - self.centre) / self.size
    }

    /// A patch in scaled coordinates.
    pub(crate) fn image(&self, patch: &Patch) -> Patch {
        let points = patch.points.iter().map(|&p| self.local_point(p)).collect();
        Patch::from_net(points, patch.columns)
    }
}

/// The bounding box of the control points of patches; `None` without patches.
pub(crate) fn box_of(patches: &[impl QueryPatch]) -> Option<Bounds<DVec3>> {
    let boxes = patches.iter().map(QueryPatch::control_bounds);
    boxes.reduce(Bounds::union)
}
