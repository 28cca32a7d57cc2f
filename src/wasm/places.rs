//! Bindings of questions for places on curves. In: `count` control points at the start of the arena, further arguments
//! behind them.

use super::arena::{self, Arena};
use crate::curve::{Nearest, extrema_of, nearest_on, nearest_parameter, times_of};
use casteljau_kernels::nearest_in_space;
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

/// In: a point behind the control points. Leaves t, the distance and the nearest point.
#[wasm_bindgen]
pub fn curve_nearest(dimension: usize, count: usize) {
    arena::with(|a| {
        let p = a.point_in_space(count * dimension, dimension);
        // Without an allocation for the usual degrees.
        let mut few = [DVec3::ZERO; 4];
        let nearest = if let Some(points) = few.get_mut(..count) {
            for (k, point) in points.iter_mut().enumerate() {
                *point = a.point_in_space(k * dimension, dimension);
            }
            nearest_on(points, p)
        } else {
            let points: Vec<DVec3> = a.points_in_space(0, count, dimension);
            nearest_on(&points, p)
        };
        put_nearest(a, nearest);
    });
}

/// The parameter of the point of a plane cubic that is nearest to (x, y): no arena, for the call of every pointer move.
#[wasm_bindgen]
#[allow(
    clippy::too_many_arguments,
    reason = "numbers as arguments are the fastest way in"
)]
pub fn cubic_nearest(
    ax: f64,
    ay: f64,
    bx: f64,
    by: f64,
    cx: f64,
    cy: f64,
    dx: f64,
    dy: f64,
    x: f64,
    y: f64,
) -> f64 {
    let (points, p) = (
        [[ax, ay, 0.0], [bx, by, 0.0], [cx, cy, 0.0], [dx, dy, 0.0]],
        [x, y, 0.0],
    );
    // The kernel first, without the code around it, which is compiled for size.
    nearest_in_space(&points, &p)
        .unwrap_or_else(|| nearest_parameter(&points.map(DVec3::from), DVec3::from(p)))
}

pub(super) fn put_nearest(a: &mut Arena, nearest: Nearest<DVec3>) {
    let Nearest { t, point, distance } = nearest;
    a.put_numbers(0, &[t, distance, point.x, point.y, point.z]);
}

/// Leaves the parameters of the extrema of a coordinate.
#[wasm_bindgen]
pub fn curve_extrema(dimension: usize, count: usize, axis: usize) -> usize {
    arena::with(|a| a.put_numbers(0, &extrema_of(&coordinates(a, dimension, count, axis))))
}

/// Leaves the parameters where a coordinate has a value.
#[wasm_bindgen]
pub fn curve_times_at(dimension: usize, count: usize, axis: usize, value: f64) -> usize {
    arena::with(|a| a.put_numbers(0, &times_of(&coordinates(a, dimension, count, axis), value)))
}

fn coordinates(a: &Arena, dimension: usize, count: usize, axis: usize) -> Vec<f64> {
    (0..count).map(|k| a.number(k * dimension + axis)).collect()
}
