//! The arguments of a case as values of the library, and the slack for rounding.

use crate::numbers::Numbers;
use casteljau::curve::Basis;
use casteljau::glam::{DAffine2, DAffine3, DMat4, DVec2, DVec3};
use casteljau::{Curve, Patch, Path, Point, Spline, Surface};
use casteljau_generator::{Case, SplineData, SurfaceData, Value};

/// The plane or space; points are made from three coordinates.
pub(crate) trait Space: Point + Numbers {
    fn of(p: DVec3) -> Self;
    fn affine(numbers: &[f64]) -> Self::Affine;
}

impl Space for DVec2 {
    fn of(p: DVec3) -> Self {
        p.truncate()
    }
    fn affine(numbers: &[f64]) -> DAffine2 {
        DAffine2::from_cols_slice(numbers)
    }
}

impl Space for DVec3 {
    fn of(p: DVec3) -> Self {
        p
    }
    fn affine(numbers: &[f64]) -> DAffine3 {
        DAffine3::from_cols_slice(numbers)
    }
}

fn mapped<P: Space>(points: &[DVec3]) -> Vec<P> {
    points.iter().map(|&p| P::of(p)).collect()
}

pub(crate) fn number(case: &Case, name: &str) -> f64 {
    optional(case, name).unwrap_or_else(|| panic!("{name}: expected a number"))
}

pub(crate) fn optional(case: &Case, name: &str) -> Option<f64> {
    match case.get(name) {
        Value::Number(x) => Some(*x),
        _ => None,
    }
}

pub(crate) fn count(case: &Case, name: &str) -> usize {
    optional_count(case, name).unwrap_or_else(|| panic!("{name}: expected a count"))
}

pub(crate) fn optional_count(case: &Case, name: &str) -> Option<usize> {
    match case.get(name) {
        Value::Count(n) => Some(*n),
        _ => None,
    }
}

pub(crate) fn flag(case: &Case, name: &str) -> bool {
    matches!(case.get(name), Value::Flag(true))
}

pub(crate) fn word(case: &Case, name: &str) -> &'static str {
    match case.get(name) {
        Value::Word(word) => word,
        _ => "",
    }
}

pub(crate) fn words<'a>(case: &'a Case, name: &str) -> &'a [&'static str] {
    match case.get(name) {
        Value::Words(words) => words,
        _ => &[],
    }
}

pub(crate) fn text<'a>(case: &'a Case, name: &str) -> &'a str {
    match case.get(name) {
        Value::Text(text) => text,
        _ => "",
    }
}

pub(crate) fn numbers<'a>(case: &'a Case, name: &str) -> &'a [f64] {
    optional_numbers(case, name).unwrap_or_default()
}

pub(crate) fn optional_numbers<'a>(case: &'a Case, name: &str) -> Option<&'a [f64]> {
    match case.get(name) {
        Value::Numbers(numbers) => Some(numbers),
        _ => None,
    }
}

pub(crate) fn optional_point<P: Space>(case: &Case, name: &str) -> Option<P> {
    match case.get(name) {
        Value::Point(_, p) => Some(P::of(*p)),
        _ => None,
    }
}

pub(crate) fn point<P: Space>(case: &Case, name: &str) -> P {
    optional_point(case, name).unwrap_or_else(|| panic!("{name}: expected a point"))
}

pub(crate) fn points<P: Space>(case: &Case, name: &str) -> Vec<P> {
    match case.get(name) {
        Value::Points(_, points) => mapped(points),
        _ => panic!("{name}: expected points"),
    }
}

pub(crate) fn curve<P: Space>(case: &Case, name: &str) -> Curve<P> {
    match case.get(name) {
        Value::Curve(_, points) => Curve::new(&mapped::<P>(points)).expect("a curve"),
        _ => panic!("{name}: expected a curve"),
    }
}

pub(crate) fn spline_of<P: Space>(data: &SplineData) -> Spline<P> {
    Spline::with_degrees(mapped(&data.points), &data.degrees, data.closed).expect("a spline")
}

