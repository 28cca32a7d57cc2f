//! The Rust samples of the API reference as tests, made by build.rs.
#![cfg(test)]
#![allow(
    unused_imports,
    clippy::all,
    reason = "samples are written for readers; each uses some of the names"
)]
use casteljau::glam::{DAffine2, DAffine3, DMat4, DVec2, DVec3};
use casteljau::{
    Curve, Easing, Mesh, NurbsCurve, NurbsSurface, Patch, Path, RationalCurve, RationalPatch,
    RationalSurface, Spline, Surface,
};
use std::cell::RefCell;

thread_local! {
    static PRINTED: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

/// Collects what samples print.
macro_rules! println {
    ($($text:tt)*) => {
        print(&format!($($text)*))
    };
}

fn print(text: &str) {
    PRINTED.with_borrow_mut(|printed| printed.extend(text.lines().map(str::to_owned)));
}

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn check(expected: &[&str], sample: impl FnOnce() -> Outcome) {
    sample().expect("a sample without an error");
    assert_eq!(PRINTED.take(), expected);
}

include!(concat!(env!("OUT_DIR"), "/samples.rs"));
