//! Products of polynomials in Bernstein form.

use super::Scalars;
use casteljau_kernels::binomial;

/// The Bernstein coefficients of a product of two polynomials (or of vectors of them) of the degrees n and m, where
/// `product` multiplies the coefficients i and j of the factors.
///
/// cₖ = Σ C(n, i) C(m, k − i) / C(n + m, k) · aᵢ bₖ₋ᵢ. Source: Farin, *Curves and Surfaces for CAGD*, §6.9.
pub(crate) fn product_of(n: usize, m: usize, product: impl Fn(usize, usize) -> f64) -> Scalars {
    let (left, right) = (binomials(n), binomials(m));
    let coefficient = |(k, whole): (usize, &f64)| {
        let terms = k.saturating_sub(m)..=k.min(n);
        let sum: f64 = terms
            .map(|i| left[i] * right[k - i] * product(i, k - i))
            .sum();
        sum / whole
    };
    binomials(n + m)
        .iter()
        .enumerate()
        .map(coefficient)
        .collect()
}

fn binomials(n: usize) -> Scalars {
    (0..=n).map(|i| binomial(n, i)).collect()
}
