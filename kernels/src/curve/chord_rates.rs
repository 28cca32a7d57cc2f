//! Rates of chords along a cubic, for flattening.

use crate::numeric::lanes::{f32x4, if_greater};

/// The number of equal parts of the cubic.
pub const PARTS: usize = 8;

/// The ends of the parts.
const STARTS: [f32; PARTS] = [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875];
const LENGTH: f32 = 0.125;

/// More than the rounding of a control vector, as a part of the largest coefficient.
const ROUNDING: f32 = 1.0 / (1 << 20) as f32;

/// The rounding e of a vector product of size s: (s + e)² ≤ (1 + 2⁻¹⁰) s² + (1 + 2¹⁰) e².
const STRETCH: f32 = 1.0 + 1.0 / (1 << 10) as f32;
const SQUARED_ROUNDING: f32 = 2.0 / (1_u32 << 30) as f32;

/// The number of chords for each unit of t, in each part of a cubic.
#[derive(Clone, Copy, Debug)]
pub struct ChordRates {
    /// Enough for the tolerance in chords of equal steps.
    pub enough: [f32; PARTS],
    /// Estimates of the smallest numbers that are possible, in the middle of each part.
    pub minimum: [f32; PARTS],
}

/// The rates along the plane curve with the Taylor coefficients D₁, D₂, D₃ at t = 0, for a tolerance τ; `per_tolerance`
/// is 1 / (8 τ).
///
/// Let V be the control vectors of B′ in a part, G those of B″, h a step and c the chord divided by h, an average of B′.
/// The distance of the curve from the chord is at most h²/8 · max |G|, and across the chord at most h²/8 · max |G × V| /
/// |c|. If any two V are at most 90° apart, the curve does not pass the ends of the chord, and |c| is at least the least
/// projection of a V on the direction of V₀ + V₂. Because of G₀ = 2(V₁ − V₀) and G₁ = 2(V₂ − V₁), four of the products
/// G × V are enough.
///
/// The numbers are f32, so that four parts are computed at a time; their rounding is added to the bounds.
pub fn rates_in_plane(coefficients: &[[f64; 2]; 3], per_tolerance: f64) -> ChordRates {
    rates(coefficients, per_tolerance)
}

/// [`rates_in_plane`] in space. (A public generic function would be compiled in the calling crate, for size.)
pub fn rates_in_space(coefficients: &[[f64; 3]; 3], per_tolerance: f64) -> ChordRates {
    rates(coefficients, per_tolerance)
}

type Vectors<const D: usize> = [f32x4; D];

#[inline(always)]
#[allow(
    clippy::cast_possible_truncation,
    reason = "the rounding is added to the bounds"
)]
fn rates<const D: usize>(coefficients: &[[f64; D]; 3], per_tolerance: f64) -> ChordRates {
    let largest = |m: f64, x: &f64| m.max(x.abs());
    let size = coefficients
        .as_flattened()
        .iter()
        .fold(f64::MIN_POSITIVE, largest);
    let one = 1.0 / size;
    let lanes = |k: usize, factor: f64| -> Vectors<D> {
        std::array::from_fn(|i| f32x4::splat((coefficients[k][i] * (one * factor)) as f32))
    };
    let (first, second, third) = (lanes(0, 1.0), lanes(1, 2.0), lanes(2, 3.0));
    let factor = f32x4::splat((size * per_tolerance) as f32);
    let mut rates = ChordRates {
        enough: [0.0; PARTS],
        minimum: [0.0; PARTS],
    };
    let fours = (STARTS.as_chunks().0.iter())
        .zip(rates.enough.as_chunks_mut().0)
        .zip(rates.minimum.as_chunks_mut().0);
    for ((starts, enough), minimum) in fours {
        let t = f32x4::new(*starts);
        let half_of_one = f32x4::splat(0.5);
        let (half, twice) = (f32x4::splat(0.5 * LENGTH), f32x4::splat(2.0));
        let g0: Vectors<D> = std::array::from_fn(|i| second[i] + third[i] * (twice * t));
        let g1: Vectors<D> = std::array::from_fn(|i| g0[i] + third[i] * f32x4::splat(2.0 * LENGTH));
        let v0: Vectors<D> = std::array::from_fn(|i| first[i] + (second[i] + third[i] * t) * t);
        let v1: Vectors<D> = std::array::from_fn(|i| v0[i] + g0[i] * half);
        let v2: Vectors<D> = std::array::from_fn(|i| v1[i] + g1[i] * half);
        let bend = dot(&g0, &g0).fast_max(dot(&g1, &g1));
        let turn = cross_squared(&g0, &v0).fast_max(cross_squared(&g1, &v2));
        let turn = turn.fast_max(cross_squared(&g0, &v2).fast_max(cross_squared(&g1, &v0)));
        let d: Vectors<D> = std::array::from_fn(|i| v0[i] + v2[i]);
        let square = dot(&d, &d);
        let apart = dot(&v0, &v1)
            .fast_min(dot(&v1, &v2))
            .fast_min(dot(&v0, &v2));
        let ahead = dot(&v0, &d).fast_min(dot(&v1, &d)).fast_min(dot(&v2, &d));
        // |d| ≤ (1 + d²)/2 times the rounding of a vector.
        let ahead = ahead - (square + f32x4::splat(1.0)) * f32x4::splat(ROUNDING);
        let rounding = bend * f32x4::splat(SQUARED_ROUNDING);
        let across = turn * square / (ahead * ahead) + rounding;
        let bound = if_greater(
            apart.fast_min(ahead),
            f32x4::ZERO,
            across.fast_min(bend),
            bend,
        ) * f32x4::splat(STRETCH);
        let twice_g: Vectors<D> = std::array::from_fn(|i| g0[i] + g1[i]);
        let twice_v: Vectors<D> = std::array::from_fn(|i| v1[i] + d[i] * half_of_one);
        let square = dot(&twice_v, &twice_v) + f32x4::splat(f32::MIN_POSITIVE);
        let lower = cross_squared(&twice_g, &twice_v) / (square * f32x4::splat(4.0));
        let rate = |squared: f32x4| (squared.sqrt() * factor).sqrt().to_array();
        *enough = rate(bound);
        *minimum = rate(lower);
    }
    rates
}

#[inline(always)]
fn dot<const D: usize>(a: &Vectors<D>, b: &Vectors<D>) -> f32x4 {
    let mut sum = a[0] * b[0];
    for k in 1..D {
        sum += a[k] * b[k];
    }
    sum
}

/// The square of the length of a × b.
#[inline(always)]
fn cross_squared<const D: usize>(a: &Vectors<D>, b: &Vectors<D>) -> f32x4 {
    let mut sum = f32x4::ZERO;
    for i in 0..D {
        for j in 0..i {
            let part = a[i] * b[j] - a[j] * b[i];
            sum += part * part;
        }
    }
    sum
}
