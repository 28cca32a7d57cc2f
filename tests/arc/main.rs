//! Length, even steps, area, moments, torsion and frames: judged by closed forms and by slow references of their own.

mod area;
#[path = "../common/mod.rs"]
mod common;
mod even;
mod frames;
mod length;

/// CASTELJAU_DEEP=1 asks for many more cases.
fn thorough(usual: usize, deep: usize) -> usize {
    if std::env::var_os("CASTELJAU_DEEP").is_some_and(|value| value != "0") {
        deep
    } else {
        usual
    }
}
