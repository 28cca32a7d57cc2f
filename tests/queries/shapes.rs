//! Shapes for the queries.

use crate::support::Rng;
use crate::support::nets::{RandomNet, net, patch};
use casteljau::Patch;
use casteljau::glam::{DAffine3, DQuat, DVec3};

/// Numerically difficult patches: points, curves, collapsed edges, folds, and random patches with coincident points.
pub(crate) fn odd_patches() -> Vec<Patch> {
    let nets = [
        net(3, 3, |_, _| DVec3::new(1.0, 2.0, 3.0)),
        net(3, 3, |_, _| DVec3::ZERO),
        net(3, 3, |i, _| DVec3::X * i),
        net(3, 3, |i, j| DVec3::X * (i + j)),
        net(3, 3, |i, j| DVec3::X * (i * j)),
        net(3, 3, |i, j| DVec3::new(i * j, j, 0.0)),
        net(3, 3, |i, j| DVec3::new(i * j, j, i * i * j)),
        net(3, 3, |i, j| DVec3::new(i * (3.0 - i), j * (3.0 - j), 0.0)),
        net(3, 3, |i, j| DVec3::new(i * j * (3.0 - i), j * (3.0 - j), i)),
    ];
    let mut all: Vec<Patch> = nets.iter().map(|net| patch(net, 3, 3)).collect();
    all.extend(random_patches(
        77,
        &[(1, 1), (3, 3), (2, 5), (3, 3), (7, 1)],
    ));
    all
}

pub(crate) fn random_patches(seed: u64, degrees: &[(usize, usize)]) -> Vec<Patch> {
    let mut random = Rng(seed);
    degrees.iter().map(|&(m, n)| random.patch(m, n)).collect()
}

/// The map that rotates about an axis of length 3, scales, and moves.
pub(crate) fn map(axis: [f64; 3], angle: f64, scale: f64, by: f64) -> DAffine3 {
    let turn = DQuat::from_axis_angle(DVec3::from(axis) / 3.0, angle);
    let by = DVec3::splat(by * scale);
    DAffine3::from_scale_rotation_translation(DVec3::splat(scale), turn, by)
}
