//! Bindings of surfaces of rational patches. Arguments: a surface (see `surface.rs`), a weight for each index of all nets; further
//! arguments follow.

use super::arena;
use super::arena::Arena;
use super::canvas::CanvasSink;
use super::decode_surface;
use super::mesh::{keep, keep_mesh, options, write_topology};
use super::nurbs_surface::{curves, write_patch};
use super::surface::write_points;
use super::{optional, wireframe};
use crate::geometry::bounds::Bounds;
use crate::geometry::error::Error;
use crate::mesh::grid::Grid;
use crate::rational::RationalSurface;
use glam::DMat4;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// The surface at the start of the arena, and the index where it ends.
fn surface(a: &Arena) -> Result<(RationalSurface, usize), Error> {
    let (network, at) = decode_surface::surface(a)?;
    let end = at + network.indices().len();
    let weights = a.numbers(at, end - at).to_vec();
    Ok((RationalSurface::weighted(network, weights)?, end))
}

/// Arguments: a profile, a point of the axis and its direction. Writes for each patch of the solid its degrees, the net and the
/// weights.
#[wasm_bindgen]
pub fn rationalsurface_solid_of_revolution(angle: f64) -> isize {
    arena::answer(|a| {
        let (curves, end) = curves(a, 1)?;
        let [origin, axis] = [end, end + 3].map(|at| a.point_in_space(at, 3));
        let solid = RationalSurface::solid_of_revolution(&curves[0], origin, axis, angle)?;
        Ok(solid.patches().fold(0, |at, patch| {
            let at = a.write_counts(at, [patch.degree_u(), patch.degree_v()].into_iter());
            write_patch(a, at, &patch)
        }))
    })
}

/// Writes the weights with which edges that are the same curve are one line.
#[wasm_bindgen]
pub fn rationalsurface_common_parameters() -> isize {
    arena::answer(|a| {
        let surface = surface(a)?.0.with_common_parameters();
        Ok(a.write_numbers(0, surface.weights()))
    })
}

/// As `surface_tessellate`.
#[wasm_bindgen]
pub fn rationalsurface_tessellate(kind: u32, a: f64, b: f64, weld: u32, precise: bool) -> isize {
    arena::answer(|arena| {
        let (surface, end) = surface(arena)?;
        let options = options(arena, end, kind, [a, b], weld);
        keep(
            precise,
            || surface.tessellate(&options),
            || surface.tessellate_f64(&options),
        )
    })
}

/// As `surface_topology`.
#[wasm_bindgen]
pub fn rationalsurface_topology() -> isize {
    arena::answer(|a| {
        let topology = surface(a)?.0.topology();
        Ok(write_topology(a, topology))
    })
}

/// Makes a grid for each patch, to be copied; returns 0.
#[wasm_bindgen]
pub fn rationalsurface_grid(segments_u: usize, segments_v: usize, quads: bool) -> isize {
    arena::answer(|a| {
        let grid = Grid {
            segments_u,
            segments_v,
        };
        let mesh = surface(a)?.0.grid(grid, quads)?;
        Ok(keep_mesh(mesh))
    })
}

/// Writes for each isocurve the number of its control points, the points, and their weights.
#[wasm_bindgen]
pub fn rationalsurface_isocurves(lines: usize) -> isize {
    arena::answer(|a| {
        let curves = surface(a)?.0.isocurves(lines)?;
        Ok(curves.iter().fold(0, |at, curve| {
            let points = curve.control_points();
            let at = a.write_numbers(at, &[points.len() as f64]);
            let at = a.write(at, points);
            a.write_numbers(at, curve.weights())
        }))
    })
}

/// As `surface_wireframe`.
#[wasm_bindgen]
pub fn rationalsurface_wireframe(lines: usize, size: f64, sides: usize) -> isize {
    arena::answer(|a| {
        let options = wireframe::options(lines, size, sides);
        let mesh = surface(a)?.0.wireframe(&options)?;
        Ok(keep_mesh(mesh))
    })
}

/// As `surface_trace`.
#[wasm_bindgen]
pub fn rationalsurface_trace(target: &JsValue, lines: usize, tolerance: f64) -> isize {
    let read = arena::with(|a| {
        let (surface, end) = surface(a)?;
        Ok::<_, Error>((surface, DMat4::from_cols_slice(a.numbers(end, 16))))
    });
    let mut sink = CanvasSink::new(target);
    let draw = |(surface, matrix): (RationalSurface, DMat4)| {
        surface.trace_projected(&mut sink, &matrix, lines, optional(tolerance))
    };
    arena::encode_result(read.and_then(draw).map(|()| 0))
}

/// As `surface_bounds`.
#[wasm_bindgen]
pub fn rationalsurface_bounds() -> isize {
    arena::answer(|a| {
        let bounds = surface(a)?.0.bounds();
        Ok(bounds.map_or(0, |Bounds { min, max }| a.write(0, &[min, max])))
    })
}

/// Writes the area.
#[wasm_bindgen]
pub fn rationalsurface_area() -> isize {
    arena::answer(|a| {
        let area = surface(a)?.0.area();
        Ok(a.write_numbers(0, &[area]))
    })
}

/// Writes the volume; nothing if the surface does not enclose one.
#[wasm_bindgen]
pub fn rationalsurface_volume() -> isize {
    arena::answer(|a| {
        let volume = surface(a)?.0.volume();
        Ok(volume.map_or(0, |volume| a.write_numbers(0, &[volume])))
    })
}

/// As `surface_nearest`.
#[wasm_bindgen]
pub fn rationalsurface_nearest() -> isize {
    arena::answer(|a| {
        let (surface, end) = surface(a)?;
        let nearest = surface.nearest(a.point_in_space(end, 3))?;
        Ok(write_points(a, nearest.as_slice()))
    })
}

/// As `surface_ray`.
#[wasm_bindgen]
pub fn rationalsurface_ray() -> isize {
    arena::answer(|a| {
        let (surface, end) = surface(a)?;
        let [origin, direction] = [end, end + 3].map(|at| a.point_in_space(at, 3));
        let hits = surface.intersect_ray(origin, direction)?;
        Ok(write_points(a, &hits))
    })
}
