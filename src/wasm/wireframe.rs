//! Bindings of isocurves and wireframe meshes.

use super::arena;
use super::decode_surface::surface;
use super::mesh::keep_mesh;
use crate::mesh::wire::{Wire, WireframeOptions};
use wasm_bindgen::prelude::wasm_bindgen;

/// Writes for each isocurve the number of its control points, then the points.
#[wasm_bindgen]
pub fn surface_isocurves(lines: usize) -> isize {
    arena::answer(|a| {
        let curves = surface(a)?.0.isocurves(lines)?;
        Ok(curves.iter().fold(0, |at, curve| {
            let points = curve.control_points();
            let at = a.write_numbers(at, &[points.len() as f64]);
            a.write(at, points)
        }))
    })
}

/// Makes the mesh of all isocurves: tubes with radius `size`, or, if `sides` is 0, ribbons of that width. Returns 0.
#[wasm_bindgen]
pub fn surface_wireframe(lines: usize, size: f64, sides: usize) -> isize {
    arena::answer(|a| {
        let mesh = surface(a)?.0.wireframe(&options(lines, size, sides))?;
        Ok(keep_mesh(mesh))
    })
}

/// Tubes with radius `size`, or, if `sides` is 0, ribbons of that width.
pub(super) fn options(lines: usize, size: f64, sides: usize) -> WireframeOptions {
    let wire = if sides > 0 {
        Wire::Tube {
            radius: size,
            sides,
        }
    } else {
        Wire::Ribbon { width: size }
    };
    WireframeOptions { lines, wire }
}
