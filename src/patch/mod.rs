//! Tensor-product Bézier patches.
//!
//! The control net of a patch has rows. Each row is a curve in u, and the points of these curves at one u are the
//! control points of a curve in v.

mod area;
pub(crate) mod curvature;
mod de_casteljau;
mod flatness;
pub(crate) mod net;
pub(crate) mod normal;
pub(crate) mod patch_point;
mod split;
pub(crate) mod taylor;
pub(crate) mod tensor_product;
pub(crate) mod tile_area;

pub use curvature::Curvature;
pub use de_casteljau::PatchDeCasteljau;
pub use patch_point::PatchPoint;
pub use tensor_product::{Partials, Patch};
