//! Bindings of lengths, even steps, areas, torsion and frames. Curves and splines lie in the arena as in `curve` and
//! `spline`.

use super::arena::{self, Arena};
use super::given;
use crate::curve::{Curve, plane_cubic_length};
use glam::{DVec2, DVec3};
use wasm_bindgen::prelude::wasm_bindgen;

fn curve(a: &Arena, dimension: usize, count: usize) -> Curve<DVec3> {
    Curve::from_points(a.points_in_space(0, count, dimension))
}

/// The length of a plane cubic: no arena, for the call that is made most.
#[wasm_bindgen]
#[allow(clippy::too_many_arguments, reason = "the coordinates of four points")]
pub fn cubic_length(ax: f64, ay: f64, bx: f64, by: f64, cx: f64, cy: f64, dx: f64, dy: f64) -> f64 {
    plane_cubic_length([[ax, ay], [bx, by], [cx, cy], [dx, dy]])
}

/// Leaves the length; a tolerance of 0 stands for the default.
#[wasm_bindgen]
pub fn curve_length(dimension: usize, count: usize, tolerance: f64) -> isize {
    arena::answer(|a| {
        let length = curve(a, dimension, count).length(given(tolerance))?;
        Ok(a.put_numbers(0, &[length]))
    })
}

/// The area that a plane curve sweeps.
#[wasm_bindgen]
pub fn curve_area(count: usize) -> f64 {
    arena::with(|a| Curve::<DVec2>::from_slice(a.points(0, count)).area())
}
