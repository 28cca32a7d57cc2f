//! One bicubic patch on a grid: positions and unit normals.
//!
//! For each v the rows of the net are blended into one curve in u, in f64; then that curve is evaluated along u, four
//! samples at a time in f32. Normals come from the normal net (the Bernstein form of ∂u × ∂v, see `normals`), so that
//! nothing cancels in f32. Where little of it is left all the same, a sample is computed again in f64.

use crate::normals::larger;
use crate::{normals, positions, weights};
use wide::f32x4;

/// The samples of a grid, prepared for any number of bicubic patches.
#[derive(Clone, Debug)]
pub struct BicubicGrid {
    pub(crate) segments_u: usize,
    pub(crate) segments_v: usize,
    /// The weights of degree 3 at each sample along u and along v.
    pub(crate) u: Vec<[f64; 4]>,
    pub(crate) v: Vec<[f64; 4]>,
    /// The weights of degree 5 along v.
    pub(crate) facings_v: Vec<[f32; 6]>,
    /// Four samples each along u, from the second to the middle; those behind it are their mirror images, and the first
    /// and the last are control points.
    pub(crate) lanes: Vec<Lanes>,
}

/// The weights at four samples, and at the four at 1 − t.
///
/// Exchanging t and 1 − t exchanges wᵢ and wₘ₋ᵢ. So Σ wᵢ cᵢ = S + D at t and S − D at 1 − t, where S sums the terms
/// ½(wᵢ + wₘ₋ᵢ)(cᵢ + cₘ₋ᵢ) and D the terms ½(wᵢ − wₘ₋ᵢ)(cᵢ − cₘ₋ᵢ) of the first half of the i: nearly half the work.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lanes {
    /// ½(wᵢ ± wₘ₋ᵢ) for degree 3.
    pub(crate) points: [[f32x4; 2]; 2],
    /// The same for degree 5.
    pub(crate) facings: [[f32x4; 3]; 2],
}

/// How many samples are evaluated together.
pub(crate) const LANES: usize = 4;

impl BicubicGrid {
    /// The samples at even steps; both numbers of segments are at least 1.
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
        let facings_v = (0..=segments_v)
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
            facings_v,
            lanes,
        }
    }

    /// Whether f32 holds the coordinates and their sums.
    pub fn fits(net: &[[f64; 3]; 16]) -> bool {
        let numbers = net.as_flattened().iter();
        numbers.fold(0.0, |max, n| larger(max, n.abs())) < f64::from(f32::MAX / 16.0)
    }

    /// Positions and unit normals of the patch with this net, u along the fast index. True if normals are missing:
    /// those are left at zero.
    ///
    /// Both lists hold a point for each sample, u along the fast index. Positions are exact at corners, within 4 ulps
    /// of the largest coordinate elsewhere, and on sides they are what f64 gives, rounded: the sums run from both ends
    /// towards the middle, so that patches which share a side get the same bits, in the same direction or reversed.
    /// For nets that [`fit`](Self::fits).
    pub fn fill(
        &self,
        net: &[[f64; 3]; 16],
        positions: &mut [[f32; 3]],
        normals: &mut [[f32; 3]],
    ) -> bool {
        let samples = (self.segments_u + 1) * (self.segments_v + 1);
        let (Some(positions), Some(normals)) =
            (positions.get_mut(..samples), normals.get_mut(..samples))
        else {
            return false;
        };
        positions::fill(self, net, positions);
        normals::fill(self, net, normals)
    }
}

impl Lanes {
    fn new(first: usize, segments: usize) -> Self {
        // Grids of less than four segments have fewer samples.
        let at: [usize; LANES] = std::array::from_fn(|lane| (first + lane).min(segments));
        Self {
            points: halves(at.map(|k| weights::cubic(k, segments))),
            facings: halves(at.map(|k| weights::quintic(k, segments))),
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

/// The nearest f32, 0 for −0: neighbours may come to a zero from different sides.
#[inline(always)]
#[allow(
    clippy::cast_possible_truncation,
    reason = "rounding to f32 is what meshes are made of"
)]
pub(crate) fn round(number: f64) -> f32 {
    number as f32 + 0.0
}

/// Stores four points in a line from `at` on, and four in reverse as far from its end.
#[inline(always)]
pub(crate) fn store(near: [f32x4; 3], far: [f32x4; 3], at: usize, line: &mut [[f32; 3]]) {
    if let Some(out) = line.get_mut(at..at + LANES) {
        store_four(points(near), out);
    }
    let end = line.len() - at;
    if let Some(out) = line.get_mut(end.wrapping_sub(LANES)..end) {
        let [a, b, c, d] = points(far);
        store_four([d, c, b, a], out);
    }
}

/// Stores the first three lanes of each. The fourth one of a whole store is overwritten by the next.
#[inline(always)]
fn store_four(points: [[f32; 4]; LANES], out: &mut [[f32; 3]]) {
    if let Ok(out) = <&mut [f32; 3 * LANES]>::try_from(out.as_flattened_mut()) {
        out[..4].copy_from_slice(&points[0]);
        out[3..7].copy_from_slice(&points[1]);
        out[6..10].copy_from_slice(&points[2]);
        out[9..].copy_from_slice(&points[3][..3]);
    }
}

/// Four points from their coordinates; the fourth lane means nothing.
#[inline(always)]
fn points([x, y, z]: [f32x4; 3]) -> [[f32; 4]; LANES] {
    f32x4::transpose([x, y, z, z]).map(f32x4::to_array)
}

/// Runs `fill` on the line, or on a longer one where it has no room for as many points as are stored together.
#[inline(always)]
pub(crate) fn with_room<R>(line: &mut [[f32; 3]], fill: impl Fn(&mut [[f32; 3]]) -> R) -> R {
    if line.len() > LANES {
        return fill(line);
    }
    // Those from the end on lie behind the few that are wanted.
    let mut room = [[0.0; 3]; 2 * LANES];
    let result = fill(&mut room);
    for (to, from) in line.iter_mut().zip(room) {
        *to = from;
    }
    result
}
