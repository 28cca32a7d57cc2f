//! The cross product of a curve with its own derivative, for inflections and tangents through a point.

use crate::bernstein::wronskian::Wronskian;
use crate::geometry::point::Point;
use crate::numeric::list::{Points, Scalars};
use glam::DVec2;

/// The Bernstein coefficients of V×V′ for the curve V with the given control points, projected along z, and a bound on
/// their error if each coordinate has an error of `rounding`. The result for a single point is zero.
pub(crate) fn curvature_numerator<P: Point>(v: &[P], rounding: f64) -> (Scalars, f64) {
    if let [a, b, c] = *v {
        let (coefficients, slack) =
            curvature_numerator_of_quadratic([a, b, c].map(|p| p.to_2d()), rounding);
        return (coefficients.into_iter().collect(), slack);
    }
    curvature_numerator_of_any_degree(
        &v.iter().map(|p| p.to_2d()).collect::<Points<DVec2>>(),
        rounding,
    )
}

fn curvature_numerator_of_any_degree(v: &[DVec2], rounding: f64) -> (Scalars, f64) {
    let m = v.len() - 1;
    let wronskian = Wronskian::of_degree(m);
    let coefficients = wronskian.coefficients(|i, j| v[i].perp_dot(v[j]));
    let errors = wronskian.coefficients(|i, j| {
        let sizes = v[i].abs().element_sum() + v[j].abs().element_sum();
        sizes * (rounding + f64::EPSILON * sizes)
    });
    let slack = errors.into_iter().fold(0.0, f64::max);
    (coefficients, slack)
}

/// [`curvature_numerator`] for degree 2, as for the derivative of a cubic.
pub(crate) fn curvature_numerator_of_quadratic(
    [a, b, c]: [DVec2; 3],
    rounding: f64,
) -> ([f64; 3], f64) {
    let [p, q, r] = [a, b, c].map(|v| v.abs().element_sum());
    let error = |sizes: f64| sizes * (rounding + f64::EPSILON * sizes);
    let slack = (2.0 * error(p + q))
        .max(error(p + r))
        .max(2.0 * error(q + r));
    let coefficients = [2.0 * a.perp_dot(b), a.perp_dot(c), 2.0 * b.perp_dot(c)];
    (coefficients, slack)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degree_2_is_the_general_formula() {
        let v = [(1.0, 2.0), (-3.0, 0.5), (4.0, 1.0)].map(DVec2::from);
        let (coefficients, slack) = curvature_numerator(&v, 1e-3);
        let (general, general_slack) = curvature_numerator_of_any_degree(&v, 1e-3);
        assert_eq!((&*coefficients, slack), (&*general, general_slack));
    }
}
