//! Bindings of interpolating splines and B-splines. Results: a spline, as in `spline`.

use super::arena;
use super::spline::write;
use crate::spline::Spline;
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
