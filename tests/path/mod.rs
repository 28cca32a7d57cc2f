//! Paths: reading and writing SVG path data, winding numbers, measurements.

mod arcs;
mod builder;
mod convert;
mod inside;
mod kurbo;
#[cfg(not(target_family = "wasm"))]
mod large;
mod sizes;
mod svg;
mod table;
mod texts;
