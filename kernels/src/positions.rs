//! Positions of a bicubic patch on a grid.

use crate::bicubic::{BicubicGrid, LANES, round, store};
use bytemuck::cast;
use wide::{f32x4, f64x2};

/// One row of the net.
type Row = [f64x2; 6];

/// All positions, line by line.
pub(crate) fn fill(grid: &BicubicGrid, net: &[[f64; 3]; 16], out: &mut [[f32; 3]]) {
    let columns = grid.u.len();
    let (first, rest) = out.split_at_mut(columns.min(out.len()));
    let (inner, last) = rest.split_at_mut(rest.len().saturating_sub(columns));
    let rows: [Row; 4] = cast(*net);
    for (line, &weights) in inner.chunks_exact_mut(columns).zip(&grid.v[1..]) {
        fill_line(grid, blend_rows(&rows, weights), line);
    }
    fill_sides(grid, net, first, last);
}

/// The control points in u of the curve at one v.
#[inline(always)]
fn blend_rows(rows: &[Row; 4], weights: [f64; 4]) -> [[f32; 3]; 4] {
    let weights = weights.map(f64x2::splat);
    let row: Row = std::array::from_fn(|i| blend(weights, rows.map(|row| row[i])));
    cast::<Row, [[f64; 3]; 4]>(row).map(|point| point.map(round))
}

/// One line between the sides.
#[inline(always)]
fn fill_line(grid: &BicubicGrid, points: [[f32; 3]; 4], line: &mut [[f32; 3]]) {
    let [a, b, c, d] = points.map(|point| point.map(f32x4::splat));
    for (out, lanes) in line.chunks_mut(LANES).zip(&grid.lanes) {
        let w = lanes.points;
        let sum = |axis: usize| {
            let outer = w[0] * a[axis] + w[3] * d[axis];
            let inner = w[1] * b[axis] + w[2] * c[axis];
            // 0 for −0, see `round`.
            outer + inner + f32x4::ZERO
        };
        store([sum(0), sum(1), sum(2)], out);
    }
    if let Some(last) = line.last_mut() {
        *last = points[3];
    }
}

/// The sides v = 0 and v = 1, both at once, in f64: as [`blend_rows`] gives the other two.
fn fill_sides(
    grid: &BicubicGrid,
    net: &[[f64; 3]; 16],
    first: &mut [[f32; 3]],
    last: &mut [[f32; 3]],
) {
    let points: [[f64x2; 3]; 4] = std::array::from_fn(|i| {
        std::array::from_fn(|axis| f64x2::new([net[i][axis], net[12 + i][axis]]))
    });
    for ((weights, first), last) in grid.u.iter().zip(first).zip(last) {
        let weights = weights.map(f64x2::splat);
        for axis in 0..3 {
            let [a, b] = blend(weights, points.map(|p| p[axis])).to_array();
            (first[axis], last[axis]) = (round(a), round(b));
        }
    }
}

#[inline(always)]
fn blend(w: [f64x2; 4], p: [f64x2; 4]) -> f64x2 {
    // From 0 as in the core, whose neighbours of other degrees must get the same.
    f64x2::ZERO + (w[0] * p[0] + w[3] * p[3]) + (w[1] * p[1] + w[2] * p[2])
}
