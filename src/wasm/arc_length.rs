//! Bindings of arc length and its inverse. Curves and splines are stored in the arena as in `curve` and `spline`.

use super::arena;
use super::arena::Arena;
use super::spline::spline;
use super::within;
use crate::curve::Curve;
use crate::geometry::error::Error;
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

fn curve(a: &Arena, dimension: usize, count: usize) -> Curve<DVec3> {
    Curve::from_points(a.points_in_space(0, count, dimension))
}

/// The length of a plane cubic. The most frequent call; it does not use the arena.
#[wasm_bindgen]
#[allow(clippy::too_many_arguments, reason = "the coordinates of four points")]
pub fn cubic_length(ax: f64, ay: f64, bx: f64, by: f64, cx: f64, cy: f64, dx: f64, dy: f64) -> f64 {
    casteljau_kernels::curve::arc_length::plane_cubic::plane_cubic_length(&[
        [ax, ay],
        [bx, by],
        [cx, cy],
        [dx, dy],
    ])
}

/// Writes the number that `f` returns.
fn number(f: impl FnOnce(&mut Arena) -> Result<f64, Error>) -> isize {
    arena::answer(|a| {
        let number = f(a)?;
        Ok(a.write_numbers(0, &[number]))
    })
}

/// Writes the length; a tolerance of 0 stands for the default.
#[wasm_bindgen]
pub fn curve_length(dimension: usize, count: usize, tolerance: f64) -> isize {
    number(|a| {
        let curve = curve(a, dimension, count);
        within(
            tolerance,
            || curve.length(),
            |error| curve.length_within(error),
        )
    })
}

/// Writes the parameter at an arc length.
#[wasm_bindgen]
pub fn curve_time_at_length(dimension: usize, count: usize, s: f64, tolerance: f64) -> isize {
    number(|a| {
        let curve = curve(a, dimension, count);
        within(
            tolerance,
            || curve.time_at_length(s),
            |error| curve.time_at_length_within(s, error),
        )
    })
}

/// Writes `segments` + 1 parameters.
#[wasm_bindgen]
pub fn curve_equidistant_times(dimension: usize, count: usize, segments: usize) -> isize {
    arena::answer(|a| {
        let ts = curve(a, dimension, count).equidistant_times(segments)?;
        Ok(a.write_numbers(0, &ts))
    })
}

/// Writes the length; a tolerance of 0 stands for the default.
#[wasm_bindgen]
pub fn spline_length(dimension: usize, tolerance: f64) -> isize {
    number(|a| {
        let spline = spline(a, dimension).0;
        within(
            tolerance,
            || spline.length(),
            |error| spline.length_within(error),
        )
    })
}

/// Writes the parameter at an arc length.
#[wasm_bindgen]
pub fn spline_time_at_length(dimension: usize, s: f64, tolerance: f64) -> isize {
    number(|a| {
        let spline = spline(a, dimension).0;
        within(
            tolerance,
            || spline.time_at_length(s),
            |error| spline.time_at_length_within(s, error),
        )
    })
}

/// Writes `segments` + 1 parameters.
#[wasm_bindgen]
pub fn spline_equidistant_times(dimension: usize, segments: usize) -> isize {
    arena::answer(|a| {
        let ts = spline(a, dimension).0.equidistant_times(segments)?;
        Ok(a.write_numbers(0, &ts))
    })
}
