//! Bindings of questions to patches and surfaces.
//!
//! A patch lies at the start of the arena, as in `surface`; where patches and surfaces are asked the same, a patch comes
//! as a surface of one. Points and other arguments are behind.

use super::arena;
use super::arena::Arena;
use super::decode_surface::{patch, surface};
use crate::curve::basis::Basis;
use crate::geometry::bounds::Bounds;
use crate::patch::Patch;
use crate::surface::surface_point::SurfacePoint;
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

/// Leaves the Gaussian and the mean curvature, k1 and k2.
#[wasm_bindgen]
pub fn patch_curvature(degree_u: usize, degree_v: usize, u: f64, v: f64) {
    arena::with(|a| {
        let c = patch(a, degree_u, degree_v).curvature(u, v);
        a.write_numbers(0, &[c.gaussian, c.mean, c.k1, c.k2]);
    });
}

/// The bound on the distance from two triangles.
#[wasm_bindgen]
pub fn patch_flatness(degree_u: usize, degree_v: usize) -> f64 {
    arena::with(|a| patch(a, degree_u, degree_v).flatness())
}

/// Leaves the net of the degrees one higher.
#[wasm_bindgen]
pub fn patch_elevate(degree_u: usize, degree_v: usize) -> isize {
    arena::answer(|a| {
        let high = patch(a, degree_u, degree_v).elevate()?;
        Ok(a.write(0, high.control_points()))
    })
}

/// In: sixteen geometry points and a basis matrix. Leaves the net.
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

/// Leaves the least and the greatest point of the box; nothing without patches.
#[wasm_bindgen]
pub fn surface_bounds() -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        Ok(surface
            .bounds()
            .map_or(0, |Bounds { min, max }| a.write(0, &[min, max])))
    })
}

/// Leaves the area.
#[wasm_bindgen]
pub fn surface_area() -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        Ok(a.write_numbers(0, &[surface.area()]))
    })
}

/// Leaves the volume; nothing where there is none.
#[wasm_bindgen]
pub fn surface_volume() -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        Ok(surface
            .volume()
            .map_or(0, |volume| a.write_numbers(0, &[volume])))
    })
}

/// In: a point behind the surface. Leaves the nearest point, as `write_points` does.
#[wasm_bindgen]
pub fn surface_nearest() -> isize {
    arena::answer(|a| {
        let (surface, end) = surface(a)?;
        let nearest = surface.nearest(a.point_in_space(end, 3))?;
        Ok(write_points(a, nearest.as_slice()))
    })
}

/// In: a ray's origin and direction behind the surface. Leaves the hits, as `write_points` does.
#[wasm_bindgen]
pub fn surface_ray() -> isize {
    arena::answer(|a| {
        let (surface, end) = surface(a)?;
        let [origin, direction] = [end, end + 3].map(|at| a.point_in_space(at, 3));
        let hits = surface.intersect_ray(origin, direction)?;
        Ok(write_points(a, &hits))
    })
}

/// Leaves seven numbers for each place: patch, u, v, the point, the distance.
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
