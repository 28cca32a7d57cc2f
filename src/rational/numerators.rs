//! Numerators of the derivative and of the curvature: polynomials that vanish where the derivative or the curvature
//! does. They are made of differences of points, so they do not depend on the origin.

use crate::bernstein::wronskian::Wronskian;
use crate::geometry::point::Point;
use crate::numeric::list::Points;
use casteljau_kernels::bernstein::weights::binomial;
use glam::DVec2;

/// The Bernstein coefficients of D = wA′ − w′A, of degree 2n − 2, where A = wB; so B′ = D/w².
///
/// Dₖ is a sum of wᵢ wⱼ (Pⱼ − Pᵢ) with i + j = k + 1. Source: Saito, Wang and Sederberg, "Hodographs and normals of rational
/// curves and surfaces", CAGD 12 (1995).
#[inline]
pub(super) fn derivative_numerator<P: Point>(
    wronskian: &Wronskian,
    points: &[P],
    weights: &[f64],
) -> Points<P> {
    wronskian.coefficients(|i, j| (points[j] - points[i]) * (weights[i] * weights[j]))
}

/// The Bernstein coefficients of det(A, A′, A″) for the homogeneous points A = (wB, w), of degree 3n − 6, and a bound on
/// their error if each coordinate has an error of `rounding`. Zero below degree 2.
///
/// The determinants of i < j < k, wᵢwⱼwₖ (Pⱼ − Pᵢ)×(Pₖ − Pᵢ), have the factor C(n, i) C(n, j) C(n, k) (j − i)(k − i)(k − j) and
/// the powers of i + j + k − 3, as the Wronskian of three powers.
pub(super) fn curvature_numerator(
    points: &[DVec2],
    weights: &[f64],
    rounding: f64,
) -> (Vec<f64>, f64) {
    let n = points.len() - 1;
    if n < 2 {
        return (vec![0.0], 0.0);
    }
    let degree = 3 * n - 6;
    let (mut sums, mut errors) = (vec![0.0; degree + 1], vec![0.0; degree + 1]);
    for k in 2..=n {
        for j in 1..k {
            for i in 0..j {
                let powers = ((j - i) * (k - i) * (k - j)) as f64;
                let share = powers * binomial(n, i) * binomial(n, j) * binomial(n, k)
                    / binomial(degree, i + j + k - 3);
                let factor = share * weights[i] * weights[j] * weights[k];
                let (e, f) = (points[j] - points[i], points[k] - points[i]);
                let sizes = e.abs().element_sum() + f.abs().element_sum();
                sums[i + j + k - 3] += factor * e.perp_dot(f);
                errors[i + j + k - 3] += factor * sizes * (rounding + f64::EPSILON * sizes);
            }
        }
    }
    (sums, errors.into_iter().fold(0.0, f64::max))
}
