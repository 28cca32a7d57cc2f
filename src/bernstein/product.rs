//! Multiplication of polynomials in Bernstein form.

use crate::numeric::list::Scalars;
use casteljau_kernels::bernstein::weights::binomial;

/// The Bernstein coefficients of a product of two polynomials (or of vectors of them) of the degrees n and m, where
/// `product` multiplies the coefficients i and j of the factors.
///
/// cₖ = Σ C(n, i) C(m, k − i) / C(n + m, k) · aᵢ bₖ₋ᵢ. Source: Farin, *Curves and Surfaces for CAGD*, §6.9.
pub(crate) fn product_of(n: usize, m: usize, product: impl Fn(usize, usize) -> f64) -> Scalars {
    Binomials::new(n, m).product(product)
}

/// The binomial coefficients of a product, for several products of the same degrees.
pub(crate) struct Binomials([Scalars; 3]);

impl Binomials {
    pub(crate) fn new(n: usize, m: usize) -> Self {
        Self([n, m, n + m].map(|n| (0..=n).map(|i| binomial(n, i)).collect()))
    }

    /// Same as [`product_of`].
    pub(crate) fn product(&self, product: impl Fn(usize, usize) -> f64) -> Scalars {
        let [left, right, whole] = &self.0;
        let (n, m) = (left.len() - 1, right.len() - 1);
        let coefficient = |(k, whole): (usize, &f64)| {
            let terms = k.saturating_sub(m)..=k.min(n);
            let sum: f64 = terms
                .map(|i| left[i] * right[k - i] * product(i, k - i))
                .sum();
            sum / whole
        };
        whole.iter().enumerate().map(coefficient).collect()
    }
}
