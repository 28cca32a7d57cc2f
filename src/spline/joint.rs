//! What a joint should be, and how one side is made to follow the other.

use crate::point::Point;

/// What is to be kept at a joint while points move.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum JointMode {
    /// Nothing but the common point.
    #[default]
    Free,
    /// The handles stay aligned; each keeps its length.
    G1,
    /// The derivatives stay equal: for equal degrees, handles of equal length.
    C1,
}

impl JointMode {
    /// The handle on the far side of a joint that goes with the one on the near side.
    ///
    /// G1: P₃ + |P₄ − P₃| · unit(P₃ − P₂). C1: P₃ + r (P₃ − P₂), where r is the degree of the near segment over that of
    /// the far one. A handle of length zero has no direction: the other is then left alone (G1).
    pub(crate) fn follow<P: Point>(self, near: P, joint: P, far: P, degree_ratio: f64) -> P {
        match self {
            Self::Free => far,
            Self::G1 if near == joint || far == joint => far,
            Self::G1 => joint + (joint - near).unit() * (far - joint).norm(),
            Self::C1 => joint + (joint - near) * degree_ratio,
        }
    }
}
