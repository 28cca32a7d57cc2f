//! Normals where ∂u × ∂v vanishes, on the most difficult net: Gumbo's many degenerate corners and edges.

use crate::support::nets::{samples, teapot};
use crate::support::surfaces::gumbo;
use casteljau::glam::DVec3;
use casteljau::{Patch, Surface};

/// The limit of the normal by Richardson extrapolation of ordinary normals on the line to the middle.
fn limit_by_extrapolation(patch: &Patch, u: f64, v: f64) -> DVec3 {
    let step = |h: f64| {
        let p = patch.partials(u + h * (0.5 - u), v + h * (0.5 - v));
        p.u.cross(p.v).normalize()
    };
    let h = 1.0 / 4096.0;
    (step(h) * 8.0 / 3.0 - step(2.0 * h) * 2.0 + step(4.0 * h) / 3.0).normalize()
}

/// Compares all degenerate points of a 16 × 16 grid; returns their number.
fn compare(surface: &Surface, max_degrees: f64) -> usize {
    let mut degenerate = 0;
    for (index, patch) in surface.patches().enumerate() {
        let size = patch.control_bounds().diagonal();
        for (u, v) in samples(16) {
            let p = patch.partials(u, v);
            if p.u.cross(p.v).length() > 1e-9 * size * size {
                continue;
            }
            degenerate += 1;
            let expected = limit_by_extrapolation(&patch, u, v);
            let angle = patch.normal(u, v).angle_between(expected).to_degrees();
            assert!(angle < max_degrees, "patch {index} ({u}, {v}): {angle}°");
        }
    }
    degenerate
}

#[test]
fn normals_are_limits_at_degenerate_corners_and_edges() {
    assert_eq!(compare(&teapot(), 1e-4), 136);
    if let Some(surface) = gumbo() {
        assert_eq!(compare(&surface, 1e-3), 315);
    }
}
