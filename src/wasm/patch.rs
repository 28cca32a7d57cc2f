//! Bindings of patches. Arguments: the net at the start of the arena, followed by further arguments.

use super::arena;
use super::decode_surface::patch;
use crate::curve::basis::Basis;
use crate::patch::Patch;
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

/// Writes the point at (u, v).
#[wasm_bindgen]
pub fn patch_eval(degree_u: usize, degree_v: usize, u: f64, v: f64) {
    arena::with(|a| a.write_point(patch(a, degree_u, degree_v).eval(u, v)));
}

/// Writes ∂u, ∂v, ∂uu, ∂uv, ∂vv.
#[wasm_bindgen]
pub fn patch_partials(degree_u: usize, degree_v: usize, u: f64, v: f64) {
    arena::with(|a| {
        let p = patch(a, degree_u, degree_v).partials(u, v);
        a.write(0, &[p.u, p.v, p.uu, p.uv, p.vv]);
    });
}

/// Writes the unit normal at (u, v).
#[wasm_bindgen]
pub fn patch_normal(degree_u: usize, degree_v: usize, u: f64, v: f64) {
    arena::with(|a| a.write_point(patch(a, degree_u, degree_v).normal(u, v)));
}

/// Writes the control points of the curve of constant u (or v); returns the number of f64.
#[wasm_bindgen]
pub fn patch_isocurve(degree_u: usize, degree_v: usize, constant_u: bool, at: f64) -> usize {
    arena::with(|a| {
        let patch = patch(a, degree_u, degree_v);
        let curve = if constant_u {
            patch.isocurve_at_u(at)
        } else {
            patch.isocurve_at_v(at)
        };
        a.write(0, curve.control_points())
    })
}

/// Writes the nets of the two parts before and after u (or v).
#[wasm_bindgen]
pub fn patch_split(degree_u: usize, degree_v: usize, along_u: bool, at: f64) {
    arena::with(|a| {
        let patch = patch(a, degree_u, degree_v);
        let (before, after) = if along_u {
            patch.split_u(at)
        } else {
            patch.split_v(at)
        };
        let end = a.write(0, before.control_points());
        a.write(end, after.control_points());
    });
}

/// Writes the Gaussian and the mean curvature, k1 and k2.
#[wasm_bindgen]
pub fn patch_curvature(degree_u: usize, degree_v: usize, u: f64, v: f64) {
    arena::with(|a| {
        let c = patch(a, degree_u, degree_v).curvature(u, v);
        a.write_numbers(0, &[c.gaussian, c.mean, c.k1, c.k2]);
    });
}

/// The bound on the distance between the patch and two triangles.
#[wasm_bindgen]
pub fn patch_flatness(degree_u: usize, degree_v: usize) -> f64 {
    arena::with(|a| patch(a, degree_u, degree_v).flatness())
}

/// Writes the net of the patch with both degrees elevated.
#[wasm_bindgen]
pub fn patch_elevate(degree_u: usize, degree_v: usize) -> isize {
    arena::answer(|a| {
        let high = patch(a, degree_u, degree_v).elevate()?;
        Ok(a.write(0, high.control_points()))
    })
}

/// Arguments: sixteen geometry points and a basis matrix. Writes the net.
#[wasm_bindgen]
pub fn patch_from_basis() -> isize {
    arena::answer(|a| {
        let (mut net, mut matrix) = ([DVec3::ZERO; 16], [0.0; 16]);
        net.copy_from_slice(a.points(0, 16));
        matrix.copy_from_slice(a.numbers(48, 16));
        let patch = Patch::from_basis(Basis::Matrix(matrix), &net)?;
        Ok(a.write(0, patch.control_points()))
    })
}
