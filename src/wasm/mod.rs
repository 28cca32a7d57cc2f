//! The bindings: plain numbers in, plain numbers out, through one arena of f64 (see `arena`).
//!
//! Each function decodes, calls the core and encodes. The JavaScript classes in `js/` have checked every
//! argument before; what is left to refuse comes back from the core as an [`Error`](crate::Error).

#![allow(
    unsafe_code,
    reason = "the wasm_bindgen macros expand to exported unsafe functions"
)]
#![allow(
    unreachable_pub,
    reason = "wasm_bindgen exports must be pub, though no Rust caller reaches them"
)]

mod arena;
