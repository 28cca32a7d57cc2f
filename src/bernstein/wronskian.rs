//! f g′ − f′ g of two polynomials of one degree in Bernstein form.

use crate::numeric::float::as_f64;
use crate::numeric::list::{List, Scalars};
use casteljau_kernels::bernstein::weights::binomial;
use casteljau_kernels::numeric::vector::Vector;

/// The binomial coefficients of a Wronskian, for several pairs of polynomials of degree n.
pub(crate) struct Wronskian {
    /// C(n, i).
    row: Scalars,
    /// C(2n − 2, k).
    whole: Scalars,
}

impl Wronskian {
    pub(crate) fn of_degree(n: usize) -> Self {
        let row = |n: usize| (0..=n).map(|i| binomial(n, i)).collect();
        Self {
            row: row(n),
            whole: row(2 * n.max(1) - 2),
        }
    }

    /// The Bernstein coefficients of f g′ − f′ g for f = Σ fᵢ Bᵢ and g = Σ gᵢ Bᵢ, where `product(i, j)` is fᵢ gⱼ − fⱼ gᵢ.
    ///
    /// A pair i < j contributes C(n, i) C(n, j) (j − i) tᵏ (1 − t)²ⁿ⁻²⁻ᵏ with k = i + j − 1, so the degree is 2n − 2 and not
    /// 2n − 1. The result for n = 0 is zero.
    #[inline]
    pub(crate) fn coefficients<V: Vector>(
        &self,
        product: impl Fn(usize, usize) -> V,
    ) -> List<V, 4> {
        let mut sums: List<V, 4> = self.whole.iter().map(|_| V::default()).collect();
        for j in 1..self.row.len() {
            for i in 0..j {
                let k = i + j - 1;
                let share = self.row[i] * self.row[j] * as_f64(j - i) / self.whole[k];
                sums[k] = sums[k] + product(i, j) * share;
            }
        }
        sums
    }
}
