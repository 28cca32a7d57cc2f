//! Checks of points and tolerances, and the limit of coordinates.

use super::error::Error;
use super::point::Point;
use crate::numeric::float::ulp;

/// The largest absolute coordinate.
pub(crate) fn max_abs<P: Point>(points: &[P]) -> f64 {
    points
        .iter()
        .fold(0.0, |largest: f64, p| largest.max(p.max_abs()))
}

/// The largest absolute value of a coordinate, 2⁵⁰⁰: neither differences nor products of two coordinates overflow.
///
/// Constructors and functions that take points return [`Error::Item`] for larger coordinates, and [`Error::NotFinite`] for
/// a NaN or an infinity. Where the exact result of an operation has a larger coordinate (the derivative of a very large
/// curve, an extrapolation), the coordinate is set to the limit.
pub const MAX_COORDINATE: f64 = 3.273_390_607_896_142e150;

/// Results of operations on the largest coordinates may exceed the limit by rounding.
const MAX_ACCEPTED: f64 = MAX_COORDINATE * (1.0 + 1e-9);

/// Whether all coordinates of a point are within the limit.
pub(crate) fn is_within_limit<P: Point>(p: P) -> bool {
    p.max_abs() <= MAX_ACCEPTED
}

/// The nearest point whose coordinates are within the limit. A coordinate that is NaN, because an overflow lost its sign,
/// becomes 0.
pub(crate) fn clamp_to_limit<P: Point>(p: P) -> P {
    if is_within_limit(p) {
        return p;
    }
    (0..P::DIMENSION).fold(p, |p, axis| {
        let x = p.coordinate(axis);
        let x = if x.is_nan() { 0.0 } else { x };
        p.with_coordinate(axis, x.clamp(-MAX_COORDINATE, MAX_COORDINATE))
    })
}

/// Returns an error for the first point with a NaN, an infinity, or a coordinate beyond [`MAX_COORDINATE`].
pub(crate) fn check_points<P: Point>(what: &'static str, points: &[P]) -> Result<(), Error> {
    let Some(index) = points.iter().position(|&p| !is_within_limit(p)) else {
        return Ok(());
    };
    let mut coordinates = (0..P::DIMENSION).map(|axis| points[index].coordinate(axis));
    let is_bad = |x: &f64| x.is_nan() || x.abs() > MAX_ACCEPTED;
    let got = coordinates.find(is_bad).unwrap_or(f64::NAN);
    Err(if got.is_finite() {
        Error::Item {
            what,
            index,
            expected: "coordinates from -2^500 to 2^500 (3.27e150)",
            got,
        }
    } else {
        Error::NotFinite { what, index, got }
    })
}

/// The images of points under an affine map.
///
/// # Errors
/// As [`check_points`] for the images.
pub(crate) fn images<P: Point>(points: &[P], map: &P::Affine) -> Result<Vec<P>, Error> {
    let images: Vec<P> = points.iter().map(|p| p.transform(map)).collect();
    check_points("image", &images)?;
    Ok(images)
}

/// The image of an operator, which cannot return an error.
///
/// # Panics
/// For an image beyond the limit of coordinates.
#[allow(
    clippy::panic,
    reason = "the documented panic of the operators that apply a map"
)]
#[track_caller]
pub(crate) fn expect_image<T>(image: Result<T, Error>) -> T {
    image.unwrap_or_else(|error| panic!("{error}"))
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

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    #[test]
    fn the_limit_is_a_power_of_two() {
        assert_eq!(MAX_COORDINATE, 2_f64.powi(500));
        assert!(check_points("points", &[DVec2::splat(MAX_COORDINATE)]).is_ok());
        assert!(check_points("points", &[DVec2::splat(1.01 * MAX_COORDINATE)]).is_err());
        assert_eq!(
            clamp_to_limit(DVec2::new(f64::INFINITY, f64::NAN)),
            DVec2::new(MAX_COORDINATE, 0.0)
        );
    }
}
