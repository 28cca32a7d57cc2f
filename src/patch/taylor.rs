//! Value, first and second derivative of a row of Bernstein coefficients.

use crate::bernstein::polynomials::bernstein_into;
use crate::geometry::error::MAX_DEGREE;
use crate::numeric::float::as_f64;
use casteljau_kernels::bernstein::derivatives::with_derivatives;

/// The maximum number of coefficients of a row: the degree of a squared distance is twice that of a patch.
pub(crate) const MAX_COUNT: usize = 2 * MAX_DEGREE + 1;

/// Rows with at least this many coefficients are evaluated with Bernstein weights instead of de Casteljau's algorithm.
pub(crate) const LONG_ROW: usize = 9;

/// The Bernstein weights at one parameter, for a row's degree and for the two degrees below it.
pub(crate) struct BernsteinWeights {
    count: usize,
    weights: [[f64; MAX_COUNT]; 3],
}

impl BernsteinWeights {
    /// `None` for rows so short that de Casteljau's algorithm is as fast, and for t outside the unit interval.
    pub(crate) fn new(count: usize, t: f64) -> Option<Self> {
        if count < LONG_ROW || !(0.0..=1.0).contains(&t) {
            return None;
        }
        let mut weights = [[0.0; MAX_COUNT]; 3];
        for (lower, weights) in weights.iter_mut().enumerate() {
            bernstein_into(&mut weights[..count - lower], t);
        }
        Some(Self { count, weights })
    }

    /// Value, first and second derivative of a row.
    pub(crate) fn blend(&self, row: &[f64]) -> [f64; 3] {
        let weights = |lower: usize| &self.weights[lower][..self.count - lower];
        blend_row(row, [weights(0), weights(1), weights(2)])
    }
}

/// Value, first and second derivative at t by de Casteljau's algorithm.
pub(crate) fn taylor(coefficients: &[f64], t: f64) -> [f64; 3] {
    let mut row = [0.0; MAX_COUNT];
    let row = &mut row[..coefficients.len()];
    row.copy_from_slice(coefficients);
    with_derivatives(row, t)
}

/// Value, first and second derivative along each row of a net, given the Bernstein weights of the row's degree n and of
/// the degrees n − 1 and n − 2 at the parameter. Rows have at least three coefficients.
fn blend_row(row: &[f64], weights: [&[f64]; 3]) -> [f64; 3] {
    let n = as_f64(row.len() - 1);
    let [of_value, of_slope, of_bend] = weights;
    let value = row.iter().zip(of_value).map(|(c, w)| c * w).sum();
    let slope: f64 = row
        .windows(2)
        .zip(of_slope)
        .map(|(c, w)| (c[1] - c[0]) * w)
        .sum();
    let bend: f64 = row
        .windows(3)
        .zip(of_bend)
        .map(|(c, w)| (c[2] - c[1] - (c[1] - c[0])) * w)
        .sum();
    [value, n * slope, n * (n - 1.0) * bend]
}
