//! The normal of rational patches, also where ∂u × ∂v vanishes.
//!
//! The normal has the direction of N = w(Au × Av) + wu(Av × A) + wv(A × Au), a polynomial of degrees 3m − 1 and 3n − 1
//! that does not depend on the origin. At a pole, the origin is the pole: then the rows of N at the collapsed edge are zero up
//! to rounding, and the first row that is not gives the limit. The last two terms matter where the first one vanishes to a
//! higher order, as at the tip of a surface of revolution whose profile is tangent to the axis there. Source: Saito, Wang and Sederberg, "Hodographs and normals
//! of rational curves and surfaces", CAGD 12 (1995).

use super::RationalPatch;
use crate::numeric::list::Net;
use crate::patch::net::{differences_u, differences_v, unit_size};
use crate::patch::normal::{NormalNet, weighted};
use glam::DVec3;

impl RationalPatch {
    /// The unit normal at (u, v): the direction of ∂S/∂u × ∂S/∂v.
    ///
    /// Where this cross product vanishes, as at a collapsed edge, the normal is the limit from the middle of the patch, as of
    /// [`Patch::normal`](crate::Patch::normal); it takes about 15 m² n² multiplications of vectors. It is zero where there is no limit: for a patch that is a point or a curve.
    pub fn normal(&self, u: f64, v: f64) -> DVec3 {
        let point = self.eval(u, v);
        let (numerator, _) = self.numerator_and_denominator(point);
        if numerator.is_regular(u, v) {
            return numerator.normal(u, v);
        }
        self.normal_net(point).limit(u, v)
    }

    /// The coefficients of N up to a positive factor.
    pub(in crate::rational) fn normal_net(&self, origin: DVec3) -> NormalNet {
        let (mut numerator, denominator) = self.numerator_and_denominator(origin);
        unit_size(&mut numerator.points);
        let (m, n) = (self.degree_u(), self.degree_v());
        let whole = |net: &[DVec3]| Factor::new(net, m, n);
        let along_u = |net: &[DVec3]| Factor::new(&differences_u(net, m + 1), m - 1, n);
        let along_v = |net: &[DVec3]| Factor::new(&differences_v(net, m + 1), m, n - 1);
        let (a, w) = (&numerator.points, &denominator.points);
        let terms = [
            along_u(a).cross(&along_v(a)).scaled(&whole(w)),
            along_v(a).cross(&whole(a)).scaled(&along_u(w)),
            whole(a).cross(&along_u(a)).scaled(&along_v(w)),
        ];
        let net: Net = (0..terms[0].net.len())
            .map(|i| terms[0].net[i] + terms[1].net[i] + terms[2].net[i])
            .collect();
        NormalNet::from_weighted(net, 3 * m - 1, 3 * n - 1).of_unit_size()
    }
}

/// A polynomial whose Bernstein coefficients are multiplied by their binomial coefficients, so that a product is a
/// convolution.
struct Factor {
    net: Net,
    columns: usize,
}

impl Factor {
    fn new(net: &[DVec3], degree_u: usize, degree_v: usize) -> Self {
        Self {
            net: weighted(net, degree_u, degree_v),
            columns: degree_u + 1,
        }
    }

    fn cross(&self, other: &Self) -> Self {
        self.product(other, DVec3::cross)
    }

    /// The product with a polynomial of numbers, which are the x-coordinates.
    fn scaled(&self, numbers: &Self) -> Self {
        self.product(numbers, |vector, number| vector * number.x)
    }

    fn product(&self, other: &Self, multiply: impl Fn(DVec3, DVec3) -> DVec3) -> Self {
        let columns = self.columns + other.columns - 1;
        let rows = self.net.len() / self.columns + other.net.len() / other.columns - 1;
        let mut net: Net = std::iter::repeat_n(DVec3::ZERO, columns * rows).collect();
        for (j, left) in self.net.chunks(self.columns).enumerate() {
            for (k, right) in other.net.chunks(other.columns).enumerate() {
                let row = &mut net[(j + k) * columns..];
                for (i, &left) in left.iter().enumerate() {
                    for (sum, &right) in row[i..].iter_mut().zip(right) {
                        *sum += multiply(left, right);
                    }
                }
            }
        }
        Self { net, columns }
    }
}
