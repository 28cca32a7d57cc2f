//! Crack-free meshes: the guarantees of `tessellate` on well-known surfaces, on random ones and for invalid input.
#![cfg(not(target_family = "wasm"))]

#[path = "../allocations/mod.rs"]
mod allocations;
mod checks;
#[path = "../common/mod.rs"]
mod common;
mod distance;
mod figures;
mod folds;
#[path = "../golden/mod.rs"]
mod golden;
mod known;
mod limits;
#[path = "../listings/mod.rs"]
mod listings;
mod metamorphic;
mod moved;
mod networks;
mod pixels;
mod random;
mod refusals;
mod shapes;
mod soup;
mod weld;

/// CASTELJAU_DEEP=1 selects finer meshes and many more surfaces.
fn deep() -> bool {
    std::env::var_os("CASTELJAU_DEEP").is_some_and(|value| value != "0")
}

/// The number of cases: fewer by default.
fn thorough(by_default: usize, when_deep: usize) -> usize {
    if deep() {
        when_deep.max(by_default)
    } else {
        by_default
    }
}
