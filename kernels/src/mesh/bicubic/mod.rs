//! Grids of bicubic patches: rows are blended in f64, then eight samples at a time are evaluated in f32.

mod fill;
pub mod grid;
mod lanes;
mod normals;
mod positions;
