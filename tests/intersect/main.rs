//! Intersections of curves, compared with a slow reference that discards only what is certain, and with known cases.
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
