//! Crack-free meshes: the guarantees of `tessellate` on well-known surfaces, on random ones and for invalid input.

pub(crate) mod checks;
mod distance;
pub(crate) mod figures;
mod folds;
pub(crate) mod known;
pub(crate) mod limits;
pub(crate) mod metamorphic;
mod moved;
mod networks;
mod pixels;
mod random;
mod refusals;
pub(crate) mod shapes;
pub(crate) mod soup;
pub(crate) mod weld;
