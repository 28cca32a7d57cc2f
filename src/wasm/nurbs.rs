//! Bindings of NURBS curves. Arguments and results: the degree, 1 if closed (else 0), the numbers of points and of knots, the
//! control points, the weights, the knots; further arguments follow.

use super::arena;
use super::arena::Arena;
use super::{intersect, rational, spline};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::rational::NurbsCurve;
use glam::{DMat4, DVec2, DVec3};
use wasm_bindgen::prelude::wasm_bindgen;

/// Decodes a curve as 3D (see [`Arena::points_in_space`]), and the index where it ends.
fn curve(a: &Arena, dimension: usize) -> Result<(NurbsCurve<DVec3>, usize), Error> {
    curve_at(a, 0, dimension, |at, count| {
        a.points_in_space(at, count, dimension)
    })
}

/// Decodes a plane curve at index `at` of the arena, and the index where it ends.
fn plane_curve(a: &Arena, at: usize) -> Result<(NurbsCurve<DVec2>, usize), Error> {
    curve_at(a, at, 2, |at, count| a.points(at, count).to_vec())
}

/// Decodes a curve whose points are read by `points`, from their index and their number.
pub(super) fn curve_at<P: Point>(
    a: &Arena,
    at: usize,
    dimension: usize,
    points: impl FnOnce(usize, usize) -> Vec<P>,
) -> Result<(NurbsCurve<P>, usize), Error> {
    let [degree, closed, count, knots] = [0, 1, 2, 3].map(|k| a.count(at + k));
    let points = points(at + 4, count);
    let at = at + 4 + count * dimension;
    let weights = a.numbers(at, count);
    let (at, end) = (at + count, at + count + knots);
    let knots = a.numbers(at, knots);
    let curve = NurbsCurve::new(degree, &points, Some(weights), knots, closed == 1)?;
    Ok((curve, end))
}

/// Writes a curve from number `at` on; returns the end.
pub(super) fn write(
    a: &mut Arena,
    at: usize,
    curve: &NurbsCurve<DVec3>,
    dimension: usize,
) -> usize {
    let counts = [
        curve.degree(),
        usize::from(curve.is_closed()),
        curve.control_points().len(),
        curve.knots().len(),
    ];
    let at = a.write_counts(at, counts.into_iter());
    let at = a.write_from_space(at, curve.control_points(), dimension);
    let at = a.write_numbers(at, curve.weights());
    a.write_numbers(at, curve.knots())
}

/// Writes the curve that `change` returns; returns the number of f64.
fn changed(
    dimension: usize,
    change: impl FnOnce(&Arena, NurbsCurve<DVec3>, usize) -> Result<NurbsCurve<DVec3>, Error>,
) -> isize {
    made(dimension, |a| {
        let (curve, end) = curve(a, dimension)?;
        change(a, curve, end)
    })
}

/// Writes the curve that `make` returns; returns the number of f64.
fn made(dimension: usize, make: impl FnOnce(&Arena) -> Result<NurbsCurve<DVec3>, Error>) -> isize {
    arena::answer(|a| {
        let result = make(a)?;
        Ok(write(a, 0, &result, dimension))
    })
}

/// Writes the number of segments, the values of t at their ends, and the segments as rational curves.
#[wasm_bindgen]
pub fn nurbs_segments(dimension: usize) -> isize {
    arena::answer(|a| {
        let (curve, _) = curve(a, dimension)?;
        let at = a.write_counts(0, [curve.segments().len()].into_iter());
        let at = a.write_numbers(at, curve.joints());
        Ok(rational::write(a, at, dimension, curve.segments()))
    })
}

/// Arguments: the center and two conjugate radii. Writes the arc between two angles.
#[wasm_bindgen]
pub fn nurbs_arc(dimension: usize, start: f64, end: f64) -> isize {
    made(dimension, |a| {
        let [center, u, v] = [0, 1, 2].map(|k| a.point_in_space(k * dimension, dimension));
        NurbsCurve::arc(center, u, v, start, end)
    })
}

/// Writes the curve of a degree through `count` points.
#[wasm_bindgen]
pub fn nurbs_interpolate(dimension: usize, count: usize, degree: usize) -> isize {
    made(dimension, |a| {
        let points: Vec<DVec3> = a.points_in_space(0, count, dimension);
        NurbsCurve::interpolate(&points, degree)
    })
}

/// Arguments: a spline. Writes it as a NURBS curve.
#[wasm_bindgen]
pub fn nurbs_from_spline(dimension: usize) -> isize {
    made(dimension, |a| {
        Ok(NurbsCurve::from(&spline::spline(a, dimension).0))
    })
}

