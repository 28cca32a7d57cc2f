//! Bernstein polynomials: the weights of the control points at t.

use crate::geometry::error::{Error, MAX_DEGREE};
use crate::numeric::float::ratio;
use crate::numeric::list::Scalars;

/// The n + 1 Bernstein weights of degree n at t: Bᵢ(t) = C(n, i) tⁱ (1 − t)ⁿ⁻ⁱ.
///
/// For t in [0, 1] they are not negative and sum to 1 within one ulp; at the ends they are exactly 0 and 1. They are
/// computed row by row from products and sums of positive numbers, so nothing cancels. Source: Piegl and Tiller, *The
/// NURBS Book*, algorithm A1.3.
///
/// # Errors
/// [`Error::Range`] for a degree above 64, [`Error::NotFinite`] for a t that is not finite.
pub fn bernstein(degree: usize, t: f64) -> Result<Vec<f64>, Error> {
    if degree > MAX_DEGREE {
        return Err(Error::Range {
            what: "degree",
            expected: "at most 64",
            got: degree as f64,
        });
    }
    if !t.is_finite() {
        return Err(Error::NotFinite {
            what: "t",
            index: 0,
            got: t,
        });
    }
    let mut weights = vec![0.0; degree + 1];
    bernstein_into(&mut weights, t);
    Ok(weights)
}

/// Fills `weights` with the Bernstein weights of degree `weights.len()` − 1.
pub(crate) fn bernstein_into(weights: &mut [f64], t: f64) {
    let s = 1.0 - t;
    weights[0] = 1.0;
    for row in 1..weights.len() {
        let mut carry = 0.0;
        for weight in &mut weights[..row] {
            let product = *weight;
            *weight = carry + s * product;
            carry = t * product;
        }
        weights[row] = carry;
    }
    if (0.0..=1.0).contains(&t) {
        normalise(weights);
    }
}

/// Divides by the sum, to remove the common factor caused by the rounding of 1 − t: up to n half ulps.
fn normalise(weights: &mut [f64]) {
    let (mut sum, mut lost) = (0.0, 0.0);
    for &weight in &*weights {
        // Accumulate the exact rounding error of each sum (Knuth's two-sum); otherwise the result would be off by some
        // ulps.
        let next = sum + weight;
        let part = next - sum;
        lost += (sum - (next - part)) + (weight - part);
        sum = next;
    }
    sum += lost;
    for weight in weights {
        *weight /= sum;
    }
}

/// C(n, 0) … C(n, n).
pub(crate) fn binomials(n: usize) -> Scalars {
    let mut value = 1.0;
    (0..=n)
        .map(|k| {
            let this = value;
            value *= ratio(n - k, k + 1);
            this
        })
        .collect()
}