pub(crate) fn spline_data<'a>(case: &'a Case, name: &str) -> &'a SplineData {
    match case.get(name) {
        Value::Spline(data) => data,
        _ => panic!("{name}: expected a spline"),
    }
}

pub(crate) fn spline<P: Space>(case: &Case, name: &str) -> Spline<P> {
    spline_of(spline_data(case, name))
}

pub(crate) fn path(case: &Case, name: &str) -> Path {
    match case.get(name) {
        Value::Path(splines) => Path::new(&splines.iter().map(spline_of).collect::<Vec<_>>()),
        _ => panic!("{name}: expected a path"),
    }
}

pub(crate) fn surface_data(case: &Case) -> &SurfaceData {
    match &case.arguments[0].1 {
        Value::Patch(data) | Value::Surface(data) => data,
        _ => panic!("expected a patch or a surface"),
    }
}

pub(crate) fn patch(case: &Case) -> Patch {
    let data = surface_data(case);
    let [m, n] = data.degrees[0];
    Patch::new(&data.vertices, m, n).expect("a patch")
}

pub(crate) fn surface(case: &Case) -> Surface {
    let data = surface_data(case).clone();
    Surface::with_degrees(data.vertices, data.indices, &data.degrees).expect("a surface")
}

pub(crate) fn affine<P: Space>(case: &Case, name: &str) -> P::Affine {
    P::affine(numbers(case, name))
}

pub(crate) fn projection(case: &Case, name: &str) -> DMat4 {
    DMat4::from_cols_slice(numbers(case, name))
}

pub(crate) fn basis(case: &Case, name: &str) -> Basis {
    match (word(case, name), numbers(case, name)) {
        ("", numbers) => Basis::Matrix(numbers.try_into().expect("16 numbers")),
        (word, _) => named_basis(word),
    }
}

pub(crate) fn named_basis(word: &str) -> Basis {
    match word {
        "hermite" => Basis::Hermite,
        "b-spline" => Basis::BSpline,
        "catmull-rom" => Basis::CatmullRom,
        _ => Basis::Bezier,
    }
}

/// The slack for coordinates of points on curves of a degree: 16 (n + 2) units of rounding of the largest coordinate.
pub(crate) fn slack(size: f64, degree: usize) -> f64 {
    16.0 * real(degree + 2) * f64::EPSILON * size + f64::MIN_POSITIVE
}

/// The factor by which a parameter outside [0, 1] enlarges coordinates and their rounding errors: (|t| + |1 − t|)ⁿ.
pub(crate) fn growth(t: f64, degree: usize) -> f64 {
    (t.abs() + (1.0 - t).abs()).powi(i32::try_from(degree).expect("a degree"))
}

pub(crate) fn real(n: usize) -> f64 {
    f64::from(u32::try_from(n).expect("a small number"))
}

/// The distance of two points.
pub(crate) fn distance<P: Point>(a: P, b: P) -> f64 {
    (a - b).length()
}

/// De Casteljau's algorithm, independent of the library.
pub(crate) fn de_casteljau<P: Point>(points: &[P], t: f64) -> P {
    let mut row = points.to_vec();
    for length in (1..row.len()).rev() {
        for i in 0..length {
            row[i] = row[i] * (1.0 - t) + row[i + 1] * t;
        }
    }
    row[0]
}

/// The distance of a point from a segment.
pub(crate) fn from_segment<P: Point>(p: P, a: P, b: P) -> f64 {
    let (along, away) = (b - a, p - a);
    let square = along.dot(along);
    let s = if square > 0.0 {
        (away.dot(along) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    distance(away, along * s)
}

/// `steps` + 1 parameters from 0 to `end`.
pub(crate) fn parameters(steps: usize, end: f64) -> impl Iterator<Item = f64> {
    (0..=steps).map(move |k| end * real(k) / real(steps))
}

/// Whether numbers are strictly increasing within [min, max].
pub(crate) fn ascends(ts: &[f64], min: f64, max: f64) -> bool {
    ts.windows(2).all(|w| w[0] < w[1]) && ts.iter().all(|t| (min..=max).contains(t))
}
