//! Cubics that are hard to stroke.

use crate::support::paths::path;
use casteljau::Path;

/// The first ten are `broken_cubics` of kurbo 0.13.1, src/stroke.rs (Apache-2.0 OR MIT), the others are our own.
const HARD: [(&str, &str); 22] = [
    (
        "three equal points",
        "M465.24423 107.11105C475.50754 107.11105 475.50754 107.11105 475.50754 107.11105",
    ),
    ("nearly a cusp", "M0 -0.01C128 128.001 128 -0.01 0 128.001"),
    ("flat, one turn", "M0 0C0 -10 0 -10 0 10"),
    ("flat, two turns", "M10 0C0 0 20 0 10 0"),
    (
        "diagonal, turn at a double point",
        "M39 -39C40 -40 40 -40 0 0",
    ),
    ("diagonal, inner turn", "M40 40C0 0 200 200 0 0"),
    ("small, flat, two turns", "M0 0C1e-2 0 -1e-2 0 0 0"),
    (
        "flat, double ends",
        "M400.75 100.05C400.75 100.05 100.05 300.95 100.05 300.95",
    ),
    ("flat, two turns, uneven", "M0.5 0C0 0 20 0 10 0"),
    ("flat, turn at the end", "M10 0C0 0 10 0 10 0"),
    ("cusp", "M0 0C100 100 0 100 100 0"),
    ("loop", "M0 0C140 100 -40 100 100 0"),
    ("closed loop", "M0 0C100 100 -100 100 0 0"),
    ("point", "M7 5C7 5 7 5 7 5"),
    ("arch", "M0 0C0 60 80 60 80 0"),
    ("inflection", "M0 0C60 120 40 -120 100 0"),
    ("hook at the end", "M0 0C120 0 100.5 0 100 1"),
    ("narrow arch", "M0 0C0 100 1 100 1 0"),
    ("cusp at the start", "M0 0C0 0 60 90 100 0"),
    ("long handle", "M0 0C900 10 -300 20 100 0"),
    ("both handles outwards", "M0 0C-80 30 180 30 100 0"),
    ("nearly flat turn", "M0 0C100 1e-6 -20 1e-6 60 0"),
];

/// The curves above.
pub(crate) fn hard() -> impl Iterator<Item = (&'static str, Path)> {
    HARD.iter().map(|&(name, d)| (name, path(d)))
}

/// All curves: those above and Skia's.
pub(crate) fn curves() -> impl Iterator<Item = (&'static str, Path)> {
    let skia = include_str!("../data/strokes/skia.txt").lines();
    let skia = skia.filter(|line| !line.starts_with("# "));
    hard().chain(skia.map(|d| (d, path(d))))
}

/// The diagonal of the control points' box; 1 for a point.
pub(crate) fn size(path: &Path) -> f64 {
    let diagonal = path.control_bounds().expect("not empty").diagonal();
    if diagonal > 0.0 { diagonal } else { 1.0 }
}
