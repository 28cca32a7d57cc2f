//! f g′ − f′ g of two polynomials of one degree in Bernstein form.

use casteljau_kernels::bernstein::weights::binomial;
use casteljau_kernels::numeric::vector::Vector;

/// The Bernstein coefficients of f g′ − f′ g for f = Σ fᵢ Bᵢ and g = Σ gᵢ Bᵢ of degree n, where `product(i, j)` is
/// fᵢ gⱼ − fⱼ gᵢ.
///
/// A pair i < j contributes C(n, i) C(n, j) (j − i) tᵏ (1 − t)²ⁿ⁻²⁻ᵏ with k = i + j − 1, so the degree is 2n − 2 and not
/// 2n − 1. The result for n = 0 is zero.
pub(crate) fn wronskian<V: Vector>(n: usize, product: impl Fn(usize, usize) -> V) -> Vec<V> {
    let mut coefficients = vec![V::default(); 2 * n.max(1) - 1];
    for j in 1..=n {
        for i in 0..j {
            let k = i + j - 1;
            let share = binomial(n, i) * binomial(n, j) * (j - i) as f64 / binomial(2 * n - 2, k);
            coefficients[k] = coefficients[k] + product(i, j) * share;
        }
    }
    coefficients
}
