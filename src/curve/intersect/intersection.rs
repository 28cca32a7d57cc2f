//! What intersections of curves are reported as.

use glam::DVec2;

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
