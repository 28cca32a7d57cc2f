//! Forward differencing: a polynomial at equal steps by additions only.

use crate::numeric::float::{as_f64, ratio};
use crate::patch::normal::binomial;
use glam::DVec3;

/// The value of a Bézier curve at the current step, and its differences of order 1 to m for the next steps.
pub(crate) struct Stepper {
    differences: Vec<DVec3>,
}

impl Stepper {
    /// Starts at t = 0, for steps of 1/`segments`.
    ///
    /// With the coefficients aⱼ = C(m, j) ΔʲP₀ of tʲ and h = 1/n, the difference of order k is Σⱼ aⱼ hʲ·Tⱼₖ, where Tⱼₖ
    /// = Δᵏxʲ at x = 0: T₀₀ = 1 and Tⱼₖ = k (Tⱼ₋₁,ₖ + Tⱼ₋₁,ₖ₋₁).
    pub(crate) fn new(points: &[DVec3], segments: usize) -> Self {
        let degree = points.len() - 1;
        let mut across = points.to_vec();
        let mut table = vec![0.0; points.len()];
        let mut differences = vec![DVec3::ZERO; points.len()];
        let mut scale = 1.0;
        table[0] = 1.0;
        for j in 0..=degree {
            let coefficient = across[0] * (binomial(degree, j) * scale);
            for (difference, &share) in differences.iter_mut().zip(&table) {
                *difference += coefficient * share;
            }
            for i in 0..degree - j {
                across[i] = across[i + 1] - across[i];
            }
            scale *= ratio(1, segments);
            for k in (1..=degree).rev() {
                table[k] = as_f64(k) * (table[k] + table[k - 1]);
            }
            table[0] = 0.0;
        }
        Self { differences }
    }

    /// Returns the current value and advances by one step.
    pub(crate) fn next(&mut self) -> DVec3 {
        let value = self.differences[0];
        for k in 1..self.differences.len() {
            let difference = self.differences[k];
            self.differences[k - 1] += difference;
        }
        value
    }
}
