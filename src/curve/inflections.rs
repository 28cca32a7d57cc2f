//! Where does the curve change the side to which it bends, where does it stop, and where does it point at a place?

use super::Curve;
use super::nearest::unit_for;
use super::turning::turning;
use crate::bernstein::evaluate::evaluate;
use crate::bernstein::product::product_of;
use crate::bernstein::roots::{contacts, crossings, roots_inside};
use crate::curve::arc_length::length::hodograph;
use crate::geometry::check::{check_finite, max_abs};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use crate::numeric::list::{Points, Scalars};
use glam::DVec2;

/// How far about a place with B′ = 0 to look for the way in and the way out.
const ASIDE: f64 = 1e-4;

/// Roots of multiplicity two are known to about the root of the rounding.
const HALF_THE_DIGITS: f64 = 1e-7;

impl Curve<DVec2> {
    /// The parameters inside (0, 1) where the curve changes the side to which it bends, sorted.
    ///
    /// That is where B′×B″, of degree 2n − 4, changes sign beyond what rounding of the control points can do; at most two
    /// for a cubic. A cusp is none (see [`cusps`](Self::cusps)), and straight curves and points have none.
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

    /// All parameters in \[0, 1\] at which the tangent line passes through p, sorted.
    ///
    /// The roots of (B − p)×B′, of degree 2n − 2; where it only touches zero, as at p itself if p is on the curve, once
    /// each. Where the curve stops (|B′| below 10⁻⁷ of the largest control vector of B′) the tangent itself must pass
    /// through p, within 10⁻⁷ of the size. If every tangent passes through p, the curve being straight or a point, the
    /// answer is 0 and 1, the ends of the range.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a NaN or an infinity.
    ///
    /// Source: Farin, *Curves and Surfaces for CAGD*, §5.3, for the derivative; Lane and Riesenfeld, BIT 21 (1981), for the
    /// roots.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let arch = Curve::new(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(DVec2::from))?;
    /// assert_eq!(arch.tangents_from(DVec2::new(5.0, 1.5))?, [0.5]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn tangents_from(&self, p: DVec2) -> Result<Vec<f64>, Error> {
        check_finite("p", &[p])?;
        Ok(self.tangents_through(p))
    }
}

impl<P: Point> Curve<P> {
    /// The parameters inside (0, 1) of cusps, sorted: where the curve stops and goes back, B′ = 0.
    ///
    /// At a cusp |B′|² has a minimum, a root of B′·B″, at which |B′| is no more than rounding of the control points can
    /// make it. A straight curve that turns back has a cusp there. Where the curve stops and goes on there is none.
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
        cusps_of(&self.points, ulp(self.max_abs())).to_vec()
    }

    /// [`tangents_from`](Curve::tangents_from) as seen along z, for a point that is finite.
    pub(crate) fn tangents_through(&self, p: P) -> Vec<f64> {
        let size = self.max_abs().max(p.max_abs());
        let unit = unit_for(size);
        let about: Points<P> = self.points.iter().map(|&q| q * unit - p * unit).collect();
        let (turning, slack) = turning(&about, ulp(size * unit));
        let Some(ts) = contacts(&turning, slack) else {
            return vec![0.0, 1.0];
        };
        let (slopes, _) = hodograph(&self.points);
        let goes = |t: f64| evaluate(&slopes, t).length() > HALF_THE_DIGITS;
        let passes = |t: f64| {
            let (direction, tangent) = (evaluate(&about, t).to_2d(), self.tangent(t).to_2d());
            direction.perp_dot(tangent).abs() <= HALF_THE_DIGITS * max_abs(&about)
        };
        ts.into_iter().filter(|&t| goes(t) || passes(t)).collect()
    }
}

/// See [`Curve::inflections`]; seen along z. `rounding` is what a coordinate may be off by.
pub(crate) fn inflections_of<P: Point>(points: &[P], rounding: f64) -> Scalars {
    let (slopes, unit) = hodograph(points);
    if unit == 0.0 {
        return Scalars::new();
    }
    let (turning, slack) = turning(&slopes, rounding / unit);
    crossings(&turning, slack)
}

/// See [`Curve::cusps`]. `rounding` is what a coordinate may be off by.
pub(crate) fn cusps_of<P: Point>(points: &[P], rounding: f64) -> Scalars {
    let (slopes, unit) = hodograph(points);
    let m = slopes.len() - 1;
    if unit == 0.0 || m == 0 {
        return Scalars::new();
    }
    let rate = product_of(m, m - 1, |i, j| slopes[i].dot(slopes[j + 1] - slopes[j]));
    let slack = 8.0 * (m + 2) as f64 * (rounding / unit + f64::EPSILON);
    let slope = |t: f64| evaluate(&slopes, t);
    let is_cusp =
        |t: f64| slope(t).length() <= slack && slope(t - ASIDE).dot(slope(t + ASIDE)) < 0.0;
    let stops = roots_inside(&rate).into_iter();
    stops.filter(|&t| is_cusp(t)).collect()
}
