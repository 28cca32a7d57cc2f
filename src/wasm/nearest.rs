//! Bindings of nearest points and distances. Arguments: `count` control points at the start of the arena, followed by
//! further arguments.

use super::arena;
use super::arena::Arena;
use crate::curve::Curve;
use crate::curve::nearest::distance::Distance;
use crate::curve::nearest::{Nearest, nearest_on, nearest_parameter};
use casteljau_kernels::curve::nearest::search::nearest_in_space;
use glam::DVec3;
use wasm_bindgen::prelude::wasm_bindgen;

/// Arguments: a point after the control points. Writes t, the distance and the nearest point.
#[wasm_bindgen]
pub fn curve_nearest(dimension: usize, count: usize) {
    arena::with(|a| {
        let p = a.point_in_space(count * dimension, dimension);
        // The usual degrees need no allocation.
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
        write_nearest(a, nearest);
    });
}

/// The parameter of the point of a plane cubic nearest to (x, y). Called for every pointer move; it does not use the
/// arena.
#[wasm_bindgen]
#[allow(
    clippy::too_many_arguments,
    reason = "passing numbers as arguments is the fastest"
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
    let points = [(ax, ay), (bx, by), (cx, cy), (dx, dy)].map(|(x, y)| DVec3::new(x, y, 0.0));
    let p = DVec3::new(x, y, 0.0);
    // Try the kernel first, because the code around it is compiled for size.
    nearest_in_space(&points, p).unwrap_or_else(|| nearest_parameter(&points, p))
}

fn write_nearest(a: &mut Arena, nearest: Nearest<DVec3>) {
    let Nearest { t, point, distance } = nearest;
    a.write_numbers(0, &[t, distance, point.x, point.y, point.z]);
}

/// Arguments: the control points of another curve after those of the first. Writes the distance, t and u.
#[wasm_bindgen]
pub fn curve_distance(dimension: usize, count: usize, other_count: usize) {
    arena::with(|a| {
        let [first, other] = two(a, dimension, count, other_count);
        let Distance { distance, t, u } = first.distance_to(&other);
        a.write_numbers(0, &[distance, t, u]);
    });
}

/// The Hausdorff distance of two curves, stored one after the other.
#[wasm_bindgen]
pub fn curve_hausdorff(dimension: usize, count: usize, other_count: usize) -> f64 {
    arena::with(|a| {
        let [first, other] = two(a, dimension, count, other_count);
        first.hausdorff(&other)
    })
}

fn two(a: &Arena, dimension: usize, count: usize, other_count: usize) -> [Curve<DVec3>; 2] {
    [(0, count), (count * dimension, other_count)]
        .map(|(at, count)| Curve::from_points(a.points_in_space(at, count, dimension)))
}
