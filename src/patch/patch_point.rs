//! Points that queries of patches find.

use glam::DVec3;

/// A point of a patch, found by a question.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct PatchPoint {
    /// The parameters, from 0 to 1.
    pub u: f64,
    /// See `u`.
    pub v: f64,
    /// The point S(u, v).
    pub point: DVec3,
    /// Its distance from the point that was asked for, or from the ray's origin.
    pub distance: f64,
}
