//! Results that remain exact beyond a limit: of steps, and of very different sizes along the axes.

use super::{SEARCH, distance_of_own_point, generated};
use crate::support::Rng;
use crate::support::nets::RandomNet;
use casteljau::glam::DVec3;
use casteljau::take_steps;
use casteljau::{Error, Patch, Surface};

/// Beyond the limit no other piece and no other patch is counted.
#[test]
fn of_subdivision_beyond_the_limit() {
    let patch = Rng(5).patch(24, 24);
    let vertices = patch.control_points().to_vec();
    let size = patch.control_bounds().max.abs().max_element();
    let twice = (0..625).chain(0..625).collect();
    let surface = Surface::new(vertices, twice, 24, 24).unwrap();
    take_steps();
    let outcome = surface.subdivide(1e-9 * size);
    assert!(matches!(outcome, Err(Error::TooMany { .. })));
    assert!(take_steps() <= (1 << 24) + 2 * 128 * 25 * 25 + 25 * 25);
}

/// However long a patch is along one axis, its bounding box is exact along the others. Here y has two minima, and the
/// smaller one is not the one below the smaller corner.
#[test]
fn of_bounds_along_short_axes() {
    let heights = [0.0, -1.0, 3.0, 3.0, -4.0, 1.0];
    for length in [1.0, 1e8, 1e16, 1e24] {
        let row = |z: f64| heights.map(|y| DVec3::new(0.0, y, z));
        let patch = Patch::new([row(0.0), row(length)].as_flattened(), 5, 1).unwrap();
        let bounds = patch.bounds();
        let y = |k| patch.eval(f64::from(k) / 1000.0, 0.5).y;
        let ys: Vec<f64> = (0..=1000).map(y).collect();
        let lowest = ys.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = ys.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let [min, max] = [bounds.min.y, bounds.max.y];
        for gap in [lowest - min, max - highest] {
            assert!((-1e-14..1e-4).contains(&gap), "{length}: {gap}");
        }
    }
}

/// Nets of sizes from 1e-12 to 1e15 for which the search by squared distances reaches its limit; the search by
/// distances finds the points.
#[test]
fn of_points_of_patches_beyond_the_limit() {
    for seed in [6118, 11354, 16861, 17459, 31891, 36682] {
        let (mut random, patch) = generated(seed);
        take_steps();
        let (distance, steps) = distance_of_own_point(&mut random, &patch);
        assert!(steps > SEARCH, "seed {seed}: only {steps} steps");
        assert!(distance <= 4e-7, "seed {seed}: {distance}");
    }
}
