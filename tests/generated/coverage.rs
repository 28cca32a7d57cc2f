//! Every public function of the library's types has a row; the functions are found by reading the sources.

use std::path::{Path, PathBuf};

/// The types whose functions are called with generated arguments.
const TYPES: [&str; 14] = [
    "Curve",
    "RationalCurve",
    "NurbsCurve",
    "Spline",
    "Path",
    "InkStroke",
    "Patch",
    "RationalPatch",
    "NurbsSurface",
    "Surface",
    "RationalSurface",
    "Mesh",
    "Grid",
    "Easing",
];

/// Endings of functions that take options or a tolerance; the checks of the plain functions call them with those of the
/// case.
const VARIANTS: [&str; 2] = ["_within", "_with"];

/// Functions that the checks of other functions call in every case, or that another test calls.
const WITHIN_OTHERS: [&str; 54] = [
    "InkStroke::new", // InkStroke::outline, and those that follow
    "InkStroke::append",
    "InkStroke::changes",
    "InkStroke::spline",
    "InkStroke::widths",
    "Grid::vertex_count",             // Patch::grid
    "Grid::triangle_count",           // Patch::grid
    "Grid::vertex",                   // Grid::quads
    "Grid::uv",                       // Grid::quads
    "Grid::quad",                     // Grid::quads
    "Grid::triangles",                // Grid::quads
    "Path::from_kurbo",               // tests/path/kurbo.rs; its argument is a type of kurbo
    "Path::from_elements",            // Path::elements
    "Curve::point_at_length",         // Curve::time_at_length
    "Spline::point_at_length",        // Spline::time_at_length
    "RationalCurve::point_at_length", // RationalCurve::time_at_length
    "NurbsCurve::point_at_length",    // NurbsCurve::time_at_length
    "Spline::extrema",                // tests/spline/queries.rs
    "Spline::times_at_coordinate",    // tests/spline/queries.rs
    "Curve::offset_within",           // Curve::offset
    "Spline::offset_within",          // Spline::offset
    "Mesh::interleaved",              // copies what the meshes contain
    "Path::nearest_of",               // tests/path/sizes.rs
    "Path::length_at",                // tests/path/evaluate.rs, and those that follow
    "Path::lengths",
    "Path::point_at_length",
    "Path::eval",
    "Path::eval_at",
    "Path::derivative_at",
    "Path::tangent",
    "Path::normal",
    "Path::curvature",
    "Path::split",
    "Path::split_at",
    "Path::subsegment",
    "Path::sample",
    "Path::extrema",
    "Path::times_at_coordinate",
    "Path::builder", // tests/constructors, and the shapes
    "Path::circle",
    "Path::ellipse",
    "Path::arc",
    "Path::rect",
    "Path::rounded_rect",
    "Path::polygon",
    "PathTime::new",
    "Surface::eval", // tests/surface/bicubic.rs
    "Spline::flatten_with",
    "Path::flatten_with",
    "Spline::simplify_with", // tests/offset/simplify.rs
    "Path::round_corners_with",
    "Path::simplify_with",
    "Path::stroke_with",          // Path::stroke
    "Path::stroke_contains_with", // tests/stroke/variable.rs
];

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).expect("the sources").flatten() {
        let path = entry.path();
        if path.is_dir() && !path.ends_with("wasm") {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

/// The type of an `impl` line; `None` for impls of traits, which have no public functions of their own.
fn type_of(line: &str) -> Option<&str> {
    let mut rest = line.strip_prefix("impl")?;
    if rest.starts_with('<') {
        // Skips the parameters, in which arrows and brackets may be nested.
        let mut depth = 0;
        let end = rest.find(|c| {
            depth += i32::from(c == '<') - i32::from(c == '>');
            depth == 0
        });
        rest = &rest[end? + 1..];
    }
    let name = rest.trim_start();
    let end = name.find(|c: char| !c.is_alphanumeric())?;
    (!line.contains(" for ")).then_some(&name[..end])
}

fn public_functions(text: &str) -> Vec<String> {
    let (mut found, mut current) = (Vec::new(), None);
    for line in text.lines() {
        if line.starts_with("impl") {
            current = type_of(line);
        }
        let function = line
            .strip_prefix("    pub fn ")
            .or_else(|| line.strip_prefix("    pub const fn "));
        if let (Some(kind), Some(function)) =
            (current.filter(|kind| TYPES.contains(kind)), function)
        {
            let end = function
                .find(|c: char| !c.is_alphanumeric() && c != '_')
                .expect("a parenthesis");
            found.push(format!("{kind}::{}", &function[..end]));
        }
    }
    found
}

#[test]
fn every_public_function_has_a_row() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let texts = sources(&folder)
        .into_iter()
        .map(|path| std::fs::read_to_string(path).expect("a source"));
    let functions: Vec<String> = texts.flat_map(|text| public_functions(&text)).collect();
    assert!(
        functions.len() > 150,
        "only {} public functions were found",
        functions.len()
    );
    let rows: Vec<&str> = crate::rows().map(|(name, _)| name).collect();
    let is_variant = |name: &str| {
        let plain = VARIANTS.iter().find_map(|ending| name.strip_suffix(ending));
        plain.is_some_and(|name| rows.contains(&name))
    };
    let known =
        |name: &str| rows.contains(&name) || WITHIN_OTHERS.contains(&name) || is_variant(name);
    let missing: Vec<&String> = functions.iter().filter(|name| !known(name)).collect();
    assert!(
        missing.is_empty(),
        "no generated test calls {missing:?}: add rows to tests/generated and tests/generator"
    );
}
