//! Arc length, equidistant parameters, area, moments, torsion and frames, compared with closed forms and slow
//! references.

mod area;
#[path = "../common/mod.rs"]
mod common;
mod even;
mod frames;
mod length;

/// The number of cases; CASTELJAU_DEEP=1 selects the larger one.
fn thorough(usual: usize, deep: usize) -> usize {
    if std::env::var_os("CASTELJAU_DEEP").is_some_and(|value| value != "0") {
        deep
    } else {
        usual
    }
}
