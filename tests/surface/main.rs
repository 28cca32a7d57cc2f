//! Patches, surfaces and meshes, natively and in wasm.

mod bicubic;
#[cfg(not(target_family = "wasm"))]
mod export;
mod flat_enough;
mod forward;
#[path = "../golden/mod.rs"]
mod golden;
mod grid;
#[cfg(not(target_family = "wasm"))]
mod large;
#[cfg(not(target_family = "wasm"))]
mod limit_normals;
#[path = "../listings/mod.rs"]
mod listings;
#[path = "../nets/mod.rs"]
mod nets;
mod patch;
#[cfg(all(feature = "serde", not(target_family = "wasm")))]
mod serde;
mod teapot;
mod teaset;
#[cfg(not(target_family = "wasm"))]
mod text;
mod wireframe;
