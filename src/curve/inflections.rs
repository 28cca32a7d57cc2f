//! Inflections, cusps, and tangent lines through a point.

use super::Curve;
use super::curvature_numerator::{curvature_numerator, curvature_numerator_of_quadratic};
use super::hodograph::Hodograph;
use crate::bernstein::evaluate::evaluate;
use crate::bernstein::roots::{DOUBLE_ROOT, contacts, crossings, crossings_of_quadratic};
use crate::geometry::check::{check_points, max_abs};
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use crate::numeric::list::{Points, Scalars};
use glam::DVec2;

/// In this range of steps between control points, products of them stay in the range of f64.
const PLAIN_RANGE: std::ops::Range<f64> = 1e-70..1e70;

impl Curve<DVec2> {
    /// The parameters inside (0, 1) of inflections, where the curvature changes sign, in ascending order.
    ///
    /// These are the sign changes of B′×B″, of degree 2n − 4, that rounding of the control points cannot cause; a cubic
    /// has at most two. A cusp is not an inflection (see [`cusps`](Self::cusps)); straight curves and points have none.
    ///
    /// Source: Stone and DeRose, "A geometric characterization of parametric cubic curves", ACM TOG 8 (1989).
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let wave = Curve::new(&[(0.0, 0.0), (1.0, 2.0), (2.0, -2.0), (3.0, 0.0)].map(DVec2::from))?;
    /// assert_eq!(wave.inflections(), [0.5]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn inflections(&self) -> Vec<f64> {
        inflections_of(&self.points, ulp(self.max_abs())).to_vec()
    }

    /// All parameters in \[0, 1\] at which the tangent line passes through p, in ascending order.
    ///
    /// The roots of (B − p)×B′, of degree 2n − 2; double roots, as at p itself if p is on the curve, are listed once.
    /// Where the curve stops (|B′| below 10⁻⁷ of the largest control vector of B′) the tangent itself must pass through
    /// p, within 10⁻⁷ of the size. If every tangent passes through p because the curve is straight or a point, the
    /// result is 0 and 1, the ends of the range.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    ///
    /// Source: Farin, *Curves and Surfaces for CAGD*, §5.3, for the derivative; Lane and Riesenfeld, BIT 21 (1981), for
    /// the roots.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let arch = Curve::new(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(DVec2::from))?;
    /// assert_eq!(arch.tangents_from(DVec2::new(5.0, 1.5))?, [0.5]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn tangents_from(&self, p: DVec2) -> Result<Vec<f64>, Error> {
        check_points("p", &[p])?;
        Ok(self.tangents_from_unchecked(p))
    }
}

impl<P: Point> Curve<P> {
    /// The parameters inside (0, 1) of cusps, in ascending order: B′ = 0, and the direction reverses.
    ///
    /// At a cusp |B′|² has a minimum, a root of B′·B″, at which |B′| is no larger than rounding of the control points
    /// can make it. A straight curve that reverses its direction has a cusp at that point. Where B′ = 0 but the
    /// direction does not reverse, there is no cusp.
    ///
    /// Source: Stone and DeRose, "A geometric characterization of parametric cubic curves", ACM TOG 8 (1989).
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let cusp = Curve::new(&[(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)].map(DVec2::from))?;
    /// assert_eq!(cusp.cusps(), [0.5]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn cusps(&self) -> Vec<f64> {
        let rounding = ulp(self.max_abs());
        Hodograph::of(&self.points).cusps(rounding).to_vec()
    }

    /// [`tangents_from`](Curve::tangents_from) of the projection along z, for a finite point.
    pub(crate) fn tangents_from_unchecked(&self, p: P) -> Vec<f64> {
        let size = self.max_abs().max(p.max_abs());
        let normalized = Normalized::new(p, size);
        let relative: Points<P> = normalized.points(&self.points);
        let (turning, slack) = curvature_numerator(&relative, ulp(size * normalized.scale));
        let Some(ts) = contacts(&turning, slack) else {
            return vec![0.0, 1.0];
        };
        let Hodograph { vectors, .. } = Hodograph::of(&self.points);
        let goes = |t: f64| evaluate(&vectors, t).norm() > DOUBLE_ROOT;
        let passes = |t: f64| {
            let (direction, tangent) = (evaluate(&relative, t).to_2d(), self.tangent(t).to_2d());
            direction.perp_dot(tangent).abs() <= DOUBLE_ROOT * max_abs(&relative)
        };
        ts.into_iter().filter(|&t| goes(t) || passes(t)).collect()
    }
}

/// See [`Curve::inflections`]; of the projection along z. `rounding` is the error bound of a coordinate.
pub(crate) fn inflections_of<P: Point>(points: &[P], rounding: f64) -> Scalars {
    // The general code below takes 1.7 to 2 times as long.
    if let [a, b, c, d] = *points
        && cfg!(feature = "fast")
    {
        let steps = [b - a, c - b, d - c];
        if PLAIN_RANGE.contains(&max_abs(&steps)) {
            let (turning, slack) =
                curvature_numerator_of_quadratic(steps.map(|p| p.to_2d()), rounding);
            return crossings_of_quadratic(turning, slack);
        }
    }
    let Hodograph { vectors, unit } = Hodograph::of(points);
    if unit == 0.0 {
        return Scalars::new();
    }
    let (turning, slack) = curvature_numerator(&vectors, rounding / unit);
    crossings(&turning, slack)
}
