//! Flatness: a bound on the distance of a patch from the two triangles of its corners.

use super::Patch;
use super::net::{differences_u, differences_v};
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use glam::DVec3;

impl Patch {
    /// An upper bound on the distance of the patch from the two triangles that join its corners, for either diagonal.
    ///
    /// (M₁ + 2 M₂ + M₃)/8 with M₁ = m(m − 1) max|Δuu|, M₂ = m·n max|ΔuΔv| and M₃ = n(n − 1) max|Δvv|, which bound the
    /// second derivatives by the second differences of the net. The unit is length. The bound falls to a quarter when
    /// the patch is split in both directions. It is zero for a parallelogram whose control points lie on a regular
    /// grid. For unevenly spaced control points it is positive even if they lie in a plane, since it compares points of
    /// equal (u, v). The bilinear patch z = uv attains it. Source: Filip, Magedson and Markot, "Surface algorithms
    /// using bounds on derivatives", *Computer Aided Geometric Design* 3 (1986), 295–311.
    pub fn flatness(&self) -> f64 {
        let (m, n) = (as_f64(self.degree_u()), as_f64(self.degree_v()));
        let du = differences_u(&self.points, self.columns);
        let dv = differences_v(&self.points, self.columns);
        let fewer = self.columns - 1;
        let bound = m * (m - 1.0) * longest(&differences_u(&du, fewer))
            + 2.0 * m * n * longest(&differences_v(&du, fewer))
            + n * (n - 1.0) * longest(&differences_v(&dv, self.columns));
        bound / 8.0
    }
}

fn longest(vectors: &[DVec3]) -> f64 {
    vectors
        .iter()
        .fold(0.0, |max: f64, v| max.max(Point::norm(*v)))
}
