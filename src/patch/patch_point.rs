//! Results of point queries on patches.

use glam::DVec3;

/// A point of a patch, returned by a query.
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
    /// Its distance from the query point or from the ray's origin.
    pub distance: f64,
}
