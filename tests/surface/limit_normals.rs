//! Normals where ∂u × ∂v vanishes, on the most difficult net: Gumbo's many degenerate corners and edges.

use crate::support::surfaces::gumbo;
use casteljau::glam::DVec3;
use casteljau::{Patch, Surface, TeapotOptions};

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
        for sample in 0..17 * 17_u32 {
            let (u, v) = (f64::from(sample % 17) / 16.0, f64::from(sample / 17) / 16.0);
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
fn teapot() {
    let surface = Surface::teapot(TeapotOptions::default());
    assert_eq!(compare(&surface, 1e-4), 136);
}

#[test]
fn gumbo_s_degenerate_corners() {
    if let Some(surface) = gumbo() {
        assert_eq!(compare(&surface, 1e-3), 315);
    }
}
