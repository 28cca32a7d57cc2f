//! Checks of points and tolerances.

use super::error::Error;
use super::point::Point;
use crate::numeric::float::ulp;

/// The largest absolute coordinate.
pub(crate) fn max_abs<P: Point>(points: &[P]) -> f64 {
    points
        .iter()
        .fold(0.0, |largest: f64, p| largest.max(p.max_abs()))
}

/// Returns an error for the first point with a NaN or an infinity.
pub(crate) fn check_finite<P: Point>(what: &'static str, points: &[P]) -> Result<(), Error> {
    match points.iter().position(|p| !p.is_finite()) {
        Some(index) => Err(Error::NotFinite {
            what,
            index,
            got: first_not_finite(points[index]),
        }),
        None => Ok(()),
    }
}

/// The first coordinate of a point that is not finite.
fn first_not_finite<P: Point>(point: P) -> f64 {
    let mut coordinates = (0..P::DIMENSION).map(|axis| point.coordinate(axis));
    coordinates.find(|x| !x.is_finite()).unwrap_or(f64::NAN)
}

/// Returns an error for a tolerance that is not positive and finite, or finer than the coordinates can resolve: 4 ulps
/// of the largest coordinate.
///
/// Below that, rounding alone moves points farther than the tolerance allows.
pub(crate) fn check_tolerance(tolerance: f64, largest_coordinate: f64) -> Result<(), Error> {
    if !(tolerance > 0.0 && tolerance < f64::INFINITY) {
        return Err(Error::Range {
            what: "tolerance",
            expected: "a finite number above 0",
            got: tolerance,
        });
    }
    let min = 4.0 * ulp(largest_coordinate);
    if tolerance < min {
        Err(Error::Tolerance {
            min,
            got: tolerance,
        })
    } else {
        Ok(())
    }
}
