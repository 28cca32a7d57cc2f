//! Text and file formats: SVG path data, the text forms of surfaces, and meshes as OBJ, STL and GLB.

#[cfg(feature = "surfaces")]
mod file_size;
#[cfg(feature = "surfaces")]
mod glb;
#[cfg(feature = "surfaces")]
mod mesh_export;
#[cfg(feature = "surfaces")]
mod surface_arrays;
#[cfg(feature = "surfaces")]
mod surface_text;
mod svg_arcs;
pub(crate) mod svg_error;
pub(crate) mod svg_number;
mod svg_read;
pub(crate) mod svg_write;
#[cfg(feature = "surfaces")]
pub(crate) mod text_reader;
