//! Crack-free meshes: the guarantees of `tessellate` on well-known surfaces, on random ones and for invalid input.

mod checks;
mod distance;
mod figures;
mod folds;
mod known;
mod limits;
mod metamorphic;
mod moved;
mod networks;
mod pixels;
mod random;
mod refusals;
mod shapes;
mod soup;
mod weld;
