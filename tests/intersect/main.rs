//! Where curves meet: against a slow reference that throws away nothing it is not sure of, and against what is known.
#![cfg(not(target_family = "wasm"))]

#[path = "../common/mod.rs"]
mod common;

mod adversarial;
mod covering;
mod generate;
mod known;
mod metamorphic;
mod random;
mod reference;
mod reported;
mod selves;
mod splines;
