//! Bindings of queries of patches and surfaces.
//!
//! A patch is stored at the start of the arena, as in `surface`; where a query exists for patches and for surfaces, a
//! patch is passed as a surface of one patch. Points and other arguments follow.

use super::arena;
use super::arena::Arena;
use super::decode_surface::{patch, surface};
use crate::curve::basis::Basis;
use crate::geometry::bounds::Bounds;
use crate::patch::Patch;
use crate::surface::surface_point::SurfacePoint;
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

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
fn write_points(a: &mut Arena, surface_points: &[SurfacePoint]) -> usize {
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
