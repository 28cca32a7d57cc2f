//! Bindings of surfaces of rational patches. Arguments: a surface (see `surface.rs`), a weight for each index of all nets; further
//! arguments follow.

use super::arena;
use super::arena::Arena;
use super::decode_surface;
use super::mesh::{keep, options, write_topology};
use crate::geometry::error::Error;
use crate::rational::RationalSurface;
use wasm_bindgen::prelude::wasm_bindgen;

/// The surface at the start of the arena, and the index where it ends.
fn surface(a: &Arena) -> Result<(RationalSurface, usize), Error> {
    let (network, at) = decode_surface::surface(a)?;
    let end = at + network.indices().len();
    let weights = a.numbers(at, end - at).to_vec();
    Ok((RationalSurface::weighted(network, weights)?, end))
}

/// As `surface_tessellate`.
#[wasm_bindgen]
pub fn rationalsurface_tessellate(kind: u32, a: f64, b: f64, weld: u32, precise: bool) -> isize {
    arena::answer(|arena| {
        let (surface, end) = surface(arena)?;
        let options = options(arena, end, kind, [a, b], weld);
        keep(
            precise,
            || surface.tessellate(&options),
            || surface.tessellate_f64(&options),
        )
    })
}

/// As `surface_topology`.
#[wasm_bindgen]
pub fn rationalsurface_topology() -> isize {
    arena::answer(|a| {
        let topology = surface(a)?.0.topology();
        Ok(write_topology(a, topology))
    })
}
