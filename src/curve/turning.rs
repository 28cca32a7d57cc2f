//! The cross product of a curve with its own derivative, for inflections and tangents through a point.

use crate::bernstein::weights::binomial;
use crate::geometry::point::Point;
use crate::numeric::list::{Points, Scalars};
use glam::DVec2;

/// The Bernstein coefficients of V×V′ for the curve V with the given control points, projected along z, and a bound on
/// their error if each coordinate has an error of `rounding`.
///
/// Since V×V = 0, a pair i < j contributes only vᵢ×vⱼ · C(m, i) C(m, j) (j − i) tᵏ (1 − t)²ᵐ⁻²⁻ᵏ with k = i + j − 1, so
/// the degree is 2m − 2 and not 2m − 1. The result for a single point is zero.
pub(crate) fn turning<P: Point>(v: &[P], rounding: f64) -> (Scalars, f64) {
    let v: Points<DVec2> = v.iter().map(|p| p.to_2d()).collect();
    let m = v.len() - 1;
    let mut coefficients: Scalars = (0..2 * m.max(1) - 1).map(|_| 0.0).collect();
    let mut errors = coefficients.clone();
    for j in 1..=m {
        for i in 0..j {
            let k = i + j - 1;
            let share = binomial(m, i) * binomial(m, j) * (j - i) as f64 / binomial(2 * m - 2, k);
            let sizes = v[i].abs().element_sum() + v[j].abs().element_sum();
            coefficients[k] += share * v[i].perp_dot(v[j]);
            errors[k] += share * sizes * (rounding + f64::EPSILON * sizes);
        }
    }
    let slack = errors.iter().copied().fold(0.0, f64::max);
    (coefficients, slack)
}
