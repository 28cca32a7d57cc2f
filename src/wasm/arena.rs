//! The arena: one block of f64 in wasm memory through which all numbers pass both ways.
//!
//! JavaScript writes the control points at its start, calls, and reads the result from its start. Nothing is
//! allocated on the small calls; bulk results grow it, and JavaScript then asks for the address again.

use std::cell::RefCell;
use wasm_bindgen::prelude::wasm_bindgen;

/// Enough for the scaffold of a curve of degree 64 in 3D (65·66/2 points), the largest small result.
const LEAST_LENGTH: usize = 8192;

thread_local! {
    static ARENA: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

/// Makes the arena hold at least `length` numbers and returns its address.
#[wasm_bindgen]
pub fn arena_reserve(length: usize) -> *const f64 {
    ARENA.with_borrow_mut(|arena| {
        if arena.len() < length.max(LEAST_LENGTH) {
            arena.resize(length.max(LEAST_LENGTH), 0.0);
        }
        arena.as_ptr()
    })
}

/// The number of f64 that the arena holds.
#[wasm_bindgen]
pub fn arena_length() -> usize {
    ARENA.with_borrow(Vec::len)
}
