//! The result types of curve intersection.

use glam::DVec2;

/// An intersection of two curves.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Intersection {
    /// The parameter on the first curve; for an overlap, of its start.
    pub t: f64,
    /// The parameter on the second curve.
    pub u: f64,
    /// The point of intersection.
    pub point: DVec2,
    /// The kind of the intersection.
    pub kind: IntersectionKind,
}

/// The kind of an intersection of two curves.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case", rename_all_fields = "camelCase")
)]
pub enum IntersectionKind {
    /// The curves cross at an angle. An end point that lies on the other curve also has this kind, and so has a curve
    /// that is a point.
    Cross,
    /// The curves have the same or opposite directions.
    Tangent,
    /// The curves share a segment from (t, u) to (`t_end`, `u_end`). u decreases if the curves have opposite
    /// directions.
    Overlap {
        /// The parameter on the first curve at the end of the overlap.
        t_end: f64,
        /// The parameter on the second curve at the end of the overlap.
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
    /// The parameter of the first pass.
    pub t: f64,
    /// The parameter of the second pass; t < u.
    pub u: f64,
    /// The point.
    pub point: DVec2,
}
