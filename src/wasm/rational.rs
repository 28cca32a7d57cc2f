//! Bindings of rational curves. Arguments: `count` control points at the start of the arena, then their weights, followed
//! by further arguments.

use super::arena;
use super::arena::Arena;
use super::spline;
use crate::curve::Nearest;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::rational::RationalCurve;
use glam::{DMat4, DVec2, DVec3};
use wasm_bindgen::prelude::wasm_bindgen;

/// Decodes a curve as 3D; see [`Arena::points_in_space`].
fn curve(a: &Arena, dimension: usize, count: usize) -> RationalCurve<DVec3> {
    let points = (0..count).map(|k| a.point_in_space(k * dimension, dimension));
    RationalCurve::from_valid(points.zip(weights(a, dimension, count)))
}

fn plane_curve(a: &Arena, count: usize) -> RationalCurve<DVec2> {
    let points = a.points::<DVec2>(0, count).iter().copied();
    RationalCurve::from_valid(points.zip(weights(a, 2, count)))
}

fn weights(a: &Arena, dimension: usize, count: usize) -> impl Iterator<Item = f64> {
    a.numbers(count * dimension, count).iter().copied()
}

/// Where the further arguments start.
fn end(dimension: usize, count: usize) -> usize {
    count * (dimension + 1)
}

/// Writes curves from number `at` on, one after the other; returns the end.
pub(super) fn write(
    a: &mut Arena,
    at: usize,
    dimension: usize,
    curves: &[RationalCurve<DVec3>],
) -> usize {
    curves.iter().fold(at, |at, curve| {
        let at = a.write_from_space(at, curve.control_points(), dimension);
        a.write_numbers(at, curve.weights())
    })
}

/// Writes the curve that `change` returns; returns the number of f64.
fn changed(
    dimension: usize,
    count: usize,
    change: impl FnOnce(RationalCurve<DVec3>) -> Result<RationalCurve<DVec3>, Error>,
) -> isize {
    arena::answer(|a| {
        let result = change(curve(a, dimension, count))?;
        Ok(write(a, 0, dimension, &[result]))
    })
}

/// Writes the k-th derivative at t.
#[wasm_bindgen]
pub fn rational_derivative_at(dimension: usize, count: usize, t: f64, k: usize) -> isize {
    arena::answer(|a| {
        let derivative = curve(a, dimension, count).derivative_at(t, k)?;
        Ok(a.write_from_space(0, &[derivative], dimension))
    })
}

/// Writes the unit tangent at t.
#[wasm_bindgen]
pub fn rational_tangent(dimension: usize, count: usize, t: f64) {
    arena::with(|a| a.write_point(curve(a, dimension, count).tangent(t)));
}

/// Writes the unit normal at t, in the plane and in space.
#[wasm_bindgen]
pub fn rational_normal(dimension: usize, count: usize, t: f64) {
    arena::with(|a| {
        let curve = curve(a, dimension, count);
        let turned = || DVec2::normal_of(curve.tangent(t).truncate(), DVec2::ZERO).extend(0.0);
        a.write_point(if dimension == 2 {
            turned()
        } else {
            curve.normal(t)
        });
    });
}

/// The curvature at t; signed in the plane.
#[wasm_bindgen]
pub fn rational_curvature(dimension: usize, count: usize, t: f64) -> f64 {
    arena::with(|a| {
        let curve = curve(a, dimension, count);
        let clockwise = dimension == 2 && curve.tangent(t).cross(curve.normal(t)).z < 0.0;
        if clockwise {
            -curve.curvature(t)
        } else {
            curve.curvature(t)
        }
    })
}

/// Writes both parts; returns the number of f64.
#[wasm_bindgen]
pub fn rational_split(dimension: usize, count: usize, t: f64) -> isize {
    arena::answer(|a| {
        let (left, right) = curve(a, dimension, count).split(t)?;
        Ok(write(a, 0, dimension, &[left, right]))
    })
}

