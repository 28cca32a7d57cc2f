//! Bounds, extrema and inflections.

use super::RationalCurve;
use super::numerators::{curvature_numerator, derivative_numerator};
use crate::bernstein::roots::{crossings, max_of, roots_inside};
use crate::bernstein::wronskian::Wronskian;
use crate::geometry::bounds::Bounds;
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use crate::numeric::list::{Points, Scalars};
use glam::DVec2;

impl<P: Point> RationalCurve<P> {
    /// The smallest box that contains the curve, computed from its end points and its extrema.
    ///
    /// An extremum is a root of one coordinate of the numerator of B′, of degree 2n − 2.
    #[doc(alias = "bounding_box")]
    pub fn bounds(&self) -> Bounds<P> {
        let ends = Bounds::from_points(&[self.start(), self.end()]);
        // The curve lies in the hull of its control points, so where these are in the box it has no extremum outside.
        let inside = |axis: usize| {
            let x = |p: &P| p.coordinate(axis);
            let range = x(&ends.min)..=x(&ends.max);
            self.points.iter().all(|p| range.contains(&x(p)))
        };
        if (0..P::DIMENSION).all(inside) {
            return ends;
        }
        let numerator = self.derivative_numerator();
        let mut bounds = ends;
        for axis in (0..P::DIMENSION).filter(|&axis| !inside(axis)) {
            let row: Scalars = numerator.iter().map(|d| d.coordinate(axis)).collect();
            for t in roots_inside(&row) {
                let x = self.eval(t).coordinate(axis);
                bounds = bounds.including(bounds.min.with_coordinate(axis, x));
            }
        }
        bounds
    }

    /// The box of the control points, which contains the curve and is cheaper than [`bounds`](Self::bounds).
    pub fn control_bounds(&self) -> Bounds<P> {
        Bounds::from_points(&self.points)
    }

    /// The parameters inside (0, 1) where a coordinate (0 is x, 1 is y, 2 is z) has a local extremum, in ascending
    /// order.
    ///
    /// These are the sign changes of that coordinate of the numerator of B′, of degree 2n − 2, that rounding of the control
    /// points cannot cause. A constant coordinate has no extremum.
    ///
    /// # Errors
    /// [`Error::Index`] for an axis that the points do not have.
    ///
    /// Source: Saito, Wang and Sederberg, CAGD 12 (1995), for the numerator; Lane and Riesenfeld, BIT 21 (1981), for its
    /// roots.
    ///
    /// ```
    /// use casteljau::{RationalCurve, glam::DVec2};
    ///
    /// let [p0, p1, p2] = [(1.0, 0.0), (0.0, 2.0), (-1.0, 0.0)].map(DVec2::from);
    /// let arc = RationalCurve::conic(p0, p1, p2, 0.5)?;
    /// assert_eq!(arc.extrema(1)?, [0.5]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn extrema(&self, axis: usize) -> Result<Vec<f64>, Error> {
        if axis >= P::DIMENSION {
            return Err(Error::Index {
                what: "axis",
                first: 0,
                last: P::DIMENSION - 1,
                got: axis,
            });
        }
        let values: Scalars = self.points.iter().map(|p| p.coordinate(axis)).collect();
        let w = self.scaled_weights();
        let rounding = ulp(max_of(&values));
        let wronskian = Wronskian::of_degree(self.degree());
        let rates = wronskian.coefficients(|i, j| (values[j] - values[i]) * (w[i] * w[j]));
        let errors = wronskian.coefficients(|i, j| rounding * (w[i] * w[j]));
        Ok(crossings(&rates, max_of(&errors)).to_vec())
    }

    /// The Bernstein coefficients of the numerator of B′, for weights up to 2.
    pub(super) fn derivative_numerator(&self) -> Points<P> {
        let wronskian = Wronskian::of_degree(self.degree());
        derivative_numerator(&wronskian, &self.points, &self.scaled_weights())
    }

    /// The weights, scaled by a power of two so that the largest one is 1 to 2.
    pub(super) fn scaled_weights(&self) -> Scalars {
        let scale = self.weight_scale();
        self.weights.iter().map(|w| w * scale).collect()
    }
}

impl RationalCurve<DVec2> {
    /// The parameters inside (0, 1) of inflections, where the curvature changes sign, in ascending order.
    ///
    /// These are the sign changes of det(A, A′, A″) of the homogeneous control points, of degree 3n − 6, that rounding of
    /// the control points cannot cause. Conics, straight curves and points have none.
    ///
    /// Source: Farin, *Curves and Surfaces for CAGD*, §13.6.
    pub fn inflections(&self) -> Vec<f64> {
        let normalized = Normalized::around(self.start(), &self.points);
        let points: Points<DVec2> = normalized.points(&self.points);
        let rounding = ulp(self.max_abs()) * normalized.scale;
        let (numerator, slack) = curvature_numerator(&points, &self.scaled_weights(), rounding);
        crossings(&numerator, slack).to_vec()
    }
}
