//! Bézier patches and surfaces made of them.
//!
//! A patch is a curve of curves: its net of control points has rows, each row is a curve in u, and the points of these
//! curves at one u are the control points of a curve in v. A surface is a network of patches that share control
//! points. A mesh is what a graphics card draws in their place.
//!
//! Three things are kept apart: a [`Grid`] knows the layout of samples and no points, a [`Patch`] knows points and no
//! buffers, a [`Mesh`] is buffers and nothing else.

mod grid;
mod kernel;
mod mesh;
mod net;
mod network;
mod normal;
mod patch;
mod pieces;
mod projected;
mod sets;
mod sides;
mod teacup_data;
mod teapot_data;
mod teaset;
mod teaspoon_data;
mod tessellate;
mod wireframe;

pub use grid::Grid;
pub use mesh::{Indices, Mesh, PatchRange};
pub use network::Surface;
pub use patch::{Partials, Patch};
pub use sets::{Height, TeapotOptions, Up};
