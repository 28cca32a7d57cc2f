//! Bindings of offset curves, degree reduction, interpolation, fitting and simplification. Splines are stored in the
//! arena as in `spline`.

use super::arena;
use super::arena::Arena;
use super::optional;
use crate::curve::Curve;
use crate::curve::offset::SplineBuilder;
use crate::spline::Spline;
use crate::spline::offset::{OffsetJoin, offset_of_curves};
use glam::{DVec2, DVec3};
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

/// Arguments: a plane spline. Writes its offset curve; join: 0 round, 1 miter, 2 bevel.
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
        let join = match join {
            1 => OffsetJoin::Miter,
            2 => OffsetJoin::Bevel,
            _ => OffsetJoin::Round,
        };
        let builder = offset_of_curves(&curves, closed, distance, optional(tolerance), join)?;
        Ok(write(a, &builder))
    })
}

/// Writes the error, then the control points of the curve with the degree reduced by one.
#[wasm_bindgen]
pub fn curve_reduce(dimension: usize, count: usize) -> usize {
    arena::with(|a| {
        let curve: Curve<DVec3> = Curve::from_points(a.points_in_space(0, count, dimension));
        let reduced = curve.reduce();
        let at = a.write_numbers(0, &[reduced.error]);
        a.write_from_space(at, reduced.curve.control_points(), dimension)
    })
}

/// Arguments: points, followed by as many parameters or none. Writes the control points of the interpolating curve.
#[wasm_bindgen]
pub fn curve_interpolate(dimension: usize, count: usize, number: usize) -> isize {
    arena::answer(|a| {
        let points: Vec<DVec3> = a.points_in_space(0, count, dimension);
        let ts = (number > 0).then(|| a.numbers(count * dimension, number));
        let curve = Curve::interpolate(&points, ts)?;
        Ok(a.write_from_space(0, curve.control_points(), dimension))
    })
}

/// Arguments: sampled points. Writes the fitted spline; a corner angle of 0 stands for the default.
#[wasm_bindgen]
pub fn spline_fit(
    dimension: usize,
    count: usize,
    tolerance: f64,
    corner_angle: f64,
    closed: bool,
) -> isize {
    arena::answer(|a| {
        let points: Vec<DVec3> = a.points_in_space(0, count, dimension);
        let spline = Spline::fit(&points, tolerance, optional(corner_angle), closed)?;
        Ok(crate::wasm::spline::write(a, &spline, dimension))
    })
}

/// Writes the simplified spline.
#[wasm_bindgen]
pub fn spline_simplify(dimension: usize, tolerance: f64) -> isize {
    crate::wasm::spline::changed(dimension, |_, spline, _| spline.simplify(tolerance))
}
