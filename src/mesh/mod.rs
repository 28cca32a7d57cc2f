//! Triangle meshes of patches and surfaces.
//!
//! A [`Grid`] knows the layout of samples and no points; a [`Mesh`] is buffers and nothing else. Meshes by a number of
//! segments are one grid for each patch; meshes by a tolerance or by pixels are subdivided adaptively, and either is free of
//! cracks. A surface can also be drawn as the tubes or ribbons of its isocurves.

pub(crate) mod adaptive;
pub(crate) mod buffers;
mod flat_enough;
mod forward;
mod generic_grid_evaluator;
pub(crate) mod grid;
mod grid_evaluator;
pub(crate) mod grid_mesh;
mod gridded;
mod isocurves;
pub(crate) mod options;
mod projected;
mod sampler;
mod stitched_mesh;
mod subdivider;
mod sweep;
mod tracer;
pub(crate) mod weld;
pub(crate) mod wire;
mod wireframe;

pub use buffers::{Indices, Mesh, PatchRange};
pub use flat_enough::FlatPiece;
pub use grid::{Grid, GridMethod};
pub use options::{Detail, TessellationOptions, View};
pub use weld::Weld;
pub use wire::{Wire, WireframeOptions};
