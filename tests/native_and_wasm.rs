//! Tests that run natively and as wasm in Node (`#[wasm_bindgen_test(unsupported = test)]`).

mod constructors;
mod curve;
mod easing;
mod queries;
mod spline;
mod support;
mod surface;
mod wires;
