//! Shapes to ask about.

use crate::nets::Random;
use casteljau::glam::DVec3;
use casteljau::{Patch, Surface, TeapotOptions};

pub(crate) fn teapot() -> Surface {
    Surface::teapot(TeapotOptions::default())
}

/// A surface of the shared data; `None`, with a message, where they are not there.
#[cfg(not(target_family = "wasm"))]
pub(crate) fn shared(name: &str) -> Option<Surface> {
    let path = format!("{}/../shared/data/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let Ok(text) = std::fs::read_to_string(&path) else {
        println!("skipped: {path} is not there");
        return None;
    };
    let data: serde_json::Value = serde_json::from_str(&text).unwrap();
    let list = |name: &str| data[name].as_array().unwrap().clone();
    let vertices = list("vertices")
        .iter()
        .map(|p| DVec3::from([0, 1, 2].map(|axis| p[axis].as_f64().unwrap())))
        .collect();
    let indices = list("patches")
        .iter()
        .flat_map(|net| net.as_array().unwrap().clone())
        .map(|index| u32::try_from(index.as_u64().unwrap()).unwrap())
        .collect();
    Some(Surface::new(vertices, indices, 3, 3).unwrap())
}

/// Patches on which numbers break: points, curves, collapsed sides, folds, and random ones with coincident points.
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
    let mut random = Random(77);
    all.extend([(1, 1), (3, 3), (2, 5), (3, 3), (7, 1)].map(|(m, n)| random.patch(m, n)));
    all
}

/// The points of a fine lattice of parameters.
pub(crate) fn samples(count: u32) -> impl Iterator<Item = (f64, f64)> {
    let t = move |i: u32| f64::from(i) / f64::from(count);
    (0..=count).flat_map(move |j| (0..=count).map(move |i| (t(i), t(j))))
}
