//! The results of generated calls that `tests/js/parity.test.js` compares with those of the package: `tests/data/results.txt`.

use crate::check::{Outcome, first_outcome};
use crate::geometry::real;
use casteljau_generator::{Mode, case};
use std::env;
use std::fmt::Write;
use std::fs;
use std::iter::zip;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/results.txt");
const SEED: u64 = 11;
/// Calls of each function.
const CALLS: usize = 20;
/// More numbers than these are written as their count and a weighted sum.
const MAX_NUMBERS: usize = 8;
/// The largest distance of two numbers that count as equal, relative to the largest number of their line. Sines and
/// logarithms are those of the platform.
const ROUNDING: f64 = 1e-9;

/// Functions of both languages whose result consists of numbers.
const FUNCTIONS: &[&str] = &[
    "Curve: new from_basis to_basis basis_matrix bernstein approx_eq interpolate eval eval_at sample derivative",
    "Curve: derivative_at tangent normal curvature torsion frames frames_at length time_at_length equidistant_times area",
    "Curve: split halve subsegment reverse elevate reduce de_casteljau transform flatten subdivide bounds control_bounds hull",
    "Curve: intersections self_intersections nearest extrema times_at_coordinate inflections cusps tangents_from",
    "Curve: distance_to hausdorff offset",
    "RationalCurve: new conic from sample derivative_at tangent normal split halve subsegment reverse elevate",
    "RationalCurve: reparametrize transform project bounds control_bounds extrema nearest length flatten to_spline area",
    "RationalCurve: inflections intersections self_intersections",
    "NurbsCurve: new from interpolate greville reverse elevate insert_knot remove_knot refine subsegment transform project",
    "NurbsCurve: bounds control_bounds extrema nearest length flatten to_spline area intersections self_intersections",
    "RationalPatch: from partials normal curvature isocurve_at_u isocurve_at_v split_u split_v elevate transform project",
    "RationalPatch: bounds",
    "NurbsSurface: plane sphere cylinder cone torus ruled extrude revolve loft partials normal curvature isocurve_at_u",
    "NurbsSurface: isocurve_at_v split_u split_v insert_knot_u insert_knot_v elevate_u elevate_v reverse transform project bounds",
    "Spline: new from_curves from_bspline to_bspline interpolate fit simplify approx_eq eval eval_at sample",
    "Spline: derivative_at tangent normal curvature torsion frames frames_at length time_at_length equidistant_times area",
    "Spline: split subsegment reverse transform flatten bounds control_bounds intersections self_intersections nearest",
    "Spline: continuity append insert remove move_point set_joint offset",
    "Path: approx_eq bounds control_bounds length time_at_length equidistant_times area moments flatten simplify",
    "Path: transform reverse nearest winding_number contains intersections self_intersections union intersect subtract",
    "Path: exclude combine remove_overlaps faces divide clip filled_area filled_moments stroke stroke_contains dash",
    "Path: offset round_corners to_arcs",
    "Patch: from_basis approx_eq eval partials normal curvature isocurve_at_u isocurve_at_v de_casteljau split_u",
    "Patch: split_v split elevate flatness area transform move_point bounds nearest intersect_ray grid tessellate",
    "Surface: teapot teacup teaspoon transform move_point grid tessellate tessellate_view bounds nearest intersect_ray",
    "Surface: tessellate_f64 area volume isocurves subdivide wireframe",
    "RationalSurface: new from from_patches solid_of_revolution transform move_point bounds area volume nearest",
    "RationalSurface: intersect_ray grid tessellate tessellate_view tessellate_f64 isocurves wireframe",
    "Mesh: to_stl to_glb",
    "Easing: eval",
];

fn functions() -> impl Iterator<Item = String> {
    FUNCTIONS.iter().flat_map(|row| {
        let (of, names) = row.split_once(": ").expect("a type");
        names.split(' ').map(move |name| format!("{of}::{name}"))
    })
}

/// The count of numbers and the numbers, or their weighted sum if they are many; the weights are fractions of multiples
/// of the golden ratio. Nothing for a refusal.
fn written(outcome: &Outcome) -> String {
    let Some(numbers) = outcome else {
        return "refused".to_owned();
    };
    let mut text = numbers.len().to_string();
    let weight = |k: usize| (real(k) * 0.618_033_988_749_895) % 1.0;
    let sum = || numbers.iter().enumerate().map(|(k, x)| weight(k) * x).sum();
    let shown = if numbers.len() > MAX_NUMBERS {
        &[sum()]
    } else {
        &numbers[..]
    };
    for x in shown {
        write!(text, " {x:?}").expect("a text takes more");
    }
    text
}

/// One line for each call: the function, the number of the case, what `written` gives.
fn recorded() -> String {
    let mut text = String::new();
    for name in functions() {
        let row = crate::rows().find(|(known, _)| *known == name);
        let (_, check) = row.unwrap_or_else(|| panic!("no row {name}"));
        let cases = (0..).map(|number| case(SEED, &name, number));
        for case in cases.filter(|case| case.mode != Mode::Extreme).take(CALLS) {
            if let Some(outcome) = first_outcome(check, &case) {
                writeln!(text, "{name} {} {}", case.number, written(&outcome))
                    .expect("a text takes more");
            }
        }
    }
    text
}

/// Whether two lines are equal up to rounding.
fn agree(got: &str, known: &str) -> bool {
    let numbers =
        |line: &str| -> Vec<f64> { line.split(' ').skip(3).flat_map(str::parse).collect() };
    let (a, b) = (numbers(got), numbers(known));
    let largest = a.iter().fold(0.0, |largest, x| x.abs().max(largest));
    let near = zip(&a, &b).all(|(x, y)| x == y || (x - y).abs() <= ROUNDING * largest);
    got.split(' ').take(3).eq(known.split(' ').take(3)) && a.len() == b.len() && near
}

#[test]
fn recorded_results_are_up_to_date() {
    let text = recorded();
    if env::var_os("CASTELJAU_WRITE").is_some() {
        fs::write(FILE, &text).expect("tests/data can be written");
    }
    let known = fs::read_to_string(FILE).unwrap_or_default();
    let same = text.lines().count() == known.lines().count();
    let differs = zip(text.lines(), known.lines()).find(|(got, known)| !agree(got, known));
    assert!(
        same && differs.is_none(),
        "tests/data/results.txt is not up to date: {differs:?}\n  renew it: CASTELJAU_WRITE=1 cargo test --test generated recorded"
    );
}
