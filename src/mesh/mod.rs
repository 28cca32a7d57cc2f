//! Triangle meshes of patches and surfaces.
//!
//! A [`Grid`] is the layout of samples without points; a [`Mesh`] consists of buffers. A mesh by a number of segments
//! is one grid for each patch; a mesh by a tolerance or by pixels is subdivided adaptively. Both are free of cracks. A
//! surface can also be drawn as the tubes or ribbons of its isocurves.
//!
//! In the kernels, for their speed: grids of bicubic patches, rows of samples, bounds of second differences, the triangles of a cell.

pub(crate) mod adaptive;
pub(crate) mod buffers;
mod cut;
mod edge_samples;
mod flat_enough;
mod forward;
pub(crate) mod generic_grid_evaluator;
pub(crate) mod grid;
mod grid_evaluator;
pub(crate) mod grid_mesh;
mod gridded;
pub(crate) mod isocurves;
pub(crate) mod mesh_patch;
pub(crate) mod options;
mod projected;
mod sampler;
mod stitched_mesh;
mod subdivider;
mod sweep;
mod tracer;
pub(crate) mod weld;
pub(crate) mod wire;
pub(crate) mod wireframe;

pub use buffers::{Indices, Mesh, PatchRange};
pub use flat_enough::FlatPiece;
pub use grid::{Grid, GridMethod};
pub use options::{Detail, TessellationOptions, View, Weld};
pub use wire::{Wire, WireframeOptions};
