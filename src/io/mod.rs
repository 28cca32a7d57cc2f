//! Text and file formats: SVG path data, the text forms of surfaces, and meshes as OBJ, STL and GLB.

mod file_size;
mod glb;
mod mesh_export;
mod surface_arrays;
mod surface_text;
mod svg_arcs;
pub(crate) mod svg_error;
pub(crate) mod svg_number;
mod svg_read;
pub(crate) mod svg_write;
pub(crate) mod text_reader;
pub(crate) mod text_write;
