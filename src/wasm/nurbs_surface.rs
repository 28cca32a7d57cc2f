//! Bindings of rational patches and NURBS surfaces.
//!
//! Arguments of patches: the net, the weights. Arguments and results of surfaces: the degrees in u and v, the numbers of knots
//! in u and v, the net, the weights, the knots in u, the knots in v. Curves in space are encoded as in `nurbs.rs`. Further
//! arguments follow.

use super::arena;
use super::arena::Arena;
use super::nurbs;
use crate::geometry::error::Error;
use crate::rational::{NurbsCurve, NurbsSurface, RationalCurve, RationalPatch};
use glam::{DMat4, DVec3};
use wasm_bindgen::prelude::wasm_bindgen;

/// Decodes a patch, and the index where it ends.
fn patch(a: &Arena, degree_u: usize, degree_v: usize) -> Result<(RationalPatch, usize), Error> {
    let count = (degree_u + 1) * (degree_v + 1);
    let (net, weights) = (a.points(0, count), a.numbers(3 * count, count));
    let patch = RationalPatch::new(net, weights, degree_u, degree_v)?;
    Ok((patch, 4 * count))
}

/// Writes patches from number `at` on, one after the other; returns the end.
fn write_patches(a: &mut Arena, at: usize, patches: &[RationalPatch]) -> usize {
    patches
        .iter()
        .fold(at, |at, patch| write_patch(a, at, patch))
}

/// Writes the net and the weights of a patch from number `at` on; returns the end.
pub(super) fn write_patch(a: &mut Arena, at: usize, patch: &RationalPatch) -> usize {
    let at = a.write(at, patch.control_points());
    a.write_numbers(at, patch.weights())
}

/// Writes the point at (u, v), NaN where there is none.
#[wasm_bindgen]
pub fn rationalpatch_eval(degree_u: usize, degree_v: usize, u: f64, v: f64) -> isize {
    arena::answer(|a| {
        let p = patch(a, degree_u, degree_v)?.0.eval(u, v);
        Ok(a.write(0, &[p]))
    })
}

/// Writes ∂u, ∂v, ∂uu, ∂uv, ∂vv.
#[wasm_bindgen]
pub fn rationalpatch_partials(degree_u: usize, degree_v: usize, u: f64, v: f64) -> isize {
    arena::answer(|a| {
        let p = patch(a, degree_u, degree_v)?.0.partials(u, v);
        Ok(a.write(0, &[p.u, p.v, p.uu, p.uv, p.vv]))
    })
}

/// Writes the unit normal at (u, v).
#[wasm_bindgen]
pub fn rationalpatch_normal(degree_u: usize, degree_v: usize, u: f64, v: f64) -> isize {
    arena::answer(|a| {
        let normal = patch(a, degree_u, degree_v)?.0.normal(u, v);
        Ok(a.write(0, &[normal]))
    })
}

/// Writes the Gaussian and the mean curvature, k1 and k2.
#[wasm_bindgen]
pub fn rationalpatch_curvature(degree_u: usize, degree_v: usize, u: f64, v: f64) -> isize {
    arena::answer(|a| {
        let c = patch(a, degree_u, degree_v)?.0.curvature(u, v);
        Ok(a.write_numbers(0, &[c.gaussian, c.mean, c.k1, c.k2]))
    })
}

/// Writes the points and the weights of the curve of constant u (or v).
#[wasm_bindgen]
pub fn rationalpatch_isocurve(
    degree_u: usize,
    degree_v: usize,
    constant_u: bool,
    at: f64,
) -> isize {
    arena::answer(|a| {
        let (patch, _) = patch(a, degree_u, degree_v)?;
        let curve: RationalCurve<DVec3> = if constant_u {
            patch.isocurve_at_u(at)?
        } else {
            patch.isocurve_at_v(at)?
        };
        let end = a.write(0, curve.control_points());
        Ok(a.write_numbers(end, curve.weights()))
    })
}

/// Writes the parts before and after u (or v).
#[wasm_bindgen]
pub fn rationalpatch_split(degree_u: usize, degree_v: usize, along_u: bool, at: f64) -> isize {
    arena::answer(|a| {
        let (patch, _) = patch(a, degree_u, degree_v)?;
        let (before, after) = if along_u {
            patch.split_u(at)?
        } else {
            patch.split_v(at)?
        };
        Ok(write_patches(a, 0, &[before, after]))
    })
}

