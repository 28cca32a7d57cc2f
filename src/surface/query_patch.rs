//! What queries need to know of a patch, which is polynomial or rational.

use crate::geometry::bounds::Bounds;
use crate::patch::patch_point::PatchPoint;
use glam::DVec3;

/// A patch S = A/w, where w is 1 for a polynomial one.
pub(crate) trait QueryPatch: Send + Sync {
    fn eval(&self, u: f64, v: f64) -> DVec3;

    fn normal(&self, u: f64, v: f64) -> DVec3;

    fn control_bounds(&self) -> Bounds<DVec3>;

    /// The length of a row of the net.
    fn columns(&self) -> usize;

    /// The control points of A; `local` maps the control points of S to other coordinates. The largest weight is 1 to 2.
    fn numerator(&self, local: &dyn Fn(DVec3) -> DVec3) -> Vec<DVec3>;

    /// The nearest point to p, if its distance is at most a small `reach`.
    fn nearest_within(&self, p: DVec3, reach: f64) -> Option<PatchPoint>;
}
