//! Bindings of interpolation, fitting and simplification, and of B-splines. Splines are stored in the arena as in `spline`.

use super::arena;
use super::optional;
use super::spline::{changed, write};
use crate::curve::Curve;
use crate::spline::{FitEffort, FitOptions, SimplifyOptions, Spline};
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

/// Arguments: points. Writes the Catmull-Rom spline through them if alpha ≥ 0, otherwise the natural spline.
#[wasm_bindgen]
pub fn spline_interpolate(dimension: usize, count: usize, closed: bool, alpha: f64) -> isize {
    arena::answer(|a| {
        let points: Vec<DVec3> = a.points_in_space(0, count, dimension);
        // JavaScript's power function: Rust's would add two kilobytes to the module.
        let power = |length| js_sys::Math::pow(length, alpha);
        let step: Option<&dyn Fn(f64) -> f64> = if alpha < 0.0 { None } else { Some(&power) };
        let spline = Spline::interpolate_with(&points, closed, step)?;
        Ok(write(a, &spline, dimension))
    })
}

/// Arguments: points, then knots (none for uniform knots). Writes the Bézier form of the B-spline.
#[wasm_bindgen]
pub fn spline_from_bspline(
    dimension: usize,
    count: usize,
    degree: usize,
    closed: bool,
    knots: usize,
) -> isize {
    arena::answer(|a| {
        let points: Vec<DVec3> = a.points_in_space(0, count, dimension);
        let knots = a.numbers(count * dimension, knots).to_vec();
        let explicit_knots = (!knots.is_empty()).then_some(&knots[..]);
        let spline = Spline::from_bspline(&points, degree, explicit_knots, closed)?;
        Ok(write(a, &spline, dimension))
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
    best: bool,
) -> isize {
    arena::answer(|a| {
        let points: Vec<DVec3> = a.points_in_space(0, count, dimension);
        let mut options = FitOptions::new(tolerance).closed(closed);
        options.corner_angle = optional(corner_angle).unwrap_or(options.corner_angle);
        options.effort = effort(best);
        let spline = Spline::fit(&points, &options)?;
        Ok(write(a, &spline, dimension))
    })
}

const fn effort(best: bool) -> FitEffort {
    if best {
        FitEffort::Best
    } else {
        FitEffort::Fast
    }
}

/// Writes the simplified spline; a corner angle of 0 stands for the default, a precision below 0 for none.
#[wasm_bindgen]
pub fn spline_simplify(
    dimension: usize,
    tolerance: f64,
    corner_angle: f64,
    extrema: bool,
    precision: i32,
    best: bool,
) -> isize {
    let mut options = SimplifyOptions::new(tolerance)
        .extrema(extrema)
        .effort(effort(best));
    options.corner_angle = optional(corner_angle).unwrap_or(options.corner_angle);
    options.precision = u8::try_from(precision).ok();
    changed(dimension, |_, spline, _| spline.simplify_with(&options))
}
