//! Arc length up to a parameter, and the parameter at a given arc length.

pub(crate) mod integral;
pub(crate) mod inverse;
pub(crate) mod length;

#[cfg(not(feature = "wasm"))]
pub(crate) mod plane_cubic;
#[cfg(not(feature = "wasm"))]
pub(crate) mod speed;
#[cfg(feature = "wasm")]
pub(crate) use casteljau_fast::curve::arc_length::{plane_cubic, speed};
