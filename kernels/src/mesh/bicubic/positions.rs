//! Positions of a bicubic patch on a grid.

use super::grid::BicubicGrid;
use super::lanes::{LANES, round, store};
use crate::numeric::lanes::{f32x4, f64x2};

/// The numbers of one row of the net.
type NetRow = [f64x2; 6];

/// Fills all positions, line by line.
#[inline(never)]
pub(crate) fn fill(grid: &BicubicGrid, net: &[[f64; 3]; 16], out: &mut [[f32; 3]]) {
    let columns = grid.u.len();
    let (first, rest) = out.split_at_mut(columns.min(out.len()));
    let (inner, last) = rest.split_at_mut(rest.len().saturating_sub(columns));
    let numbers = net.as_flattened();
    let rows: [NetRow; 4] = std::array::from_fn(|j| {
        std::array::from_fn(|k| f64x2::new([0, 1].map(|i| numbers[12 * j + 2 * k + i])))
    });
    for (line, &weights) in inner.chunks_exact_mut(columns).zip(&grid.v[1..]) {
        fill_line(grid, blend_rows(&rows, weights), line);
    }
    fill_sides(grid, net, first, last);
}

/// The control points of the curve in u at one v.
#[inline(always)]
fn blend_rows(rows: &[NetRow; 4], weights: [f64; 4]) -> [[f64; 3]; 4] {
    let weights = weights.map(f64x2::splat);
    let pairs: NetRow = std::array::from_fn(|k| blend(weights, rows.map(|row| row[k])));
    let numbers = pairs.map(f64x2::to_array);
    let numbers = numbers.as_flattened();
    std::array::from_fn(|i| std::array::from_fn(|axis| numbers[3 * i + axis]))
}

/// Fills one line between the edges v = 0 and v = 1.
#[inline(always)]
fn fill_line(grid: &BicubicGrid, [a, b, c, d]: [[f64; 3]; 4], line: &mut [[f32; 3]]) {
    if line.len() > LANES {
        let combine = |p: [f64; 3], q: [f64; 3], sign: f64| -> [f32x4; 3] {
            std::array::from_fn(|axis| f32x4::splat(round(p[axis] + sign * q[axis])))
        };
        let (outer, inner) = (combine(a, d, 1.0), combine(b, c, 1.0));
        let (outer_skew, inner_skew) = (combine(a, d, -1.0), combine(b, c, -1.0));
        for (k, lanes) in grid.lanes.iter().enumerate() {
            let [w, skew] = lanes.points;
            let even = |axis: usize| w[0] * outer[axis] + w[1] * inner[axis];
            let odd = |axis: usize| skew[0] * outer_skew[axis] + skew[1] * inner_skew[axis];
            let (even, odd) = ([0, 1, 2].map(even), [0, 1, 2].map(odd));
            let near = [0, 1, 2].map(|axis| even[axis] + odd[axis]);
            let far = [0, 1, 2].map(|axis| even[axis] - odd[axis]);
            store(near, far, 1 + k * LANES, line);
        }
    } else {
        for (point, w) in line.iter_mut().zip(&grid.u) {
            *point = std::array::from_fn(|axis| {
                round(w[0] * a[axis] + w[1] * b[axis] + w[2] * c[axis] + w[3] * d[axis])
            });
        }
    }
    if let [first, .., last] = line {
        (*first, *last) = (a.map(round), d.map(round));
    }
}

/// Fills the edges v = 0 and v = 1, both at once, in f64, with the same formula that [`blend_rows`] uses for the other
/// two.
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
    // The sum starts from 0 as in the core, because adjacent patches of other degrees must get the same bits.
    f64x2::ZERO + (w[0] * p[0] + w[3] * p[3]) + (w[1] * p[1] + w[2] * p[2])
}
