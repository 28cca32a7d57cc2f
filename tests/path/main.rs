//! Paths: reading and writing SVG path data, winding numbers, measurements.
#![cfg(not(target_family = "wasm"))]

#[path = "../allocations/mod.rs"]
mod allocations;
mod arcs;
mod builder;
#[path = "../common/mod.rs"]
mod common;
mod convert;
mod inside;
mod kurbo;
#[cfg(not(target_family = "wasm"))]
mod large;
mod sizes;
mod svg;
mod table;
mod texts;
