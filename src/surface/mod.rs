//! Bézier patches and surfaces made of them.
//!
//! A patch is a curve of curves: its net of control points has rows, each row is a curve in u, and the points of these
//! curves at one u are the control points of a curve in v. A surface is a network of patches that share control
//! points. A mesh is what a graphics card draws in their place.
//!
//! Three things are kept apart: a [`Grid`] knows the layout of samples and no points, a [`Patch`] knows points and no
//! buffers, a [`Mesh`] is buffers and nothing else.

mod area;
mod curvature;
mod de_casteljau;
mod distance;
mod export;
mod extent;
mod first_of;
mod flat_enough;
mod flatness;
mod forward;
mod frame;
mod generic_grid_evaluator;
mod glb;
mod grid;
mod grid_evaluator;
mod gridded;
mod measure;
mod mesh;
mod minimum;
mod nearest;
mod net;
mod network;
mod newton;
mod normal;
mod patch;
mod piece;
mod pieces;
mod projected;
mod ray;
mod refine;
mod sampler;
mod sets;
mod small_distance;
mod stitched_mesh;
mod subdivider;
mod sweep;
mod taylor;
mod teacup_data;
mod teapot_data;
mod teaset;
mod teaspoon_data;
mod tessellate;
mod text;
mod text_reader;
mod text_write;
mod tile_area;
mod topology;
mod tracer;
mod view;
mod waiting;
mod weld;
mod wireframe;
mod wires;
mod zeros;

pub use curvature::Curvature;
pub use de_casteljau::PatchDeCasteljau;
#[cfg(feature = "wasm")]
pub(crate) use first_of::joined;
pub use flat_enough::FlatPiece;
pub use grid::{Grid, GridMethod};
pub use mesh::{Indices, Mesh, PatchRange};
pub use nearest::{PatchPoint, SurfacePoint};
pub use network::Surface;
pub use patch::{Partials, Patch};
pub use sets::{Height, TeapotOptions, Up};
#[cfg(feature = "wasm")]
pub(crate) use tessellate::GridMeshBuilder;
pub use text_reader::ParseError;
pub(crate) use text_reader::{END as END_OF_TEXT, shown as shown_word};
pub(crate) use text_write::written_number;
pub use topology::{EdgeUse, PatchEdge, Topology};
pub use view::{Detail, TessellationOptions, View};
pub use weld::Weld;
pub use wires::{Wire, WireframeOptions};
