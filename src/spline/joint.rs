//! Joint modes, and the control points that satisfy them.

use crate::geometry::point::Point;
use crate::numeric::float::ratio;

/// The continuity that is enforced at a joint while points move.
///
/// P₀ … P₆ are the control points of two cubic segments; P₃ is the joint. If P₁ or P₅ is a joint itself (degree 1 or
/// 2), C2 acts as C1, G2 acts as G1, and automatic handles are not set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum JointMode {
    /// Only the common point (C0).
    #[default]
    Free,
    /// Aligned handles; each keeps its length.
    G1,
    /// Equal first derivatives: for equal degrees, handles of equal length.
    C1,
    /// Equal first and second derivatives: P₅ = P₁ + 4(P₃ − P₂).
    C2,
    /// Aligned handles and equal curvature: |P₄ − P₃| = |P₃ − P₂| · √(h₅/h₁), with h₁ and h₅ the distances of P₁ and P₅
    /// from the tangent. If P₁ and P₅ lie on different sides of the tangent no length satisfies it; the joint is then
    /// G1. Only in the plane.
    G2,
    /// Both handles computed from the neighbouring joints by the centripetal Catmull-Rom rule.
    Auto,
}

impl JointMode {
    /// Whether the mode depends on the second control point from the joint.
    pub(crate) fn is_second_order(self) -> bool {
        matches!(self, Self::C2 | Self::G2)
    }

    /// The mode that remains where the second control points are joints or coincide.
    pub(crate) fn of_first_order(self) -> Self {
        match self {
            Self::C2 => Self::C1,
            Self::G2 => Self::G1,
            _ => self,
        }
    }
}

/// The control points on both sides of a joint: `near` on the side of the moved point, `far` on the other side. If the
/// segment of a side has a degree below 3, the second point of that side is a joint or lies beyond the segment.
#[derive(Clone, Copy)]
pub(crate) struct Sides<P> {
    pub(crate) near: [P; 2],
    pub(crate) joint: P,
    pub(crate) far: [P; 2],
    pub(crate) near_degree: usize,
    pub(crate) far_degree: usize,
}

impl<P: Point> Sides<P> {
    /// Whether both segments have at least degree 3, so that each side has two control points that are not joints.
    pub(crate) fn are_cubic(&self) -> bool {
        self.near_degree > 2 && self.far_degree > 2
    }

    /// The handle on the far side that satisfies the mode for the given near handle.
    ///
    /// G1: P₃ + |P₄ − P₃| · unit(P₃ − P₂). C1: P₃ + r (P₃ − P₂), where r is the degree of the near segment divided by
    /// that of the far one. If the near handle has length zero it has no direction; the far handle is then unchanged.
    pub(crate) fn far_handle(&self, mode: JointMode) -> P {
        let ([near, _], joint, [far, _]) = (self.near, self.joint, self.far);
        let aligned = || joint + (joint - near).unit() * (far - joint).norm();
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

    /// The second control point on the far side for equal second derivatives: (1 − s) P₃ + s P₁ + 2(r + s)(P₃ − P₂),
    /// where r is the ratio n/m of the degrees and s the ratio n(n − 1) / (m(m − 1)).
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

    /// The far handle that gives equal curvatures; `None` if no handle length does.
    fn with_equal_curvature(&self) -> Option<P> {
        let along = (self.joint - self.near[0]).unit();
        // The component of P − P₃ that is perpendicular to the tangent.
        let across = |p: P| (p - self.joint) - along * (p - self.joint).dot(along);
        let (before, after) = (across(self.near[1]), across(self.far[1]));
        let (h1, h5) = (before.norm(), after.norm());
        // A distance within the rounding error of its operands counts as zero.
        let size = |points: &[P]| points.iter().map(|p| p.max_abs()).fold(0.0, f64::max);
        let largest = size(&self.near)
            .max(size(&self.far))
            .max(self.joint.max_abs());
        let none = 8.0 * f64::EPSILON * largest;
        if h1 <= none || h5 <= none || before.unit().dot(after.unit()) <= 0.0 {
            return None;
        }
        // The curvature is (n − 1)/n · h/length².
        let (n, m) = (self.near_degree, self.far_degree);
        let curvature_ratio = ratio((m - 1) * n, m * (n - 1)).sqrt() * (h5.sqrt() / h1.sqrt());
        Some(self.joint + along * ((self.joint - self.near[0]).norm() * curvature_ratio))
    }
}

/// The derivatives of a Catmull-Rom spline at a point: of the segment after it and of the segment before it.
///
/// With d₁ and d₂ the parameter steps before and after the point, T = (P₁ − P₀)/d₁ − (P₂ − P₀)/(d₁ + d₂) + (P₂ −
/// P₁)/d₂. The derivatives with respect to the local parameters of the segments, which run from 0 to 1, are T d₂ and T
/// d₁. If a step is zero, its side is ignored: the point is treated as an end, and the derivative on the other side is
/// the chord.
///
/// Source: Yuksel, Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves", 2011.
pub(crate) fn catmull_rom<P: Point>([before, point, after]: [P; 3], [d1, d2]: [f64; 2]) -> (P, P) {
    let (arrival, departure) = (point - before, after - point);
    if d1 == 0.0 || d2 == 0.0 {
        return (departure, arrival);
    }
    // T d₂ and T d₁ as sums of the two chords. All coefficients are positive, so they do not cancel.
    let (u, v) = (d1 / (d1 + d2), d2 / (d1 + d2));
    (
        (arrival / d1) * (v * d2) + departure * u,
        arrival * v + (departure / d2) * (u * d1),
    )
}
