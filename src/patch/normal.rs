//! The limit of the normal where ∂u × ∂v vanishes.
//!
//! N(u, v) = ∂S/∂u × ∂S/∂v is itself a polynomial with vector coefficients, of degrees 2m − 1 and 2n − 1. Its
//! coefficients are the normal net: 6 × 6 vectors for a bicubic patch. Where an edge is collapsed to a point, the rows
//! of this net along the edge are exactly zero, and the first nonzero row gives the limit of the normal's direction. So
//! no step length has to be chosen, and no noise is normalized. Source: Yamaguchi, "Normal vectors of Bézier patches";
//! the formula is derived by multiplying the two derivatives in Bernstein form (Farin, *Curves and Surfaces for CAGD*,
//! §6.9 for products).

use super::net::{transpose, unit_size};
use crate::bernstein::evaluate::evaluate;
use crate::geometry::error::MAX_DEGREE;
use crate::geometry::point::Point;
use crate::numeric::list::Net;
use casteljau_kernels::bernstein::de_casteljau::{keep_after, keep_between};
pub(crate) use casteljau_kernels::bernstein::weights::binomial;
use glam::DVec3;

/// A coefficient counts as zero below this length; the coefficients of the unit-sized differences carry noise of about
/// 1e-16.
const VANISHING: f64 = 1e-13;

/// The parameters toward which limits are taken: first the middle of the patch. Where N vanishes on the whole line to
/// the middle, as along a fold in the middle, the limits from both sides disagree, and the second point selects one of
/// them.
const LIMIT_TARGETS: [[f64; 2]; 2] = [[0.5, 0.5], [0.375, 0.25]];

/// The coefficients of N = ∂u × ∂v in Bernstein form, up to a positive factor.
pub(crate) struct NormalNet {
    net: Net,
    /// 2m − 1 and 2n − 1.
    degree_u: usize,
    degree_v: usize,
}

impl NormalNet {
    /// Computes the net from differences along u (m columns) and along v (m + 1 columns):
    /// N_kl = Σ C(m−1,i) C(n,j) C(m,i′) C(n−1,j′) / (C(2m−1,k) C(2n−1,l)) Δu_ij × Δv_i′j′ over i + i′ = k, j + j′ = l.
    pub(crate) fn new(du: &[DVec3], dv: &[DVec3], m: usize, n: usize) -> Self {
        let (degree_u, degree_v) = (2 * m - 1, 2 * n - 1);
        let columns = degree_u + 1;
        let mut net = std::iter::repeat_n(DVec3::ZERO, columns * (degree_v + 1)).collect::<Net>();
        let (du, dv) = (weighted(du, m - 1, n), weighted(dv, m, n - 1));
        for (a, &along_u) in du.iter().enumerate() {
            for (b, &along_v) in dv.iter().enumerate() {
                let (k, l) = (a % m + b % (m + 1), a / m + b / (m + 1));
                net[l * columns + k] += along_u.cross(along_v);
            }
        }
        Self::from_weighted(net, degree_u, degree_v)
    }

    /// The net of the given degrees, from coefficients that are multiplied by their binomial coefficients.
    pub(crate) fn from_weighted(mut net: Net, degree_u: usize, degree_v: usize) -> Self {
        let columns = degree_u + 1;
        for (index, coefficient) in net.iter_mut().enumerate() {
            *coefficient /=
                binomial(degree_u, index % columns) * binomial(degree_v, index / columns);
        }
        Self {
            net,
            degree_u,
            degree_v,
        }
    }

    /// The net, scaled so that its largest coordinate is ±1.
    pub(crate) fn of_unit_size(mut self) -> Self {
        unit_size(&mut self.net);
        self
    }

    /// Whether N is zero everywhere, so that the patch is a point or a curve.
    pub(crate) fn vanishes(&self) -> bool {
        self.net.iter().all(|&p| direction(p).is_none())
    }

