//! Bindings of offset curves. Splines are stored in the arena as in `spline`.

use super::arena;
use super::arena::Arena;
use super::optional;
use crate::curve::Curve;
use crate::spline::Join;
use crate::spline::offset::offset_of_curves;
use crate::spline::spline_builder::SplineBuilder;
use glam::DVec2;
use wasm_bindgen::prelude::wasm_bindgen;

/// Writes the spline of a builder; returns the number of f64.
fn write(a: &mut Arena, builder: &SplineBuilder) -> usize {
    let closed = f64::from(u8::from(builder.closed));
    let mut at = a.write_numbers(0, &[builder.degrees.len() as f64, closed]);
    for &degree in &builder.degrees {
        at = a.write_numbers(at, &[degree as f64]);
    }
    a.write_numbers(at, bytemuck::cast_slice(&builder.points))
}

/// Writes the offset curve of a plane curve as a spline; a tolerance of 0 stands for the default.
#[wasm_bindgen]
pub fn curve_offset(count: usize, distance: f64, tolerance: f64) -> isize {
    arena::answer(|a| {
        let curve = Curve::<DVec2>::from_slice(a.points(0, count));
        let builder = curve.offset_builder(distance, optional(tolerance))?;
        Ok(write(a, &builder))
    })
}

/// A join by its index in js/geometry/joins.ts.
pub(super) fn offset_join(index: u32) -> Join {
    match index {
        0 => Join::Round,
        1 => Join::Miter,
        _ => Join::Bevel,
    }
}

/// Arguments: a plane spline. Writes its offset curve; see `offset_join`.
#[wasm_bindgen]
pub fn spline_offset(distance: f64, tolerance: f64, join: u32) -> isize {
    arena::answer(|a| {
        let (segments, closed) = (a.count(0), a.number(1) != 0.0);
        let head = 2 + segments;
        let mut at = head;
        let mut curves = Vec::with_capacity(segments);
        for k in 0..segments {
            let degree = a.count(2 + k);
            let inner = k + 1 < segments || !closed;
            let mut points = a.points::<DVec2>(at, degree + usize::from(inner)).to_vec();
            if !inner {
                points.push(a.points(head, 1)[0]);
            }
            curves.push(Curve::from_slice(&points));
            at += 2 * degree;
        }
        let join = offset_join(join);
        let builder = offset_of_curves(&curves, closed, distance, optional(tolerance), join)?;
        Ok(write(a, &builder))
    })
}
