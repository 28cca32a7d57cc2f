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
pub(crate) mod wires;

use casteljau::glam::{DVec2, DVec3};
use casteljau::{Curve, Error, Point, Spline};
pub(crate) use casteljau_generator::{Rng, adversarial, changed, real};
use std::fmt::{Debug, Display};

/// The plane or space; points are made from three coordinates.
pub(crate) trait Space: Point + Distance {
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

/// The parameters that tests use: equal steps, the ends, and neighbours of the ends.
pub(crate) fn parameters(steps: usize) -> impl Iterator<Item = f64> {
    let even = (0..=steps).map(move |i| real(i) / real(steps));
    even.chain([1e-300, f64::EPSILON, 1e-9, 1.0 - 1e-9, 1.0_f64.next_down()])
}

/// Whether the environment variable `CASTELJAU_DEEP` asks for many more cases.
pub(crate) fn deep() -> bool {
    std::env::var_os("CASTELJAU_DEEP").is_some_and(|value| value != "0")
}

/// The number of cases: `usual`, `many` if [`deep`], or an eighth of `usual` with the environment variable `CASTELJAU_FEW`.
pub(crate) fn cases(usual: usize, many: usize) -> usize {
    if deep() {
        many
    } else if std::env::var_os("CASTELJAU_FEW").is_some() {
        usual.div_ceil(8)
    } else {
        usual
    }
}

/// Numbers from a text, separated by blanks.
pub(crate) fn numbers(text: &str) -> Vec<f64> {
    let words = text.split_whitespace();
    words.map(|word| word.parse().expect("a number")).collect()
}

fn rows<const N: usize>(text: &str) -> Vec<[f64; N]> {
    let numbers = |row: &str| -> Vec<f64> {
        let words = row.split_whitespace();
        words.map(|x| x.parse().expect("a number")).collect()
    };
    let row = |row: &str| numbers(row).try_into().expect("all coordinates of a point");
    text.split(',').map(row).collect()
}

/// Plane points from a text such as "0 0, 1 2.5, 2 0".
pub(crate) fn xy(text: &str) -> Vec<DVec2> {
    rows(text).into_iter().map(DVec2::from_array).collect()
}

/// Points in space from a text such as "0 0 0, 1 2.5 -1".
pub(crate) fn xyz(text: &str) -> Vec<DVec3> {
    rows(text).into_iter().map(DVec3::from_array).collect()
}

/// A plane curve from the text of its control points.
pub(crate) fn bezier(text: &str) -> Curve<DVec2> {
    Curve::new(&xy(text)).expect("finite points")
}

/// A plane spline from the text of its control points.
pub(crate) fn spline(text: &str, degree: usize, closed: bool) -> Spline<DVec2> {
    Spline::new(&xy(text), degree, closed).expect("a spline")
}

pub(crate) fn random_points<P: Space>(rng: &mut Rng, count: usize) -> Vec<P> {
    (0..count).map(|_| P::of(rng.point(P::DIMENSION))).collect()
}

/// C(n, k), exact up to 2⁵³.
pub(crate) fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |c, i| c * real(n - i) / real(i + 1))
}

/// The point at t by de Casteljau's algorithm, as in textbooks.
pub(crate) fn de_casteljau<P: Point>(points: &[P], t: f64) -> P {
    // Short rows for cubics, which are the most common.
    if points.len() <= 4 {
        de_casteljau_in::<P, 4>(points, t)
    } else {
        de_casteljau_in::<P, 65>(points, t)
    }
}

fn de_casteljau_in<P: Point, const ROOM: usize>(points: &[P], t: f64) -> P {
    let mut row = [P::default(); ROOM];
    row[..points.len()].copy_from_slice(points);
    for last in (1..points.len()).rev() {
        for i in 0..last {
            row[i] = row[i] * (1.0 - t) + row[i + 1] * t;
        }
    }
    row[0]
}

/// Asserts that a call is refused with a message that starts with this text.
#[track_caller]
pub(crate) fn assert_refused<T: Debug, E: Display>(result: Result<T, E>, message: &str) {
    let error = result.expect_err(message).to_string();
    assert!(error.starts_with(message), "{error}, not {message}");
}

