//! Tests that run natively and as wasm in Node, where the attribute `test` is `wasm_bindgen_test`.

mod constructors;
mod curve;
mod easing;
mod queries;
mod spline;
mod support;
mod surface;
mod wires;
