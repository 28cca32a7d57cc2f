//! Degree reduction by one.
//!
//! Two curves of degrees n and n − 1 differ by a polynomial whose leading coefficient ΔⁿP₀ is that of the first. Of all
//! polynomials with this leading coefficient that vanish at both ends, the Chebyshev polynomial Tₙ, stretched until its
//! outermost zeros are the ends, has the smallest maximum. Subtracting it gives the best approximation.

use super::Curve;
use super::elevate::{elevate_once, unelevated};
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, ratio};
use crate::numeric::list::{Points, Scalars};
use casteljau_kernels::numeric::trigonometry::unit_vector;
use std::f64::consts::FRAC_PI_2;

/// A degree-reduced curve and its error.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Reduced<P: Point> {
    /// The curve of degree n − 1, with the same end points.
    pub curve: Curve<P>,
    /// The maximum distance between points of both curves at equal t, which bounds the distance between the curves.
    pub error: f64,
}

impl<P: Point> Curve<P> {
    /// The curve of degree n − 1 with the same end points that is closest at equal t, and its maximum distance.
    ///
    /// B(t) − R(t) = e·C(t) with C(t) = Tₙ((2t − 1) cos(π/2n)), which has n − 1 alternating extrema ±1, and e = Δⁿ /
    /// (2²ⁿ⁻¹ cosⁿ(π/2n)), where Δⁿ is the n-th difference of the control points. The maximum distance is exactly |e|,
    /// and no other curve of this degree with these end points has a smaller one. For an elevated curve the result is
    /// the original curve, with an error of rounding size; a line reduces to itself, with the error 0. Source:
    /// Lachance, "Chebyshev economization for parametric surfaces", CAGD 5 (1988).
    #[must_use]
    pub fn reduce(&self) -> Reduced<P> {
        let n = self.degree();
        if n == 1 {
            return Reduced {
                curve: self.clone(),
                error: 0.0,
            };
        }
        let stretch = unit_vector(FRAC_PI_2 / as_f64(n)).x;
        let excess = self.top_difference(stretch);
        let wave = stretched_chebyshev(n, stretch);
        let lower: Points<P> = self
            .points
            .iter()
            .zip(&wave)
            .map(|(&p, &c)| p - excess * c)
            .collect();
        Reduced {
            curve: Self::from_points(unelevated(&lower)).clamped(),
            error: excess.norm(),
        }
    }

    /// Δⁿ / (2²ⁿ⁻¹ stretchⁿ).
    fn top_difference(&self, stretch: f64) -> P {
        let mut row = self.points.clone();
        for last in (1..row.len()).rev() {
            for i in 0..last {
                row[i] = (row[i + 1] - row[i]) * (0.25 / stretch);
            }
        }
        row[0] * 2.0
    }
}

/// The Bernstein coefficients of Tₙ(stretch · (2t − 1)), by T(k+1) = 2x T(k) − T(k−1). The first and the last one are 0
/// for the stretch that is used here.
fn stretched_chebyshev(n: usize, stretch: f64) -> Scalars {
    let mut before: Scalars = [1.0].into_iter().collect();
    let mut now: Scalars = [-stretch, stretch].into_iter().collect();
    for k in 1..n {
        elevate_once(&mut before);
        elevate_once(&mut before);
        let at = |i: usize| now.get(i).copied().unwrap_or(0.0);
        let next = (0..=k + 1)
            .map(|i| {
                let upper = if i > 0 { at(i - 1) } else { 0.0 };
                let part = ratio(i, k + 1);
                2.0 * stretch * (part * upper - (1.0 - part) * at(i)) - before[i]
            })
            .collect();
        before = std::mem::replace(&mut now, next);
    }
    (now[0], now[n]) = (0.0, 0.0);
    now
}
