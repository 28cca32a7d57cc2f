//! The normal of rational patches, also where ∂u × ∂v vanishes.
//!
//! The normal has the direction of N = w(Au × Av) + wu(Av × A) + wv(A × Au), a polynomial of degrees 3m − 1 and 3n − 1
//! that does not depend on the origin. At a pole, the origin is the pole: then the rows of N at the collapsed edge are zero up
//! to rounding, and the first row that is not gives the limit. The last two terms matter where the first one vanishes to a
//! higher order, as at the tip of a surface of revolution whose profile is tangent to the axis there. Source: Saito, Wang and Sederberg, "Hodographs and normals
//! of rational curves and surfaces", CAGD 12 (1995).

use super::RationalPatch;
use crate::bernstein::evaluate::evaluate;
use crate::geometry::point::Point;
use crate::numeric::list::Net;
use crate::patch::net::{differences_u, differences_v, transpose, unit_size};
use crate::patch::normal::{NormalNet, weighted};
use crate::patch::tensor_product::REGULAR_RATIO;
use crate::surface::scaling::Scaling;
use glam::DVec3;

/// Rounding errors of sums of homogeneous vectors, as a fraction of the patch's size, with a margin.
pub(in crate::rational) const NOISE: f64 = 4096.0 * f64::EPSILON;

impl RationalPatch {
    /// The unit normal at (u, v): the direction of ∂S/∂u × ∂S/∂v.
    ///
    /// Where this cross product vanishes, as at a collapsed edge, the normal is the limit from the middle of the patch, as of
    /// [`Patch::normal`](crate::Patch::normal); it takes about 15 m² n² multiplications of vectors. It is zero where there is no limit: for a patch that is a point or a curve.
    pub fn normal(&self, u: f64, v: f64) -> DVec3 {
        let point = self.eval(u, v);
        let image = self.image(&Scaling::around(self.control_bounds()));
        let cross_product = image.cross_product(u, v);
        cross_product.map_or_else(|| self.normal_net(point).limit(u, v), Point::unit)
    }

    /// The direction of ∂u × ∂v of a patch of size 1; `None` if it does not exceed rounding noise.
    pub(super) fn cross_product(&self, u: f64, v: f64) -> Option<DVec3> {
        let columns = self.degree_u() + 1;
        let (a, w) = self.numerator_and_denominator(self.eval(u, v));
        let [a_across, w_across] = [&a, &w].map(|patch| transpose(&patch.points, columns));
        let along_u = direction([&a_across, &w_across], a.rows(), [v, u]);
        let along_v = direction([&a.points, &w.points], columns, [u, v]);
        let cross_product = along_u.cross(along_v);
        let [along_u, along_v] = [along_u, along_v].map(Point::norm);
        let min_length = (REGULAR_RATIO * along_u * along_v).max(NOISE * along_u.max(along_v));
        (Point::norm(cross_product) > min_length).then_some(cross_product)
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

/// The direction of ∂v from the nets of A, which vanishes at (u, v), and w.
///
/// ∂v is n/w times Av, a sum of differences. It is divided by the sums of the weights at the starts and at the ends of these
/// differences instead of w, so that neither small nor large weights count as noise. At the ends, only the next row counts.
fn direction([a, w]: [&[DVec3]; 2], columns: usize, [u, v]: [f64; 2]) -> DVec3 {
    let [a, w] = [a, w]
        .map(|net| -> Vec<DVec3> { net.chunks(columns).map(|row| evaluate(row, u)).collect() });
    let n = a.len() - 1;
    if v == 0.0 {
        return a[1] / w[1].x;
    }
    if v == 1.0 {
        return a[n - 1] / -w[n - 1].x;
    }
    let change = |values: &[DVec3]| {
        let steps: Vec<DVec3> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
        evaluate(&steps, v)
    };
    change(&a) / (2.0 * evaluate(&w, v).x + (1.0 - 2.0 * v) * change(&w).x)
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
        for (a, &left) in self.net.iter().enumerate() {
            for (b, &right) in other.net.iter().enumerate() {
                let column = a % self.columns + b % other.columns;
                let row = a / self.columns + b / other.columns;
                net[row * columns + column] += multiply(left, right);
            }
        }
        Self { net, columns }
    }
}
