//! Tests that run natively only: they need threads, files or packages that do not build for wasm32, or they take long.
#![cfg(not(target_family = "wasm"))]

mod arc;
mod composition;
mod facts;
mod flatten;
mod gumbo;
mod intersect;
mod offset;
mod parallel;
mod patch_work;
mod path;
mod path_boolean;
mod points;
mod rational;
mod samples;
mod stroke;
mod support;
mod watertight;
