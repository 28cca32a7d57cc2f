//! Paths: SVG path data in and out, what is inside, how large they are.
#![cfg(not(target_family = "wasm"))]

#[path = "../common/mod.rs"]
mod common;
mod table;