/// The maximum of a function with one peak, by some steps of golden-section search.
pub(crate) fn highest(f: impl Fn(f64) -> f64, [mut lo, mut hi]: [f64; 2], steps: usize) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut x1, mut x2) = (hi - ratio * (hi - lo), lo + ratio * (hi - lo));
    let (mut f1, mut f2) = (f(x1), f(x2));
    for _ in 0..steps {
        if f1 > f2 {
            (hi, x2, f2) = (x2, x1, f1);
            x1 = hi - ratio * (hi - lo);
            f1 = f(x1);
        } else {
            (lo, x1, f1) = (x1, x2, f2);
            x2 = lo + ratio * (hi - lo);
            f2 = f(x2);
        }
    }
    f1.max(f2)
}

/// Numbers and points, which have a distance from each other.
pub(crate) trait Distance: Copy + Debug {
    fn gap(self, other: Self) -> f64;
}

impl Distance for f64 {
    fn gap(self, other: Self) -> f64 {
        (self - other).abs()
    }
}

impl Distance for DVec2 {
    fn gap(self, other: Self) -> f64 {
        self.distance(other)
    }
}

impl Distance for DVec3 {
    fn gap(self, other: Self) -> f64 {
        self.distance(other)
    }
}

/// Asserts that two numbers or points differ by less than `max`, or not at all.
#[track_caller]
pub(crate) fn near<T: Distance>(got: T, expected: T, max: f64) {
    near_at(got, expected, max, "");
}

/// Asserts that two numbers or points differ by less than `max`, or not at all; `case` is a part of the message.
#[track_caller]
pub(crate) fn near_at<T: Distance>(got: T, expected: T, max: f64, case: impl Debug) {
    let off = got.gap(expected);
    assert!(
        off < max || off == 0.0,
        "{got:?} instead of {expected:?}, off by {off:e}, allowed is {max:e}: {case:?}"
    );
}

/// Asserts that two lists have the same length, and that their numbers or points differ by less than `max`.
#[track_caller]
pub(crate) fn all_near<T: Distance>(got: &[T], expected: &[T], max: f64) {
    assert_eq!(got.len(), expected.len(), "{got:?}, not {expected:?}");
    for (&a, &b) in got.iter().zip(expected) {
        near_at(a, b, max, got);
    }
}

/// The kind of an error and its argument, such as "Range t", "NotFinite points 2" (with the index) or "Count points 7" (with
/// the number that was received).
fn kind(error: &Error) -> String {
    match error {
        Error::Count { what, got, .. } => format!("Count {what} {got}"),
        Error::NotFinite { what, index, .. } => format!("NotFinite {what} {index}"),
        Error::Index { what, got, .. } => format!("Index {what} {got}"),
        Error::Range { what, .. } => format!("Range {what}"),
        Error::Item {
            what, index, got, ..
        } => format!("Item {what} {index} {got}"),
        Error::TooMany { what, limit, .. } => format!("TooMany {what} {limit}"),
        Error::Tolerance { .. } => "Tolerance".to_owned(),
        Error::Gap { index, got } => format!("Gap {index} {got}"),
        Error::ClosedSpline { what } => format!("ClosedSpline {what}"),
        Error::Singular { what } => format!("Singular {what}"),
        _ => format!("{error:?}"),
    }
}

/// Asserts that a call is refused with an error of this [`kind`].
#[track_caller]
pub(crate) fn refused<T: Debug>(result: Result<T, Error>, expected: &str) {
    let error = result.expect_err(expected);
    assert_eq!(kind(&error), expected, "{error}");
}

/// Asserts that each error of a table is there and is of this [`kind`], or that its message starts with this text.
#[track_caller]
pub(crate) fn all_refused<const N: usize>(table: [(Option<Error>, &str); N]) {
    for (error, expected) in table {
        let error = error.unwrap_or_else(|| panic!("not refused: {expected}"));
        let message = error.to_string();
        let fits = kind(&error) == expected || message.starts_with(expected);
        assert!(fits, "{message}, not {expected}");
    }
}
