//! Surfaces: networks of Bézier patches that share control points.

mod descent;
pub(crate) mod distance;
mod extent;
pub(crate) mod hash_index;
mod measure;
pub(crate) mod minimum;
pub(crate) mod nearest;
pub(crate) mod network;
mod newton;
pub(crate) mod piece;
pub(crate) mod query_patch;
mod queued_piece;
pub(crate) mod ray;
pub(crate) mod scaling;
pub(crate) mod small_distance;
pub(crate) mod surface_point;
pub(crate) mod topology;
mod zeros;

#[cfg(feature = "io")]
pub use crate::io::text_reader::ParseError;
pub use network::Surface;
pub use surface_point::SurfacePoint;
pub use topology::{EdgeUse, PatchEdge, Topology};
