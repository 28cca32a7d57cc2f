//! Shapes for the queries.

use crate::support::Rng;
use crate::support::nets::RandomNet;
use casteljau::glam::DVec3;
use casteljau::{Patch, Surface, TeapotOptions};

pub(crate) fn teapot() -> Surface {
    Surface::teapot(TeapotOptions::default())
}

/// Numerically difficult patches: points, curves, collapsed edges, folds, and random patches with coincident points.
pub(crate) fn odd_patches() -> Vec<Patch> {
    let patch = |f: &dyn Fn(f64, f64) -> DVec3| {
        let net: Vec<DVec3> = (0..16)
            .map(|k| f(f64::from(k % 4), f64::from(k / 4)))
            .collect();
        Patch::new(&net, 3, 3).unwrap()
    };
    let mut all = vec![
        patch(&|_, _| DVec3::new(1.0, 2.0, 3.0)),
        patch(&|_, _| DVec3::ZERO),
        patch(&|i, _| DVec3::X * i),
        patch(&|i, j| DVec3::X * (i + j)),
        patch(&|i, j| DVec3::X * (i * j)),
        patch(&|i, j| DVec3::new(i * j, j, 0.0)),
        patch(&|i, j| DVec3::new(i * j, j, i * i * j)),
        patch(&|i, j| DVec3::new(i * (3.0 - i), j * (3.0 - j), 0.0)),
        patch(&|i, j| DVec3::new(i * j * (3.0 - i), j * (3.0 - j), i)),
    ];
    let mut random = Rng(77);
    all.extend([(1, 1), (3, 3), (2, 5), (3, 3), (7, 1)].map(|(m, n)| random.patch(m, n)));
    all
}

/// The points of a fine grid of parameters.
pub(crate) fn samples(count: u32) -> impl Iterator<Item = (f64, f64)> {
    let t = move |i: u32| f64::from(i) / f64::from(count);
    (0..=count).flat_map(move |j| (0..=count).map(move |i| (t(i), t(j))))
}
