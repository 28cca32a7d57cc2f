//! Bindings of patches and surfaces.
//!
//! Patches: the net at the start of the arena. Surfaces: the numbers of vertices, of patches, and of joined vertices (0
//! if the operation does not depend on joined vertices), the degrees u and v of each patch, the vertices, the indices
//! of all nets, and for each vertex the first vertex that it is joined to; further arguments follow.

use super::arena;
use super::arena::Arena;
use super::canvas::CanvasSink;
use super::decode_surface::{patch, surface};
use super::mesh::begin_grid;
use super::optional;
use crate::geometry::error::Error;
use crate::mesh::grid::Grid;
use crate::models::teapot::{Height, TeapotOptions, Up};
use crate::surface::first_of::joined;
use crate::surface::network::Surface;
use glam::DMat4;
use wasm_bindgen::JsValue;
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

/// Prepares the grid of one patch, evaluated by forward `differences` or by Bernstein polynomials; returns 0.
#[wasm_bindgen]
pub fn patch_grid(
    degree_u: usize,
    degree_v: usize,
    segments_u: usize,
    segments_v: usize,
    quads: bool,
    differences: bool,
) -> isize {
    arena::answer(|a| {
        let patch = patch(a, degree_u, degree_v);
        let grid = Grid {
            segments_u,
            segments_v,
        };
        begin_grid(patch.as_surface(), grid, quads, differences)
    })
}

/// Arguments: points. Writes for each point the index of the first equal point.
#[wasm_bindgen]
pub fn points_joined(count: usize) -> usize {
    arena::with(|a| {
        let joined = joined(a.points(0, count));
        a.write_counts(0, joined.into_iter().map(|first| first as usize))
    })
}

/// Writes the teapot. `parts`: bit 0 rim, 1 body, 2 handle, 3 spout, 4 lid, 5 bottom.
#[wasm_bindgen]
pub fn surface_teapot(parts: u32, original_height: bool, y_up: bool) -> usize {
    let part = |bit: u32| parts >> bit & 1 == 1;
    let teapot = Surface::teapot(TeapotOptions {
        rim: part(0),
        body: part(1),
        handle: part(2),
        spout: part(3),
        lid: part(4),
        bottom: part(5),
        height: if original_height {
            Height::Original
        } else {
            Height::Squashed
        },
        up: if y_up { Up::Y } else { Up::Z },
    });
    arena::with(|a| write(a, &teapot))
}

/// Writes the teacup or the teaspoon.
#[wasm_bindgen]
pub fn surface_teaset(spoon: bool, y_up: bool) -> usize {
    let up = if y_up { Up::Y } else { Up::Z };
    let surface = if spoon {
        Surface::teaspoon(up)
    } else {
        Surface::teacup(up)
    };
    arena::with(|a| write(a, &surface))
}

/// Writes a surface in the format of the arguments.
pub(crate) fn write(a: &mut Arena, surface: &Surface) -> usize {
    let (vertices, patches) = (surface.vertices(), surface.patch_count());
    a.write_counts(0, [vertices.len(), patches, vertices.len()].into_iter());
    let degrees = (0..patches).filter_map(|k| surface.degrees(k)).flatten();
    let at = a.write_counts(3, degrees);
    let at = a.write(at, vertices);
    let at = a.write_counts(at, surface.indices().iter().map(|&i| i as usize));
    a.write_counts(at, surface.joined_all().iter().map(|&i| i as usize))
}

/// As `patch_grid`, for a surface.
#[wasm_bindgen]
pub fn surface_grid(segments_u: usize, segments_v: usize, quads: bool, differences: bool) -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        let grid = Grid {
            segments_u,
            segments_v,
        };
        begin_grid(surface, grid, quads, differences)
    })
}

/// Arguments: a 4×4 matrix (column-major) after the surface. Draws all projected isocurves on a context or a path.
#[wasm_bindgen]
pub fn surface_trace(target: &JsValue, lines: usize, tolerance: f64) -> isize {
    let read = arena::with(|a| {
        let (surface, end) = surface(a)?;
        Ok::<_, Error>((surface, DMat4::from_cols_slice(a.numbers(end, 16))))
    });
    let mut pen = CanvasSink::new(target);
    let draw = |(surface, matrix): (Surface, DMat4)| {
        surface.trace_projected(&mut pen, &matrix, lines, optional(tolerance))
    };
    arena::encode_result(read.and_then(draw).map(|()| 0))
}
