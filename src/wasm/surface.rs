//! Bindings of surfaces.
//!
//! Arguments: the numbers of vertices, of patches, and of joined vertices (0
//! if the operation does not depend on joined vertices), the degrees u and v of each patch, the vertices, the indices
//! of all nets, and for each vertex the first vertex that it is joined to; further arguments follow.

use super::arena;
use super::arena::Arena;
use super::canvas::CanvasSink;
use super::decode_surface::surface;
use super::optional;
use crate::geometry::bounds::Bounds;
use crate::geometry::error::Error;
use crate::models::teapot::{Height, TeapotOptions, Up};
use crate::surface::hash_index::joined;
use crate::surface::network::Surface;
use crate::surface::surface_point::SurfacePoint;
use glam::DMat4;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

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
    let teapot = Surface::teapot(&TeapotOptions {
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
    let joined = (0..)
        .take(vertices.len())
        .map(|i| surface.joined(i) as usize);
    a.write_counts(at, joined)
}

/// Arguments: a 4×4 matrix (column-major) after the surface. Draws all projected isocurves on a context or a path.
#[wasm_bindgen]
pub fn surface_trace(target: &JsValue, lines: usize, tolerance: f64) -> isize {
    let read = arena::with(|a| {
        let (surface, end) = surface(a)?;
        Ok::<_, Error>((surface, DMat4::from_cols_slice(a.numbers(end, 16))))
    });
    let mut sink = CanvasSink::new(target);
    let draw = |(surface, matrix): (Surface, DMat4)| {
        surface.trace_projected(&mut sink, &matrix, lines, optional(tolerance))
    };
    arena::encode_result(read.and_then(draw).map(|()| 0))
}

/// Writes for each part the index of its patch, u0, u1, v0, v1 and its four corners.
#[wasm_bindgen]
pub fn surface_subdivide(tolerance: f64) -> isize {
    arena::answer(|a| {
        let pieces = surface(a)?.0.subdivide(tolerance)?;
        Ok(pieces.iter().fold(0, |at, piece| {
            let numbers = [piece.patch as f64, piece.u0, piece.u1, piece.v0, piece.v1];
            let at = a.write_numbers(at, &numbers);
            a.write(at, &piece.corners)
        }))
    })
}

/// Writes the minimum and the maximum corner of the bounding box; nothing without patches.
#[wasm_bindgen]
pub fn surface_bounds() -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        Ok(surface
            .bounds()
            .map_or(0, |Bounds { min, max }| a.write(0, &[min, max])))
    })
}

/// Writes the area.
#[wasm_bindgen]
pub fn surface_area() -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        Ok(a.write_numbers(0, &[surface.area()]))
    })
}

/// Writes the volume; nothing if the surface does not enclose one.
#[wasm_bindgen]
pub fn surface_volume() -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        Ok(surface
            .volume()
            .map_or(0, |volume| a.write_numbers(0, &[volume])))
    })
}

/// Arguments: a point after the surface. Writes the nearest point as `write_points` does.
#[wasm_bindgen]
pub fn surface_nearest() -> isize {
    arena::answer(|a| {
        let (surface, end) = surface(a)?;
        let nearest = surface.nearest(a.point_in_space(end, 3))?;
        Ok(write_points(a, nearest.as_slice()))
    })
}

/// Arguments: the origin and the direction of a ray after the surface. Writes the hits as `write_points` does.
#[wasm_bindgen]
pub fn surface_ray() -> isize {
    arena::answer(|a| {
        let (surface, end) = surface(a)?;
        let [origin, direction] = [end, end + 3].map(|at| a.point_in_space(at, 3));
        let hits = surface.intersect_ray(origin, direction)?;
        Ok(write_points(a, &hits))
    })
}

/// Writes seven numbers for each surface point: patch, u, v, the point, the distance.
pub(super) fn write_points(a: &mut Arena, surface_points: &[SurfacePoint]) -> usize {
    surface_points.iter().fold(0, |at, location| {
        let SurfacePoint {
            patch,
            u,
            v,
            point: p,
            distance,
        } = *location;
        a.write_numbers(at, &[patch as f64, u, v, p.x, p.y, p.z, distance])
    })
}
