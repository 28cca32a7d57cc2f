//! What a joint should be, and how one side is made to follow the other.

use crate::geometry::point::Point;
use crate::numeric::float::ratio;

/// What is to be kept at a joint while points move.
///
/// P₀ … P₆ are the control points of two cubic segments, P₃ the joint. On segments of degree 1 or 2, where P₁ or P₅ is a
/// joint itself, C2 keeps what C1 keeps, G2 what G1 keeps, and automatic handles are not set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum JointMode {
    /// Nothing but the common point.
    #[default]
    Free,
    /// The handles stay aligned; each keeps its length.
    G1,
    /// The derivatives stay equal: for equal degrees, handles of equal length.
    C1,
    /// The second derivatives too: P₅ = P₁ + 4(P₃ − P₂).
    C2,
    /// Aligned, and of equal curvature: |P₄ − P₃| = |P₃ − P₂| · √(h₅/h₁), h the distances of P₁ and P₅ from the tangent. Where
    /// they lie on different sides, no length can do it: then as G1. In the plane only.
    G2,
    /// Both handles from the neighbouring joints: centripetal Catmull-Rom.
    Auto,
}

impl JointMode {
    /// Whether the second point from the joint has a say.
    pub(crate) fn is_second_order(self) -> bool {
        matches!(self, Self::C2 | Self::G2)
    }

    /// What is left of a mode where the second points are joints or the same.
    pub(crate) fn of_first_order(self) -> Self {
        match self {
            Self::C2 => Self::C1,
            Self::G2 => Self::G1,
            _ => self,
        }
    }
}

/// The points on both sides of a joint, as they are: near the moved point, and far of it. The second ones are no joints
/// only where their segment has at least degree 3.
#[derive(Clone, Copy)]
pub(crate) struct Sides<P> {
    pub(crate) near: [P; 2],
    pub(crate) joint: P,
    pub(crate) far: [P; 2],
    pub(crate) near_degree: usize,
    pub(crate) far_degree: usize,
}

impl<P: Point> Sides<P> {
    /// Whether both segments have two points of their own beside the joint.
    pub(crate) fn are_cubic(&self) -> bool {
        self.near_degree > 2 && self.far_degree > 2
    }

    /// The handle on the far side that goes with the near one.
    ///
    /// G1: P₃ + |P₄ − P₃| · unit(P₃ − P₂). C1: P₃ + r (P₃ − P₂), where r is the degree of the near segment over that of the
    /// far one. A handle of length zero has no direction: the other is then left alone.
    pub(crate) fn follow(&self, mode: JointMode) -> P {
        let ([near, _], joint, [far, _]) = (self.near, self.joint, self.far);
        let aligned = || joint + (joint - near).normalize_or_zero() * (far - joint).length();
        match mode {
            JointMode::Free | JointMode::Auto => far,
            JointMode::C1 | JointMode::C2 => {
                joint + (joint - near) * ratio(self.near_degree, self.far_degree)
            }
            JointMode::G1 | JointMode::G2 if near == joint => far,
            JointMode::G2 => self.with_equal_curvature().unwrap_or_else(aligned),
            JointMode::G1 if far == joint => far,
            JointMode::G1 => aligned(),
        }
    }

    /// The second point on the far side, for equal second derivatives:
    /// (1 − s) P₃ + s P₁ + 2(r + s)(P₃ − P₂), where r is the ratio of the degrees n/m and s that of n(n − 1) and m(m − 1).
    pub(crate) fn second(&self) -> P {
        let (n, m) = (self.near_degree, self.far_degree);
        let (r, s) = (ratio(n, m), ratio(n * (n - 1), m * (m - 1)));
        let [near, second] = self.near;
        let pulled = second * s + (self.joint - near) * (2.0 * (r + s));
        if s == 1.0 {
            pulled
        } else {
            pulled + self.joint * (1.0 - s)
        }
    }

    /// The far handle that makes the curvatures equal; none where that is no question of its length.
    fn with_equal_curvature(&self) -> Option<P> {
        let along = (self.joint - self.near[0]).normalize_or_zero();
        // From the joint: the parts across the tangent.
        let across = |p: P| (p - self.joint) - along * (p - self.joint).dot(along);
        let (before, after) = (across(self.near[1]), across(self.far[1]));
        let (h1, h5) = (before.length(), after.length());
        // A distance as small as the rounding of what it was computed from is none.
        let size = |points: &[P]| points.iter().map(|p| p.max_abs()).fold(0.0, f64::max);
        let largest = size(&self.near)
            .max(size(&self.far))
            .max(self.joint.max_abs());
        let none = 8.0 * f64::EPSILON * largest;
        if h1 <= none
            || h5 <= none
            || before.normalize_or_zero().dot(after.normalize_or_zero()) <= 0.0
        {
            return None;
        }
        // Curvatures are (n − 1)/n · h/length².
        let (n, m) = (self.near_degree, self.far_degree);
        let curvature_ratio = ratio((m - 1) * n, m * (n - 1)).sqrt() * (h5.sqrt() / h1.sqrt());
        Some(self.joint + along * ((self.joint - self.near[0]).length() * curvature_ratio))
    }
}

/// The derivatives of a Catmull-Rom curve at a point, of the segment after it and of the one before.
///
/// With d₁ and d₂ the steps of the parameter before and after the point, T = (P₁ − P₀)/d₁ − (P₂ − P₀)/(d₁ + d₂) +
/// (P₂ − P₁)/d₂, and the derivatives by the segments' own parameters, which run from 0 to 1, are T d₂ and T d₁. A step of
/// zero has no say: the point is then as an end is, and the other side starts straight.
///
/// Source: Yuksel, Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves", 2011.
pub(crate) fn catmull_rom<P: Point>([before, point, after]: [P; 3], [d1, d2]: [f64; 2]) -> (P, P) {
    let (arrival, departure) = (point - before, after - point);
    if d1 == 0.0 || d2 == 0.0 {
        return (departure, arrival);
    }
    let (u, v) = (d1 / (d1 + d2), d2 / (d1 + d2));
    (
        (arrival / d1) * (v * d2) + departure * u,
        arrival * v + (departure / d2) * (u * d1),
    )
}
