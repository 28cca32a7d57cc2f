//! Special points of curves: nearest points, extrema, inflections, cusps, times at a coordinate, distances between
//! curves.

mod apart;
mod classes;
mod nearest;
mod turns;
mod work;

use crate::support::adversarial::{self, Kind};
use crate::support::{Rng, real};
use casteljau::glam::DVec3;

/// The number of random cases for a property.
fn cases() -> usize {
    crate::support::cases(20_000, 1_000_000)
}

/// Hostile control points of degree 1 to 4, sometimes up to 16; z = 0 for plane curves.
fn hostile(rng: &mut Rng, kinds: &[Kind], dimension: usize) -> Vec<DVec3> {
    let kind = rng.pick(kinds);
    let degree = if rng.chance(0.05) {
        5 + rng.below(12)
    } else {
        rng.pick(&[1, 2, 2, 3, 3, 3, 3, 4])
    };
    adversarial::points(rng, kind, degree, dimension)
}

/// The maximum distance of a point from the first one, at least a subnormal number.
fn extent(points: &[DVec3]) -> f64 {
    points
        .iter()
        .map(|&p| (p - points[0]).abs().max_element())
        .fold(f64::MIN_POSITIVE, f64::max)
}

/// i/n for i = 0 … n.
fn steps(n: usize) -> impl Iterator<Item = f64> {
    (0..=n).map(move |i| real(i) / real(n))
}
