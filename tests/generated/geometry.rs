//! Geometry that is independent of the library, and the slack for rounding.

use crate::check::Metric;
use casteljau::curve::Bounds;
use casteljau::{Path, Point};
pub(crate) use casteljau_generator::real;

/// The slack for coordinates of points on curves of a degree: 16 (n + 2) units of rounding of the largest coordinate.
pub(crate) fn slack(size: f64, degree: usize) -> f64 {
    16.0 * real(degree + 2) * f64::EPSILON * size + f64::MIN_POSITIVE
}

/// The factor by which a parameter outside [0, 1] enlarges coordinates and their rounding errors: (|t| + |1 − t|)ⁿ.
pub(crate) fn growth(t: f64, degree: usize) -> f64 {
    (t.abs() + (1.0 - t).abs()).powi(i32::try_from(degree).expect("a degree"))
}

/// The largest absolute coordinate.
pub(crate) fn largest<P: Point>(points: &[P]) -> f64 {
    max(points.iter().map(|p| p.max_abs()))
}

/// The largest of numbers that are not negative; 0 if there is none.
pub(crate) fn max(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, f64::max)
}

/// The smallest of numbers; infinite if there is none.
pub(crate) fn min(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(f64::INFINITY, f64::min)
}

/// The distance of a point from the nearest of others.
pub(crate) fn from_nearest<P: Metric>(p: P, others: impl IntoIterator<Item = P>) -> f64 {
    min(others.into_iter().map(|other| p.distance(other)))
}

/// The sum of the lengths of a polygon.
pub(crate) fn polygon_length<P: Metric>(points: &[P]) -> f64 {
    points.windows(2).map(|w| w[0].distance(w[1])).sum()
}

/// The distance of a point from a segment.
pub(crate) fn from_segment<P: Point>(p: P, a: P, b: P) -> f64 {
    let (along, away) = (b - a, p - a);
    let square = along.dot(along);
    let s = if square > 0.0 {
        (away.dot(along) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (away - along * s).norm()
}

/// Whether a bounding box contains a point within a slack.
pub(crate) fn holds<P: Point>(bounds: &Bounds<P>, p: P, slack: f64) -> bool {
    (0..P::DIMENSION).all(|axis| {
        let [x, min, max] = [p, bounds.min, bounds.max].map(|p| p.coordinate(axis));
        x >= min - slack && x <= max + slack
    })
}

/// The box of points.
pub(crate) fn box_of<P: Point>(points: impl IntoIterator<Item = P>) -> Option<Bounds<P>> {
    let boxes = points.into_iter().map(|p| Bounds { min: p, max: p });
    boxes.reduce(|a, b| Bounds {
        min: a.min.min(b.min),
        max: a.max.max(b.max),
    })
}

/// `steps` + 1 parameters from 0 to `end`.
pub(crate) fn parameters(steps: usize, end: f64) -> impl Iterator<Item = f64> + Clone {
    (0..=steps).map(move |k| end * real(k) / real(steps))
}

/// The parameters of the points of a grid on a patch.
pub(crate) fn locations(steps: usize) -> impl Iterator<Item = (f64, f64)> + Clone {
    parameters(steps, 1.0).flat_map(move |v| parameters(steps, 1.0).map(move |u| (u, v)))
}

/// Whether numbers are strictly increasing within [min, max].
pub(crate) fn ascends(ts: &[f64], min: f64, max: f64) -> bool {
    ts.windows(2).all(|w| w[0] < w[1]) && ts.iter().all(|t| (min..=max).contains(t))
}

/// Whether a path that was read is the one that was written as a text; arcs are read up to rounding.
pub(crate) fn is_read_back(back: &Path, path: &Path, text: &str) -> bool {
    let bounds = path.control_bounds();
    let largest = bounds.map_or(0.0, |b| b.min.abs().max(b.max.abs()).max_element());
    back == path || (text.contains('A') && back.approx_eq(path, 1e-13 * largest))
}
