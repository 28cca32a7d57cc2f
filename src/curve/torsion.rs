//! Torsion of curves in space.

use super::Curve;
use super::derivative::VANISHING_RATIO;
use crate::geometry::point::{CrossProduct, Point};
use std::cmp::Ordering;

impl<P: Point> Curve<P> {
    /// The torsion τ = (B′ × B″)·B‴ / |B′ × B″|² at t, in 1 / unit of length.
    ///
    /// The rate per unit of arc length at which the osculating plane rotates about the tangent, positive for a
    /// right-handed screw. It is 0 in the plane, and for a plane or straight curve in space. Where B′ × B″ vanishes (an
    /// inflection, a zero-length handle, a cusp) it is the limit, which is finite where B′ is not zero, and may be
    /// infinite where B′ is zero. Source: Farin, *Curves and Surfaces for CAGD*, §11.2; the limit by Taylor's theorem.
    pub fn torsion(&self, t: f64) -> f64 {
        if P::DIMENSION == 2 {
            return 0.0;
        }
        let Some(local) = self.taylor(t) else {
            return 0.0;
        };
        let Some(bend) = local.bend() else {
            return 0.0;
        };
        let term = |order: usize| local.coefficients[order - 1];
        let plane = term(local.first).to_3d().cross(term(bend).to_3d());
        let out_of_plane = |&order: &usize| {
            let later = term(order);
            plane.dot(later.to_3d()).abs() > VANISHING_RATIO * plane.size() * later.norm()
        };
        let Some(twist) = (bend + 1..=self.degree()).find(out_of_plane) else {
            return 0.0;
        };
        // With B ≈ A tᵃ + C tᵇ + E tᶜ the torsion is
        // det(A, C, E)/|A×C|² · c(c−a)(c−b)/(ab(b−a)) · t to the power c − a − b.
        let [a, b, c] = [local.first, bend, twist].map(|order| order as f64);
        let size = plane.size();
        let part = (plane / size).dot(term(twist).to_3d()) / size;
        match twist.cmp(&(local.first + bend)) {
            Ordering::Greater => 0.0,
            Ordering::Equal => part * (c * (c - a) * (c - b) / (a * b * (b - a))) / local.scale,
            Ordering::Less => {
                let turned = local.from_left && !(local.first + bend + twist).is_multiple_of(2);
                f64::INFINITY.copysign(if turned { -part } else { part })
            }
        }
    }
}
