//! Extrema of a coordinate, and parameters at a given coordinate.

use super::Curve;
use crate::bernstein::roots::{contacts, crossings, max_of};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use crate::numeric::list::Scalars;

impl<P: Point> Curve<P> {
    /// The parameters inside (0, 1) where a coordinate (0 is x, 1 is y, 2 is z) has a local extremum, in ascending
    /// order.
    ///
    /// These are the sign changes of its derivative, of degree n − 1; where the derivative only touches zero, the
    /// coordinate has no extremum. Extrema that change the coordinate by less than its rounding are ignored. A constant
    /// coordinate has no extremum.
    ///
    /// # Errors
    /// [`Error::Index`] for an axis that the points do not have.
    ///
    /// Source: Farin, *Curves and Surfaces for CAGD*, §5.3, for the derivative; Lane and Riesenfeld, BIT 21 (1981), for
    /// its roots.
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let arch = Curve::new(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(DVec2::from))?;
    /// assert_eq!(arch.extrema(0)?, []);
    /// assert_eq!(arch.extrema(1)?, [0.5]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn extrema(&self, axis: usize) -> Result<Vec<f64>, Error> {
        Ok(extrema_of(&self.coordinates(axis)?))
    }

    /// All parameters in \[0, 1\] where a coordinate (0 is x, 1 is y, 2 is z) has a given value, in ascending order.
    ///
    /// The roots of the polynomial Bₐ(t) − value: crossings, end points and tangential contacts, once each. A
    /// coordinate also touches a value if it misses it by no more than its rounding, some ulps of the largest
    /// coordinate. If the coordinate has the value everywhere, the result is 0 and 1, the ends of the range.
    ///
    /// # Errors
    /// [`Error::Index`] for an axis that the points do not have, [`Error::NotFinite`] for a value that is not finite.
    ///
    /// Source: Lane and Riesenfeld, "Bounds on a polynomial", BIT 21 (1981).
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let arch = Curve::new(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(DVec2::from))?;
    /// assert_eq!(arch.times_at_coordinate(1, 0.0)?, [0.0, 1.0]);
    /// assert_eq!(arch.times_at_coordinate(1, 1.5)?, [0.5]);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn times_at_coordinate(&self, axis: usize, value: f64) -> Result<Vec<f64>, Error> {
        if !value.is_finite() {
            return Err(Error::NotFinite {
                what: "value",
                index: 0,
                got: value,
            });
        }
        Ok(times_of(&self.coordinates(axis)?, value))
    }

    fn coordinates(&self, axis: usize) -> Result<Scalars, Error> {
        if axis >= P::DIMENSION {
            return Err(Error::Index {
                what: "axis",
                first: 0,
                last: P::DIMENSION - 1,
                got: axis,
            });
        }
        Ok(self.points.iter().map(|p| p.coordinate(axis)).collect())
    }
}

/// See [`Curve::extrema`].
pub(crate) fn extrema_of(values: &[f64]) -> Vec<f64> {
    let slopes: Scalars = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    // Each of the two numbers is rounded by up to half an ulp.
    crossings(&slopes, ulp(max_of(values))).to_vec()
}

/// See [`Curve::times_at_coordinate`].
pub(crate) fn times_of(values: &[f64], value: f64) -> Vec<f64> {
    // Halved, because the value may be ±1e308.
    let heights: Scalars = values.iter().map(|v| 0.5 * v - 0.5 * value).collect();
    // Half of the rounding error of n steps of interpolation.
    let rounding = values.len() as f64 * ulp(max_of(values).max(value.abs()));
    contacts(&heights, 0.5 * rounding).map_or_else(|| vec![0.0, 1.0], |ts| ts.to_vec())
}
