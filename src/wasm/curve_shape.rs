//! Bindings of extrema, inflections, cusps, tangents through a point, and the kind of a curve. Arguments: `count`
//! control points at the start of the arena, followed by further arguments.

use super::arena;
use super::arena::Arena;
use crate::curve::Curve;
use crate::curve::extrema::{extrema_of, times_of};
use crate::curve::inflections::inflections_of;
use crate::numeric::float::ulp;
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

/// Writes the parameters of the extrema of a coordinate.
#[wasm_bindgen]
pub fn curve_extrema(dimension: usize, count: usize, axis: usize) -> usize {
    arena::with(|a| a.write_numbers(0, &extrema_of(&coordinates(a, dimension, count, axis))))
}

/// Writes the parameters at which a coordinate has a given value.
#[wasm_bindgen]
pub fn curve_times_at_coordinate(dimension: usize, count: usize, axis: usize, value: f64) -> usize {
    arena::with(|a| a.write_numbers(0, &times_of(&coordinates(a, dimension, count, axis), value)))
}

fn coordinates(a: &Arena, dimension: usize, count: usize, axis: usize) -> Vec<f64> {
    (0..count).map(|k| a.number(k * dimension + axis)).collect()
}

/// Writes the parameters of the inflections of a plane curve.
#[wasm_bindgen]
pub fn curve_inflections(count: usize) -> usize {
    arena::with(|a| {
        let curve = space_curve(a, 2, count);
        let ts = inflections_of(curve.control_points(), ulp(curve.max_abs()));
        a.write_numbers(0, &ts)
    })
}

/// Writes the parameters of the cusps.
#[wasm_bindgen]
pub fn curve_cusps(dimension: usize, count: usize) -> usize {
    arena::with(|a| {
        let ts = space_curve(a, dimension, count).cusps();
        a.write_numbers(0, &ts)
    })
}

/// Arguments: a point after the control points, all in the plane. Writes the parameters of the tangents through it.
#[wasm_bindgen]
pub fn curve_tangents_from(count: usize) -> usize {
    arena::with(|a| {
        let ts = space_curve(a, 2, count).tangents_from_unchecked(a.point_in_space(2 * count, 2));
        a.write_numbers(0, &ts)
    })
}

/// The index of the kind in the order of `CurveKind`.
#[wasm_bindgen]
pub fn curve_classify(dimension: usize, count: usize) -> usize {
    arena::with(|a| space_curve(a, dimension, count).classify() as usize)
}

fn space_curve(a: &Arena, dimension: usize, count: usize) -> Curve<DVec3> {
    Curve::from_points(a.points_in_space(0, count, dimension))
}
