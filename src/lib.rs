//! Bézier curves and surfaces.

pub mod curve;
mod error;
mod point;

#[cfg(feature = "wasm")]
mod wasm;

pub use curve::Curve;
pub use error::{Error, MAX_DEGREE};
pub use glam;
pub use point::{Cross, Point};