/// Writes the patch with both degrees elevated.
#[wasm_bindgen]
pub fn rationalpatch_elevate(degree_u: usize, degree_v: usize) -> isize {
    arena::answer(|a| {
        let high = patch(a, degree_u, degree_v)?.0.elevate()?;
        Ok(write_patches(a, 0, &[high]))
    })
}

/// Arguments: a 4 × 4 matrix after the patch, column by column. Writes the image of the patch.
#[wasm_bindgen]
pub fn rationalpatch_project(degree_u: usize, degree_v: usize) -> isize {
    arena::answer(|a| {
        let (patch, end) = patch(a, degree_u, degree_v)?;
        let image = patch.project(&DMat4::from_cols_slice(a.numbers(end, 16)))?;
        Ok(write_patches(a, 0, &[image]))
    })
}

/// Writes the minimum and the maximum corner of the box of the patch.
#[wasm_bindgen]
pub fn rationalpatch_bounds(degree_u: usize, degree_v: usize) -> isize {
    arena::answer(|a| {
        let bounds = patch(a, degree_u, degree_v)?.0.bounds();
        Ok(a.write(0, &[bounds.min, bounds.max]))
    })
}

/// Decodes a surface, and the index where it ends.
fn surface(a: &Arena) -> Result<(NurbsSurface, usize), Error> {
    let [degree_u, degree_v, knots_u, knots_v] = [0, 1, 2, 3].map(|k| a.count(k));
    let count = (knots_u - degree_u - 1) * (knots_v - degree_v - 1);
    let (weights, u) = (4 + 3 * count, 4 + 4 * count);
    let (v, end) = (u + knots_u, u + knots_u + knots_v);
    let surface = NurbsSurface::new(
        degree_u,
        degree_v,
        a.points(4, count),
        Some(a.numbers(weights, count)),
        a.numbers(u, knots_u),
        a.numbers(v, knots_v),
    )?;
    Ok((surface, end))
}

/// Writes a surface from number `at` on; returns the end.
fn write(a: &mut Arena, at: usize, surface: &NurbsSurface) -> usize {
    let counts = [
        surface.degree_u(),
        surface.degree_v(),
        surface.knots_u().len(),
        surface.knots_v().len(),
    ];
    let at = a.write_counts(at, counts.into_iter());
    let at = a.write(at, surface.control_points());
    let lists = [surface.weights(), surface.knots_u(), surface.knots_v()];
    lists
        .iter()
        .fold(at, |at, numbers| a.write_numbers(at, numbers))
}

/// Writes the surface that `make` returns.
fn made(make: impl FnOnce(&Arena) -> Result<NurbsSurface, Error>) -> isize {
    arena::answer(|a| {
        let result = make(a)?;
        Ok(write(a, 0, &result))
    })
}

/// Decodes curves that follow each other from the start of the arena, and the index where they end.
pub(super) fn curves(a: &Arena, count: usize) -> Result<(Vec<NurbsCurve<DVec3>>, usize), Error> {
    let (mut all, mut at) = (Vec::new(), 0);
    for _ in 0..count {
        let (curve, end) = nurbs::curve_at(a, at, 3, |at, count| a.points(at, count).to_vec())?;
        all.push(curve);
        at = end;
    }
    Ok((all, at))
}

/// Writes the numbers of values of u and of v at the edges of the patches, these values, and the patches.
#[wasm_bindgen]
pub fn nurbssurface_patches() -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        let joints = [surface.joints_u(), surface.joints_v()];
        let at = a.write_counts(0, joints.iter().map(|joints| joints.len()));
        let at = joints
            .iter()
            .fold(at, |at, numbers| a.write_numbers(at, numbers));
        Ok(write_patches(a, at, surface.patches()))
    })
}

/// Writes the surface with a knot inserted.
#[wasm_bindgen]
pub fn nurbssurface_insert_knot(along_u: bool, at: f64, times: usize) -> isize {
    made(|a| {
        let (surface, _) = surface(a)?;
        if along_u {
            surface.insert_knot_u(at, times)
        } else {
            surface.insert_knot_v(at, times)
        }
    })
}