    /// The limit of N's direction at (u, v), approached from the middle of the patch, as a unit vector; zero if N is
    /// zero.
    pub(crate) fn limit(&self, u: f64, v: f64) -> DVec3 {
        let inside = |t: f64| t > 0.0 && t < 1.0;
        let columns = self.degree_u + 1;
        let on_side = if inside(u) && (v == 0.0 || v == 1.0) {
            first_row(&self.net, columns, u, v == 1.0)
        } else if inside(v) && (u == 0.0 || u == 1.0) {
            let across = transpose(&self.net, columns);
            first_row(&across, self.degree_v + 1, v, u == 1.0)
        } else {
            None
        };
        let limit_toward = |inner_point| self.limit_toward(u, v, inner_point);
        on_side
            .or_else(|| LIMIT_TARGETS.into_iter().find_map(limit_toward))
            .unwrap_or(DVec3::ZERO)
    }

    /// The limit of the direction at (u, v) along the straight line to another point: the direction of the first
    /// coefficient of N on this line that does not vanish. The coefficient of order k combines the coefficients of N
    /// with k steps in u and v together.
    fn limit_toward(&self, u: f64, v: f64, [to_u, to_v]: [f64; 2]) -> Option<DVec3> {
        let columns = self.degree_u + 1;
        let rows = self.degree_v + 1;
        let narrow = piece_toward(&self.net, columns, u, to_u);
        let piece = piece_toward(&transpose(&narrow, columns), rows, v, to_v);
        (0..columns + rows - 1).find_map(|order| {
            let min = order.saturating_sub(self.degree_v);
            let sum: DVec3 = (min..=order.min(self.degree_u))
                .map(|k| {
                    let share = binomial(self.degree_u, k) * binomial(self.degree_v, order - k);
                    piece[k * rows + order - k] * share
                })
                .sum();
            direction(sum / binomial(self.degree_u + self.degree_v, order))
        })
    }
}

/// The direction at t of the first row that does not vanish there; the rows are searched backwards if `from_end`.
fn first_row(net: &[DVec3], columns: usize, t: f64, from_end: bool) -> Option<DVec3> {
    let at = |row: &[DVec3]| {
        let some = row.iter().any(|&p| p != DVec3::ZERO);
        some.then(|| direction(value(row, t))).flatten()
    };
    if from_end {
        net.rchunks(columns).find_map(at)
    } else {
        net.chunks(columns).find_map(at)
    }
}

/// The value of a row at t. The degree of N is above that of curves.
fn value(row: &[DVec3], t: f64) -> DVec3 {
    if row.len() <= MAX_DEGREE + 1 {
        return evaluate(row, t);
    }
    let mut rest = Net::from(row);
    keep_after(&mut rest, t);
    rest[0]
}

/// Every row restricted to the interval from t to another parameter. From an end to ½ the whole row is returned, which
/// has the same first directions.
fn piece_toward(net: &[DVec3], columns: usize, t: f64, to: f64) -> Net {
    let mut rows = Net::from(net);
    for row in rows.chunks_mut(columns) {
        let (mut start, mut end) = (t, to);
        if t > to {
            row.reverse();
            (start, end) = (1.0 - t, 1.0 - to);
        }
        if start != 0.0 || end != 0.5 {
            keep_between(row, start, end);
        }
    }
    rows
}

/// The unit vector; `None` if the length is noise.
fn direction(vector: DVec3) -> Option<DVec3> {
    (vector.length_squared() > VANISHING * VANISHING).then(|| Point::unit(vector))
}

/// Each coefficient of a net of these degrees, multiplied by its binomial coefficients.
pub(crate) fn weighted(net: &[DVec3], degree_u: usize, degree_v: usize) -> Net {
    let columns = degree_u + 1;
    net.iter()
        .enumerate()
        .map(|(i, &p)| p * (binomial(degree_u, i % columns) * binomial(degree_v, i / columns)))
        .collect()
}
