//! Bindings of parallel curves. Splines lie in the arena as in `spline`.

use super::arena::{self, Arena};
use super::given;
use crate::curve::{Chain, Curve};
use glam::DVec2;
use wasm_bindgen::prelude::wasm_bindgen;

/// Leaves a chain as a spline; its number of f64.
fn put(a: &mut Arena, chain: &Chain) -> usize {
    let closed = f64::from(u8::from(chain.closed));
    let mut at = a.put_numbers(0, &[chain.degrees.len() as f64, closed]);
    for &degree in &chain.degrees {
        at = a.put_numbers(at, &[degree as f64]);
    }
    a.put_numbers(at, bytemuck::cast_slice(&chain.points))
}

/// Leaves the parallel of a curve of the plane as a spline; a tolerance of 0 stands for the default.
#[wasm_bindgen]
pub fn curve_offset(count: usize, distance: f64, tolerance: f64) -> isize {
    arena::answer(|a| {
        let curve = Curve::<DVec2>::from_slice(a.points(0, count));
        let chain = curve.parallel(distance, given(tolerance))?;
        Ok(put(a, &chain))
    })
}