/// Writes the curve with a knot inserted.
#[wasm_bindgen]
pub fn nurbs_insert_knot(dimension: usize, t: f64, times: usize) -> isize {
    changed(dimension, |_, curve, _| curve.insert_knot(t, times))
}

/// Arguments: `number` knots after the curve. Writes the curve with these knots inserted.
#[wasm_bindgen]
pub fn nurbs_refine(dimension: usize, number: usize) -> isize {
    changed(dimension, |a, curve, end| {
        curve.refine(a.numbers(end, number))
    })
}

/// Writes the bound on the distance, then the curve with a knot removed; without a tolerance it is 0.
#[wasm_bindgen]
pub fn nurbs_remove_knot(dimension: usize, t: f64, tolerance: f64) -> isize {
    arena::answer(|a| {
        let tolerance = (tolerance != 0.0).then_some(tolerance);
        let (result, error) = curve(a, dimension)?.0.remove_knot(t, tolerance)?;
        let at = a.write_numbers(0, &[error]);
        Ok(write(a, at, &result, dimension))
    })
}

/// Writes the elevated curve.
#[wasm_bindgen]
pub fn nurbs_elevate(dimension: usize) -> isize {
    changed(dimension, |_, curve, _| curve.elevate())
}

/// Writes the reversed curve.
#[wasm_bindgen]
pub fn nurbs_reverse(dimension: usize) -> isize {
    changed(dimension, |_, curve, _| Ok(curve.reverse()))
}

/// Writes the part from t0 to t1.
#[wasm_bindgen]
pub fn nurbs_subsegment(dimension: usize, t0: f64, t1: f64) -> isize {
    changed(dimension, |_, curve, _| curve.subsegment(t0..t1))
}

/// Arguments: a 4 × 4 matrix after the curve, column by column. Writes the image of the curve.
#[wasm_bindgen]
pub fn nurbs_project(dimension: usize) -> isize {
    changed(dimension, |a, curve, end| {
        curve.project(&DMat4::from_cols_slice(a.numbers(end, 16)))
    })
}

/// Writes the Greville abscissae.
#[wasm_bindgen]
pub fn nurbs_greville(dimension: usize) -> isize {
    arena::answer(|a| {
        let ts = curve(a, dimension)?.0.greville();
        Ok(a.write_numbers(0, &ts))
    })
}

/// Writes the minimum and the maximum corner of the box of the curve.
#[wasm_bindgen]
pub fn nurbs_bounds(dimension: usize) -> isize {
    arena::answer(|a| {
        let bounds = curve(a, dimension)?.0.bounds();
        Ok(a.write_from_space(0, &[bounds.min, bounds.max], dimension))
    })
}

/// Writes the parameters of the extrema of a coordinate.
#[wasm_bindgen]
pub fn nurbs_extrema(dimension: usize, axis: usize) -> isize {
    arena::answer(|a| {
        let ts = curve(a, dimension)?.0.extrema(axis)?;
        Ok(a.write_numbers(0, &ts))
    })
}

/// Writes the parameter at an arc length.
#[wasm_bindgen]
pub fn nurbs_time_at_length(dimension: usize, s: f64) -> isize {
    arena::answer(|a| {
        let t = curve(a, dimension)?.0.time_at_length(s);
        Ok(a.write_numbers(0, &[t]))
    })
}

/// Writes the points, then the parameters of a polyline; returns the number of vertices.
#[wasm_bindgen]
pub fn nurbs_flatten(dimension: usize, tolerance: f64) -> isize {
    arena::answer(|a| {
        let line = curve(a, dimension)?.0.flatten(tolerance)?;
        let at = a.write_from_space(0, &line.points, dimension);
        a.write_numbers(at, &line.ts);
        Ok(line.ts.len())
    })
}

/// Writes a spline within a tolerance; returns the number of f64.
#[wasm_bindgen]
pub fn nurbs_to_spline(dimension: usize, tolerance: f64) -> isize {
    arena::answer(|a| {
        let result = curve(a, dimension)?.0.to_spline(tolerance)?;
        Ok(spline::write(a, &result, dimension))
    })
}

/// Arguments: two plane curves. Writes their intersections; see `intersect.rs`.
#[wasm_bindgen]
pub fn nurbs_intersect() -> isize {
    arena::answer(|a| {
        let (first, end) = plane_curve(a, 0)?;
        let found = first.intersections(&plane_curve(a, end)?.0);
        Ok(intersect::write(a, &found))
    })
}

/// Writes the self-intersections of a plane curve; see `intersect.rs`.
#[wasm_bindgen]
pub fn nurbs_self_intersections() -> isize {
    arena::answer(|a| {
        let found = plane_curve(a, 0)?.0.self_intersections();
        Ok(intersect::write_selves(a, &found))
    })
}