/// Writes the surface with a higher degree.
#[wasm_bindgen]
pub fn nurbssurface_elevate(along_u: bool) -> isize {
    made(|a| {
        let (surface, _) = surface(a)?;
        if along_u {
            surface.elevate_u()
        } else {
            surface.elevate_v()
        }
    })
}

/// Writes the parts before and after u (or v).
#[wasm_bindgen]
pub fn nurbssurface_split(along_u: bool, at: f64) -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        let (before, after) = if along_u {
            surface.split_u(at)?
        } else {
            surface.split_v(at)?
        };
        let end = write(a, 0, &before);
        Ok(write(a, end, &after))
    })
}

/// Writes the curve of constant u (or v).
#[wasm_bindgen]
pub fn nurbssurface_isocurve(constant_u: bool, at: f64) -> isize {
    arena::answer(|a| {
        let (surface, _) = surface(a)?;
        let curve = if constant_u {
            surface.isocurve_at_u(at)?
        } else {
            surface.isocurve_at_v(at)?
        };
        Ok(nurbs::write(a, 0, &curve, 3))
    })
}

/// Writes the surface with u in the opposite direction.
#[wasm_bindgen]
pub fn nurbssurface_reverse() -> isize {
    made(|a| Ok(surface(a)?.0.reverse()))
}

/// Arguments: a 4 × 4 matrix after the surface, column by column. Writes the image of the surface.
#[wasm_bindgen]
pub fn nurbssurface_project() -> isize {
    made(|a| {
        let (surface, end) = surface(a)?;
        surface.project(&DMat4::from_cols_slice(a.numbers(end, 16)))
    })
}

/// Writes the minimum and the maximum corner of the box of the surface.
#[wasm_bindgen]
pub fn nurbssurface_bounds() -> isize {
    arena::answer(|a| {
        let bounds = surface(a)?.0.bounds();
        Ok(a.write(0, &[bounds.min, bounds.max]))
    })
}

/// Arguments: a corner and two sides. Writes the parallelogram.
#[wasm_bindgen]
pub fn nurbssurface_plane() -> isize {
    made(|a| {
        let [origin, u, v] = [0, 3, 6].map(|at| a.point_in_space(at, 3));
        NurbsSurface::plane(origin, u, v)
    })
}

/// Arguments: the center and the axis. Writes a cylinder (`kind` 0) or a cone (1) of the radius `a` and the height `b`, a sphere (2)
/// of the radius `a`, or a torus (3) of the radii `a` and `b`.
#[wasm_bindgen]
pub fn nurbssurface_shape(kind: u32, a: f64, b: f64) -> isize {
    made(|arena| {
        let [center, axis] = [0, 3].map(|at| arena.point_in_space(at, 3));
        match kind {
            0 => NurbsSurface::cylinder(center, a, b, axis),
            1 => NurbsSurface::cone(center, a, b, axis),
            2 => NurbsSurface::sphere(center, a, axis),
            _ => NurbsSurface::torus(center, a, b, axis),
        }
    })
}

/// Arguments: two curves. Writes the ruled surface between them.
#[wasm_bindgen]
pub fn nurbssurface_ruled() -> isize {
    made(|a| {
        let (curves, _) = curves(a, 2)?;
        NurbsSurface::ruled(&curves[0], &curves[1])
    })
}

/// Arguments: a curve, a vector. Writes the extruded surface.
#[wasm_bindgen]
pub fn nurbssurface_extrude() -> isize {
    made(|a| {
        let (curves, end) = curves(a, 1)?;
        NurbsSurface::extrude(&curves[0], a.point_in_space(end, 3))
    })
}

/// Arguments: a profile, a point of the axis and its direction. Writes the surface of revolution.
#[wasm_bindgen]
pub fn nurbssurface_revolve(angle: f64) -> isize {
    made(|a| {
        let (curves, end) = curves(a, 1)?;
        let [origin, axis] = [end, end + 3].map(|at| a.point_in_space(at, 3));
        NurbsSurface::revolve(&curves[0], origin, axis, angle)
    })
}

/// Arguments: curves. Writes the surface through them.
#[wasm_bindgen]
pub fn nurbssurface_loft(count: usize, degree: usize) -> isize {
    made(|a| NurbsSurface::loft(&curves(a, count)?.0, degree))
}
