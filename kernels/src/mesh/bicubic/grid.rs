//! Evaluation of a bicubic patch on a grid: positions and unit normals.
//!
//! For each v, the rows of the net are blended into one curve in u, in f64; then that curve is evaluated along u, four
//! samples at a time in f32. Normals come from the normal net (the Bernstein form of ∂u × ∂v, see `normals`), so that
//! nothing cancels in f32. Where the result is still too small, the sample is computed again in f64.

use super::lanes::{LANES, round};
use crate::bernstein::weights;
use crate::numeric::lanes::f32x4;

/// The samples of a grid, prepared for any number of bicubic patches.
#[derive(Clone, Debug)]
pub struct BicubicGrid {
    /// The number of segments along u.
    pub segments_u: usize,
    /// The number of segments along v.
    pub segments_v: usize,
    /// The weights of degree 3 at each sample along u.
    pub u: Vec<[f64; 4]>,
    /// The same along v.
    pub v: Vec<[f64; 4]>,
    /// The weights of degree 5 along v.
    pub normal_weights_v: Vec<[f32; 6]>,
    /// Groups of four samples along u, from the second to the middle. The samples after the middle are mirror images,
    /// and the first and the last sample come from control points.
    pub lanes: Vec<Lanes>,
}

/// The weights at four samples t, and at the four parameters 1 − t.
///
/// Exchanging t and 1 − t exchanges wᵢ and wₘ₋ᵢ. So Σ wᵢ cᵢ = S + D at t and S − D at 1 − t, where S sums the terms
/// ½(wᵢ + wₘ₋ᵢ)(cᵢ + cₘ₋ᵢ) and D the terms ½(wᵢ − wₘ₋ᵢ)(cᵢ − cₘ₋ᵢ) over the first half of the i. This nearly halves the
/// work.
#[derive(Clone, Copy, Debug)]
pub struct Lanes {
    /// ½(wᵢ ± wₘ₋ᵢ) for degree 3.
    pub points: [[f32x4; 2]; 2],
    /// ½(wᵢ ± wₘ₋ᵢ) for degree 5.
    pub normals: [[f32x4; 3]; 2],
}

impl BicubicGrid {
    /// The samples at equal steps; both numbers of segments are at least 1.
    pub fn new(segments_u: usize, segments_v: usize) -> Self {
        let u: Vec<_> = (0..=segments_u)
            .map(|k| weights::cubic(k, segments_u))
            .collect();
        let v = if segments_v == segments_u {
            u.clone()
        } else {
            (0..=segments_v)
                .map(|k| weights::cubic(k, segments_v))
                .collect()
        };
        let normal_weights_v = (0..=segments_v)
            .map(|k| weights::quintic(k, segments_v).map(round))
            .collect();
        let lanes = (1..=segments_u / 2)
            .step_by(LANES)
            .map(|first| Lanes::new(first, segments_u))
            .collect();
        Self {
            segments_u,
            segments_v,
            u,
            v,
            normal_weights_v,
            lanes,
        }
    }
}

impl Lanes {
    fn new(first: usize, segments: usize) -> Self {
        // Grids with fewer than four segments have fewer samples.
        let at: [usize; LANES] = std::array::from_fn(|lane| (first + lane).min(segments));
        Self {
            points: halves(at.map(|k| weights::cubic(k, segments))),
            normals: halves(at.map(|k| weights::quintic(k, segments))),
        }
    }
}

/// ½(wᵢ ± wₘ₋ᵢ) for the first half of the i.
fn halves<const N: usize, const HALF: usize>(weights: [[f64; N]; LANES]) -> [[f32x4; HALF]; 2] {
    [1.0, -1.0].map(|sign| {
        std::array::from_fn(|i| {
            f32x4::new(weights.map(|w| round(0.5 * (w[i] + sign * w[N - 1 - i]))))
        })
    })
}
