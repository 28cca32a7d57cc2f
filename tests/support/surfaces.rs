//! Surfaces of the test data: the tea set, which is part of the project, and Gumbo, which is not.

use super::golden::{golden, shared};
use casteljau::Surface;
use casteljau::glam::DVec3;
use serde_json::Value;

/// A surface of `tests/data`.
pub(crate) fn listing(name: &str) -> Surface {
    surface(&golden(name))
}

/// Gumbo; `None`, and the test is reported as skipped, where the file is absent.
pub(crate) fn gumbo() -> Option<Surface> {
    shared("gumbo").as_ref().map(surface)
}

fn surface(data: &Value) -> Surface {
    let list = |name: &str| data[name].as_array().unwrap().clone();
    let vertices = list("vertices").into_iter().map(|p| {
        let [x, y, z] = [0, 1, 2].map(|axis| p[axis].as_f64().unwrap());
        DVec3::new(x, y, z)
    });
    let patches = list("patches").into_iter();
    let indices = patches.flat_map(|net| net.as_array().unwrap().clone());
    let indices = indices.map(|i| u32::try_from(i.as_u64().unwrap()).unwrap());
    Surface::new(vertices.collect(), indices.collect(), 3, 3).unwrap()
}
