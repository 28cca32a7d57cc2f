//! Paths: reading and writing SVG path data, winding numbers, measurements.

mod arcs;
mod builder;
mod convert;
mod evaluate;
mod inside;
mod kurbo;
#[cfg(not(target_family = "wasm"))]
mod large;
mod refusals;
mod shapes;
mod sizes;
mod svg;
mod table;
mod texts;
mod to_arcs;
