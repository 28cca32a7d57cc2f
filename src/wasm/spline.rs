//! Bindings of splines. Arguments and results: the number of segments, 1 if closed (else 0), the degree of each
//! segment, the control points; further arguments follow.

use super::arena;
use super::arena::Arena;
use super::optional;
use crate::curve::Curve;
use crate::geometry::error::Error;
use crate::spline::Spline;
use crate::spline::joint::JointMode;
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

/// The spline at the start of the arena (see [`Arena::points_in_space`]), and the index where it ends.
pub(crate) fn spline(a: &Arena, dimension: usize) -> (Spline<DVec3>, usize) {
    spline_at(a, 0, dimension)
}

/// The spline at index `at` of the arena, and the index where it ends.
pub(crate) fn spline_at(a: &Arena, at: usize, dimension: usize) -> (Spline<DVec3>, usize) {
    let (segments, closed) = (a.count(at), a.number(at + 1) != 0.0);
    let at = at + 2;
    let degrees: Vec<usize> = (0..segments).map(|k| a.count(at + k)).collect();
    let count = degrees.iter().sum::<usize>() + usize::from(!closed);
    let at = at + segments;
    (
        Spline::from_parts(a.points_in_space(at, count, dimension), &degrees, closed),
        at + count * dimension,
    )
}

/// Writes a spline; returns the number of f64.
pub(crate) fn write(a: &mut Arena, spline: &Spline<DVec3>, dimension: usize) -> usize {
    let closed = if spline.is_closed() { 1.0 } else { 0.0 };
    let mut head = vec![spline.segment_count() as f64, closed];
    head.extend(spline.degrees().iter().map(|&degree| degree as f64));
    let at = a.write_numbers(0, &head);
    a.write_from_space(at, spline.control_points(), dimension)
}

/// Writes the spline that `change` returns; returns the number of f64.
pub(crate) fn changed(
    dimension: usize,
    change: impl FnOnce(&Arena, Spline<DVec3>, usize) -> Result<Spline<DVec3>, Error>,
) -> isize {
    arena::answer(|a| {
        let (spline, end) = spline(a, dimension);
        let result = change(a, spline, end)?;
        Ok(write(a, &result, dimension))
    })
}

/// The joint mode of a code, as in `js/geometry/joints.ts`.
fn mode(code: usize) -> JointMode {
    const MODES: [JointMode; 6] = [
        JointMode::Free,
        JointMode::G1,
        JointMode::C1,
        JointMode::C2,
        JointMode::G2,
        JointMode::Auto,
    ];
    MODES.get(code).copied().unwrap_or_default()
}

/// Arguments: the number of curves, 1 if closed (else 0), the degree of each, all their control points. Writes the
/// spline.
#[wasm_bindgen]
pub fn spline_from_curves(dimension: usize) -> isize {
    arena::answer(|a| {
        let (count, closed) = (a.count(0), a.number(1) != 0.0);
        let mut at = 2 + count;
        let curve = |k: usize| {
            let (start, count) = (at, a.count(2 + k) + 1);
            at += count * dimension;
            Curve::from_points(a.points_in_space(start, count, dimension))
        };
        let curves: Vec<_> = (0..count).map(curve).collect();
        let spline = Spline::from_curves(&curves, closed)?;
        Ok(write(a, &spline, dimension))
    })
}

/// Writes points at even steps of t; returns the number of f64.
#[wasm_bindgen]
pub fn spline_sample(dimension: usize, per_curve: usize) -> isize {
    arena::answer(|a| {
        let points = spline(a, dimension).0.sample(per_curve)?;
        Ok(a.write_from_space(0, &points, dimension))
    })
}

/// Arguments: `number` parameters after the spline. Writes the points at the parameters.
#[wasm_bindgen]
pub fn spline_eval_at(dimension: usize, number: usize) -> usize {
    arena::with(|a| {
        let (spline, end) = spline(a, dimension);
        let points = spline.eval_at(a.numbers(end, number));
        a.write_from_space(0, &points, dimension)
    })
}

/// Writes the points, then the parameters of a polyline; returns the number of vertices.
#[wasm_bindgen]
pub fn spline_flatten(dimension: usize, tolerance: f64) -> isize {
    arena::answer(|a| {
        let line = spline(a, dimension).0.flatten(tolerance)?;
        let end = a.write_from_space(0, &line.points, dimension);
        a.write_numbers(end, &line.ts);
        Ok(line.ts.len())
    })
}

/// Writes the minimum and the maximum corner of the box of the spline or of its control points.
#[wasm_bindgen]
pub fn spline_bounds(dimension: usize, exact: bool) {
    arena::with(|a| {
        let (spline, _) = spline(a, dimension);
        let bounds = if exact {
            spline.bounds()
        } else {
            spline.control_bounds()
        };
        a.write_from_space(0, &[bounds.min, bounds.max], dimension);
    });
}

/// Writes c0, g1, c1, g2, c2 as 0 or 1, the gap and the angle; a tolerance of 0 stands for the default.
#[wasm_bindgen]
pub fn spline_continuity(dimension: usize, joint: usize, tolerance: f64) -> isize {
    arena::answer(|a| {
        let (spline, _) = spline(a, dimension);
        let c = spline.continuity_at(joint, optional(tolerance))?;
        let flags = [c.c0, c.g1, c.c1, c.g2, c.c2].map(|flag| f64::from(u8::from(flag)));
        let at = a.write_numbers(0, &flags);
        Ok(a.write_numbers(at, &[c.gap, c.angle]))
    })
}

/// Arguments: a point after the spline. Writes the extended spline.
#[wasm_bindgen]
pub fn spline_append(dimension: usize) -> isize {
    changed(dimension, |a, spline, end| {
        spline.append(a.point_in_space(end, dimension))
    })
}

/// Arguments: the new position after the spline, then a mode code for the start of each segment (see [`mode`]).
#[wasm_bindgen]
pub fn spline_move_point(dimension: usize, index: usize) -> isize {
    changed(dimension, |a, mut spline, end| {
        let to = a.point_in_space(end, dimension);
        spline.move_point_unchecked(index, to, |joint| mode(a.count(end + dimension + joint)))?;
        Ok(spline)
    })
}

/// Writes the spline with the mode of a code enforced at one joint.
#[wasm_bindgen]
pub fn spline_set_joint(dimension: usize, joint: usize, code: usize) -> isize {
    changed(dimension, |_, spline, _| {
        spline.set_joint_unchecked(joint, mode(code))
    })
}

/// Writes the spline with a joint inserted at t.
#[wasm_bindgen]
pub fn spline_insert(dimension: usize, t: f64) -> isize {
    changed(dimension, |_, spline, _| spline.insert(t))
}

/// Writes the spline with a joint removed.
#[wasm_bindgen]
pub fn spline_remove(dimension: usize, joint: usize) -> isize {
    changed(dimension, |_, spline, _| spline.remove(joint))
}

/// Writes the reversed spline.
#[wasm_bindgen]
pub fn spline_reverse(dimension: usize) -> isize {
    changed(dimension, |_, spline, _| Ok(spline.reverse()))
}

/// The area that a plane spline sweeps; for a closed spline, the enclosed area.
#[wasm_bindgen]
pub fn spline_area() -> f64 {
    arena::with(|a| spline(a, 2).0.area_xy())
}
