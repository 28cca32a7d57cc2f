//! What the tests share: random numbers, hostile curves and nets, exact arithmetic and slow methods as references.
#![allow(dead_code, reason = "each test binary uses a part of it")]

#[cfg(not(target_family = "wasm"))]
pub(crate) mod allocations;
pub(crate) mod exact;
#[cfg(not(target_family = "wasm"))]
pub(crate) mod golden;
pub(crate) mod integral;
pub(crate) mod measure;
pub(crate) mod nets;
#[cfg(not(target_family = "wasm"))]
pub(crate) mod paths;
#[cfg(not(target_family = "wasm"))]
pub(crate) mod surfaces;
pub(crate) mod threads;

use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Point};
pub(crate) use casteljau_generator::{Rng, adversarial};
use std::fmt::{Debug, Display};

/// The plane or space; points are made from three coordinates.
pub(crate) trait Space: Point {
    fn of(p: DVec3) -> Self;
}

impl Space for DVec2 {
    fn of(p: DVec3) -> Self {
        p.truncate()
    }
}

impl Space for DVec3 {
    fn of(p: DVec3) -> Self {
        p
    }
}

pub(crate) fn curve<P: Space>(points: &[DVec3]) -> Curve<P> {
    let points: Vec<P> = points.iter().map(|&p| P::of(p)).collect();
    Curve::new(&points).expect("finite points")
}

/// A plane curve from pairs.
pub(crate) fn plane(points: &[(f64, f64)]) -> Curve<DVec2> {
    let points: Vec<DVec2> = points.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
    Curve::new(&points).expect("finite points")
}

pub(crate) fn to_3d<P: Point>(points: &[P]) -> Vec<DVec3> {
    points.iter().map(|p| p.to_3d()).collect()
}

pub(crate) fn largest<P: Point>(points: &[P]) -> f64 {
    points.iter().map(|p| p.max_abs()).fold(0.0, f64::max)
}

/// The distance from |x| to the next larger number.
pub(crate) fn ulp(x: f64) -> f64 {
    let x = x.abs().min(f64::MAX.next_down());
    x.next_up() - x
}

/// The largest absolute difference of a coordinate.
pub(crate) fn apart<P: Point>(a: P, b: P) -> f64 {
    (a - b).max_abs()
}

pub(crate) fn real(n: usize) -> f64 {
    f64::from(u32::try_from(n).expect("a small number"))
}

/// The parameters that tests use: equal steps, the ends, and neighbours of the ends.
pub(crate) fn parameters(steps: usize) -> impl Iterator<Item = f64> {
    let even = (0..=steps).map(move |i| real(i) / real(steps));
    even.chain([1e-300, f64::EPSILON, 1e-9, 1.0 - 1e-9, 1.0_f64.next_down()])
}

/// Whether the environment variable `CASTELJAU_DEEP` asks for many more cases.
pub(crate) fn deep() -> bool {
    std::env::var_os("CASTELJAU_DEEP").is_some_and(|value| value != "0")
}

/// The number of cases: `usual`, or `many` if [`deep`].
pub(crate) fn cases(usual: usize, many: usize) -> usize {
    if deep() { many } else { usual }
}

/// Numbers from a text, separated by blanks.
pub(crate) fn numbers(text: &str) -> Vec<f64> {
    let words = text.split_whitespace();
    words.map(|word| word.parse().expect("a number")).collect()
}

/// De Casteljau's algorithm, without the library.
pub(crate) fn de_casteljau<P: Point>(points: &[P], t: f64) -> P {
    let mut row = points.to_vec();
    for last in (1..row.len()).rev() {
        for i in 0..last {
            row[i] = row[i] * (1.0 - t) + row[i + 1] * t;
        }
    }
    row[0]
}

/// The distance of a point of the plane from a polyline.
pub(crate) fn from_line(p: DVec2, line: &[DVec2]) -> f64 {
    let chords = line
        .windows(2)
        .map(|pair| measure::from_plane_segment(p, pair[0], pair[1]));
    chords.fold(f64::INFINITY, f64::min)
}

/// Asserts that two numbers differ by at most `tolerance`.
#[track_caller]
pub(crate) fn assert_close(got: f64, expected: f64, tolerance: f64) {
    let off = (got - expected).abs();
    assert!(off <= tolerance, "{got:e}, not {expected:e}: {off:e} off");
}

/// Asserts that a call is refused with a message that starts with this text.
#[track_caller]
pub(crate) fn assert_refused<T: Debug, E: Display>(result: Result<T, E>, message: &str) {
    let error = result.expect_err(message).to_string();
    assert!(error.starts_with(message), "{error}, not {message}");
}
