//! Surfaces of the data beside the project, which are not part of it.
#![cfg(not(target_family = "wasm"))]

use casteljau::Surface;
use casteljau::glam::DVec3;

/// The surface of that name; `None`, with a message, where the data are not there.
pub(crate) fn listing(name: &str) -> Option<Surface> {
    let path = format!("{}/../shared/data/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let Ok(text) = std::fs::read_to_string(&path) else {
        println!("skipped: {path} is not there");
        return None;
    };
    let data: serde_json::Value = serde_json::from_str(&text).unwrap();
    let list = |name: &str| data[name].as_array().unwrap().clone();
    let vertices = list("vertices").into_iter().map(|p| {
        let [x, y, z] = [0, 1, 2].map(|axis| p[axis].as_f64().unwrap());
        DVec3::new(x, y, z)
    });
    let patches = list("patches").into_iter();
    let indices = patches.flat_map(|net| net.as_array().unwrap().clone());
    let indices = indices.map(|i| u32::try_from(i.as_u64().unwrap()).unwrap());
    Some(Surface::new(vertices.collect(), indices.collect(), 3, 3).unwrap())
}
