//! Bézier curves and surfaces.

pub mod curve;
mod error;
mod point;
pub mod spline;
pub mod surface;

#[cfg(feature = "wasm")]
mod wasm;

pub use curve::Curve;
pub use error::{Error, MAX_DEGREE};
pub use glam;
pub use point::{Cross, Point};
pub use spline::Spline;
pub use surface::{Grid, Indices, Mesh, Patch, Surface, TeapotOptions};
