//! The bindings: numbers in, numbers out, through one arena of f64 (see `arena`).
//!
//! Each function decodes, calls the core and encodes. The JavaScript classes in `js/` have checked every argument
//! before; what is left to refuse comes back from the core as an [`Error`](crate::Error) and becomes a `RangeError`. Only
//! numbers cross the border, and the targets of drawing: code for strings and objects would be a third of the module.
//! `dimension` is 2 or 3; a result that is a number of f64 says how far the arena is filled.

#![allow(
    unsafe_code,
    reason = "the macros of wasm_bindgen, and statics of a module that has one thread"
)]
#![allow(
    unreachable_pub,
    reason = "exports must be pub, though no Rust caller reaches them"
)]

mod arena;
mod canvas;
mod curve;
mod decode_surface;
mod intersections;
mod lines;
mod measure;
mod mesh;
mod nearest;
mod offset;
mod path;
mod queries;
mod single_thread_cell;
mod spline;
mod spline_forms;
mod surface;

/// Small before fast: results are few and large, and the allocator of std would be a sixteenth of the module.
#[cfg(target_family = "wasm")]
#[global_allocator]
static ALLOCATOR: talc::wasm::WasmDynamicTalc = talc::wasm::new_wasm_dynamic_allocator();

/// Runs the body with `$P` being the point type of a dimension.
macro_rules! by_dimension {
    ($dimension:expr, $P:ident => $body:expr) => {
        if $dimension == 3 {
            type $P = glam::DVec3;
            $body
        } else {
            type $P = glam::DVec2;
            $body
        }
    };
}
use by_dimension;

/// An optional tolerance: 0 stands for the default.
fn optional(tolerance: f64) -> Option<f64> {
    (tolerance > 0.0).then_some(tolerance)
}
