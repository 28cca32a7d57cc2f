//! Cubics that are hard to stroke.

use casteljau::glam::DVec2;
use casteljau::{Curve, Path};

/// The first ten are `broken_cubics` of kurbo 0.13.1, src/stroke.rs (Apache-2.0 OR MIT), the others are our own.
pub(crate) const HARD: [(&str, [(f64, f64); 4]); 22] = [
    (
        "three equal points",
        [
            (465.24423, 107.11105),
            (475.50754, 107.11105),
            (475.50754, 107.11105),
            (475.50754, 107.11105),
        ],
    ),
    (
        "nearly a cusp",
        [
            (0.0, -0.01),
            (128.0, 128.001),
            (128.0, -0.01),
            (0.0, 128.001),
        ],
    ),
    (
        "flat, one turn",
        [(0.0, 0.0), (0.0, -10.0), (0.0, -10.0), (0.0, 10.0)],
    ),
    (
        "flat, two turns",
        [(10.0, 0.0), (0.0, 0.0), (20.0, 0.0), (10.0, 0.0)],
    ),
    (
        "diagonal, turn at a double point",
        [(39.0, -39.0), (40.0, -40.0), (40.0, -40.0), (0.0, 0.0)],
    ),
    (
        "diagonal, inner turn",
        [(40.0, 40.0), (0.0, 0.0), (200.0, 200.0), (0.0, 0.0)],
    ),
    (
        "small, flat, two turns",
        [(0.0, 0.0), (1e-2, 0.0), (-1e-2, 0.0), (0.0, 0.0)],
    ),
    (
        "flat, double ends",
        [
            (400.75, 100.05),
            (400.75, 100.05),
            (100.05, 300.95),
            (100.05, 300.95),
        ],
    ),
    (
        "flat, two turns, uneven",
        [(0.5, 0.0), (0.0, 0.0), (20.0, 0.0), (10.0, 0.0)],
    ),
    (
        "flat, turn at the end",
        [(10.0, 0.0), (0.0, 0.0), (10.0, 0.0), (10.0, 0.0)],
    ),
    (
        "cusp",
        [(0.0, 0.0), (100.0, 100.0), (0.0, 100.0), (100.0, 0.0)],
    ),
    (
        "loop",
        [(0.0, 0.0), (140.0, 100.0), (-40.0, 100.0), (100.0, 0.0)],
    ),
    (
        "closed loop",
        [(0.0, 0.0), (100.0, 100.0), (-100.0, 100.0), (0.0, 0.0)],
    ),
    ("point", [(7.0, 5.0), (7.0, 5.0), (7.0, 5.0), (7.0, 5.0)]),
    ("arch", [(0.0, 0.0), (0.0, 60.0), (80.0, 60.0), (80.0, 0.0)]),
    (
        "inflection",
        [(0.0, 0.0), (60.0, 120.0), (40.0, -120.0), (100.0, 0.0)],
    ),
    (
        "hook at the end",
        [(0.0, 0.0), (120.0, 0.0), (100.5, 0.0), (100.0, 1.0)],
    ),
    (
        "narrow arch",
        [(0.0, 0.0), (0.0, 100.0), (1.0, 100.0), (1.0, 0.0)],
    ),
    (
        "cusp at the start",
        [(0.0, 0.0), (0.0, 0.0), (60.0, 90.0), (100.0, 0.0)],
    ),
    (
        "long handle",
        [(0.0, 0.0), (900.0, 10.0), (-300.0, 20.0), (100.0, 0.0)],
    ),
    (
        "both handles outwards",
        [(0.0, 0.0), (-80.0, 30.0), (180.0, 30.0), (100.0, 0.0)],
    ),
    (
        "nearly flat turn",
        [(0.0, 0.0), (100.0, 1e-6), (-20.0, 1e-6), (60.0, 0.0)],
    ),
];

pub(crate) fn path(points: &[(f64, f64)]) -> Path {
    let points: Vec<DVec2> = points.iter().map(|&p| p.into()).collect();
    Path::from(Curve::new(&points).expect("finite"))
}

/// All curves: those above and Skia's.
pub(crate) fn curves() -> Vec<(&'static str, Path)> {
    let skia = include_str!("../data/strokes/skia.txt").lines();
    let skia = skia.filter(|line| !line.starts_with("# "));
    let ours = HARD.iter().map(|&(name, points)| (name, path(&points)));
    ours.chain(skia.map(|d| (d, d.parse().expect("path data"))))
        .collect()
}

/// The diagonal of the control points' box; 1 for a point.
pub(crate) fn size(path: &Path) -> f64 {
    let bounds = path.control_bounds().expect("not empty");
    let diagonal = (bounds.max - bounds.min).length();
    if diagonal > 0.0 { diagonal } else { 1.0 }
}
