//! Bézier curves and surfaces.

#[cfg(feature = "wasm")]
mod wasm;
