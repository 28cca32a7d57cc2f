//! The WebAssembly bindings: numbers in, numbers out, through one arena of f64 (see `arena`).
//!
//! Each function decodes its arguments, calls the core and encodes the result. The JavaScript classes in `js/` have
//! checked every argument; an error that only the core can detect is returned as an [`Error`](crate::Error) and becomes
//! a `RangeError`. Only numbers and the targets of drawing cross the FFI boundary: code for strings and objects would
//! be a third of the module. `dimension` is 2 or 3; a function that "returns the number of f64" returns the length of
//! its result in the arena.

#![allow(
    unsafe_code,
    reason = "the macros of wasm_bindgen, and statics of a single-threaded module"
)]
#![allow(
    unreachable_pub,
    reason = "exports must be pub, though no Rust caller reaches them"
)]

mod arc_length;
mod arena;
mod canvas;
mod curve;
mod curve_shape;
mod decode_surface;
mod frames;
mod ink;
mod interpolate;
mod intersect;
mod mesh;
mod nearest;
mod nurbs;
mod nurbs_surface;
mod offset;
mod patch;
mod path;
mod rational;
mod rational_surface;
mod region;
mod single_thread_cell;
mod spline;
mod surface;
mod wireframe;

/// A small allocator: results are few and large, and the allocator of std would be a sixteenth of the module.
#[cfg(target_family = "wasm")]
#[global_allocator]
static ALLOCATOR: talc::wasm::WasmDynamicTalc = talc::wasm::new_wasm_dynamic_allocator();

/// Expands the body with `$P` as the point type of the dimension.
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

/// Decodes an optional tolerance: 0 stands for the default.
fn optional(tolerance: f64) -> Option<f64> {
    (tolerance > 0.0).then_some(tolerance)
}

/// The result with a tolerance, or without one if it is 0.
fn within<T>(
    tolerance: f64,
    plain: impl FnOnce() -> T,
    with: impl FnOnce(f64) -> Result<T, crate::Error>,
) -> Result<T, crate::Error> {
    optional(tolerance).map_or_else(|| Ok(plain()), with)
}