/// Writes the subsegment.
#[wasm_bindgen]
pub fn rational_subsegment(dimension: usize, count: usize, t0: f64, t1: f64) -> isize {
    changed(dimension, count, |curve| curve.subsegment(t0..t1))
}

/// Writes the elevated curve.
#[wasm_bindgen]
pub fn rational_elevate(dimension: usize, count: usize) -> isize {
    changed(dimension, count, |curve| curve.elevate())
}

/// Writes the curve in standard form.
#[wasm_bindgen]
pub fn rational_reparametrize(dimension: usize, count: usize) -> isize {
    changed(dimension, count, |curve| curve.reparametrize())
}

/// Arguments: a 4 × 4 matrix after the weights, column by column. Writes the image of the curve.
#[wasm_bindgen]
pub fn rational_project(dimension: usize, count: usize) -> isize {
    arena::answer(|a| {
        let matrix = DMat4::from_cols_slice(a.numbers(end(dimension, count), 16));
        let image = curve(a, dimension, count).project(&matrix)?;
        Ok(write(a, 0, dimension, &[image]))
    })
}

/// Writes the minimum and the maximum corner of the box of the curve.
#[wasm_bindgen]
pub fn rational_bounds(dimension: usize, count: usize) {
    arena::with(|a| {
        let bounds = curve(a, dimension, count).bounds();
        a.write_from_space(0, &[bounds.min, bounds.max], dimension);
    });
}

/// Writes the parameters of the extrema of a coordinate.
#[wasm_bindgen]
pub fn rational_extrema(dimension: usize, count: usize, axis: usize) -> isize {
    arena::answer(|a| {
        let ts = curve(a, dimension, count).extrema(axis)?;
        Ok(a.write_numbers(0, &ts))
    })
}

/// Writes the parameters of the inflections of a plane curve.
#[wasm_bindgen]
pub fn rational_inflections(count: usize) -> usize {
    arena::with(|a| {
        let ts = plane_curve(a, count).inflections();
        a.write_numbers(0, &ts)
    })
}

/// Arguments: a point after the weights. Writes t, the distance and the nearest point.
#[wasm_bindgen]
pub fn rational_nearest(dimension: usize, count: usize) -> isize {
    arena::answer(|a| {
        let p = a.point_in_space(end(dimension, count), dimension);
        let Nearest { t, point, distance } = curve(a, dimension, count).nearest(p)?;
        Ok(a.write_numbers(0, &[t, distance, point.x, point.y, point.z]))
    })
}

/// Writes the points, then the parameters of a polyline; returns the number of vertices.
#[wasm_bindgen]
pub fn rational_flatten(dimension: usize, count: usize, tolerance: f64) -> isize {
    arena::answer(|a| {
        let line = curve(a, dimension, count).flatten(tolerance)?;
        let at = a.write_from_space(0, &line.points, dimension);
        a.write_numbers(at, &line.ts);
        Ok(line.ts.len())
    })
}

/// The length.
#[wasm_bindgen]
pub fn rational_length(dimension: usize, count: usize) -> f64 {
    arena::with(|a| curve(a, dimension, count).length())
}

/// The parameter at an arc length.
#[wasm_bindgen]
pub fn rational_time_at_length(dimension: usize, count: usize, s: f64) -> f64 {
    arena::with(|a| curve(a, dimension, count).time_at_length(s))
}

/// The area that a plane curve sweeps.
#[wasm_bindgen]
pub fn rational_area(count: usize) -> f64 {
    arena::with(|a| plane_curve(a, count).area())
}

/// Writes a spline within a tolerance; returns the number of f64.
#[wasm_bindgen]
pub fn rational_to_spline(dimension: usize, count: usize, tolerance: f64) -> isize {
    arena::answer(|a| {
        let result = curve(a, dimension, count).to_spline(tolerance)?;
        Ok(spline::write(a, &result, dimension))
    })
}
