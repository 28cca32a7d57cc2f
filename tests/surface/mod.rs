//! Patches, surfaces and meshes, natively and in wasm.

mod bicubic;
#[cfg(not(target_family = "wasm"))]
mod export;
mod flat_enough;
mod forward;
mod grid;
#[cfg(not(target_family = "wasm"))]
mod large;
mod patch;
#[cfg(all(feature = "serde", not(target_family = "wasm")))]
mod serde;
mod teapot;
mod teaset;
#[cfg(not(target_family = "wasm"))]
mod text;
mod wireframe;
