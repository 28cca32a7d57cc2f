//! The innermost loops of the crate `casteljau`: numbers in, numbers out.
//!
//! They live apart so that a build for small size can compile them for speed. They check nothing but lengths.

mod bend;
mod lattice;
mod sample;

pub use bend::{BEND_SLACK, Bends, Sizes};
pub use lattice::{Cell, Lattice, first, pair, place, second, sort_distinct};
pub use sample::{Sampler, Vector};

use wide::f64x2;

/// Points of the plane cubic with the given control points at even steps of t from 0 to 1; `out` holds x and y in turn.
///
/// Two points at a time. Every weight and sum is rounded as in the scalar formula, so the numbers are the same.
pub fn sample_plane_cubic(points: &[[f64; 2]; 4], out: &mut [f64]) {
    let last = f64x2::splat((out.len() / 2).saturating_sub(1).max(1) as f64);
    let x = points.map(|[x, _]| f64x2::splat(x));
    let y = points.map(|[_, y]| f64x2::splat(y));
    let two_points = |i: f64x2| {
        let weights = cubic_weights(i / last);
        let ([x0, x1], [y0, y1]) = (blend(&x, weights).to_array(), blend(&y, weights).to_array());
        [x0, y0, x1, y1]
    };
    let (two, four) = (f64x2::splat(2.0), f64x2::splat(4.0));
    let mut i = f64x2::new([0.0, 1.0]);
    // Two pairs a turn: their divisions overlap.
    let mut quads = out.chunks_exact_mut(8);
    for quad in &mut quads {
        let (near, far) = quad.split_at_mut(4);
        near.copy_from_slice(&two_points(i));
        far.copy_from_slice(&two_points(i + two));
        i += four;
    }
    for pair in quads.into_remainder().chunks_mut(4) {
        pair.copy_from_slice(&two_points(i)[..pair.len()]);
        i += two;
    }
}

/// The Bernstein weights of degree 3.
#[inline(always)]
fn cubic_weights(t: f64x2) -> [f64x2; 4] {
    let s = f64x2::splat(1.0) - t;
    let (ss, tt, three) = (s * s, t * t, f64x2::splat(3.0));
    [ss * s, three * ss * t, three * s * tt, tt * t]
}

#[inline(always)]
fn blend(coordinates: &[f64x2; 4], [a, b, c, d]: [f64x2; 4]) -> f64x2 {
    coordinates[0] * a + coordinates[1] * b + coordinates[2] * c + coordinates[3] * d
}

/// One line of a bicubic grid: the patch at constant v, as curves in u.
#[derive(Clone, Copy, Debug)]
pub struct BicubicLine<'a> {
    /// The control points of the position.
    pub points: &'a [[f64; 3]; 4],
    /// Those of the direction of ∂u.
    pub along_u: &'a [[f64; 3]; 3],
    /// Those of the direction of ∂v.
    pub along_v: &'a [[f64; 3]; 4],
    /// The weights of degree 3 at each sample.
    pub values: &'a [[f64; 4]],
    /// The weights of degree 2 at each sample.
    pub slopes: &'a [[f64; 3]],
}

impl BicubicLine<'_> {
    /// Position and ∂u × ∂v at each sample, each rounded to f32; all four lists are equally long.
    ///
    /// Sums run from both ends towards the middle, so that reversed weights and points give the same bits.
    pub fn fill(&self, positions: &mut [[f32; 3]], facings: &mut [[f32; 3]]) {
        let samples = self
            .values
            .len()
            .min(self.slopes.len())
            .min(positions.len())
            .min(facings.len());
        let (values, slopes) = (&self.values[..samples], &self.slopes[..samples]);
        let (positions, facings) = (&mut positions[..samples], &mut facings[..samples]);
        let mut k = 0;
        while k < samples {
            // An odd last sample is computed twice.
            let next = (k + 1).min(samples - 1);
            let w: [f64x2; 4] =
                std::array::from_fn(|i| f64x2::new([values[k][i], values[next][i]]));
            let d: [f64x2; 3] =
                std::array::from_fn(|i| f64x2::new([slopes[k][i], slopes[next][i]]));
            let point = std::array::from_fn(|axis| sum4(&w, self.points.map(|p| p[axis])));
            let u: [f64x2; 3] = std::array::from_fn(|axis| sum3(&d, self.along_u.map(|p| p[axis])));
            let v: [f64x2; 3] = std::array::from_fn(|axis| sum4(&w, self.along_v.map(|p| p[axis])));
            let facing = [
                u[1] * v[2] - v[1] * u[2],
                u[2] * v[0] - v[2] * u[0],
                u[0] * v[1] - v[0] * u[1],
            ];
            [positions[k], positions[next]] = round(point);
            [facings[k], facings[next]] = round(facing);
            k += 2;
        }
    }
}

#[inline(always)]
fn sum4(w: &[f64x2; 4], p: [f64; 4]) -> f64x2 {
    let [a, b, c, d] = p.map(f64x2::splat);
    // From 0, which turns −0 into 0.
    f64x2::splat(0.0) + (w[0] * a + w[3] * d) + (w[1] * b + w[2] * c)
}

#[inline(always)]
fn sum3(w: &[f64x2; 3], p: [f64; 3]) -> f64x2 {
    let [a, b, c] = p.map(f64x2::splat);
    f64x2::splat(0.0) + (w[0] * a + w[2] * c) + w[1] * b
}

/// Two points of f32, from the coordinates of both.
#[inline(always)]
#[allow(
    clippy::cast_possible_truncation,
    reason = "rounding to f32 is what meshes are made of"
)]
fn round(p: [f64x2; 3]) -> [[f32; 3]; 2] {
    let [x, y, z] = p.map(f64x2::to_array);
    [
        [x[0] as f32, y[0] as f32, z[0] as f32],
        [x[1] as f32, y[1] as f32, z[1] as f32],
    ]
}
