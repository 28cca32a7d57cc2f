//! De Casteljau's algorithm: repeated linear interpolation between neighbouring points.
//!
//! Start with the control points and replace each pair of neighbours by the point that divides their segment in the
//! ratio t : 1 − t. This gives one point fewer. Repeat until one point is left, which is the point of the curve at t.
//! The first points of all levels are the control points of the segment before t, the last ones those of the segment
//! after t. Source: de Casteljau, *Courbes et surfaces à pôles* (Citroën, 1963); Farin, *Curves and Surfaces for CAGD*,
//! §4.2.

use crate::geometry::error::MAX_DEGREE;
use crate::geometry::point::Point;

/// The point at t by de Casteljau's algorithm, for one to 65 control points.
pub(crate) fn evaluate_by_casteljau<P: Point>(points: &[P], t: f64) -> P {
    let mut row = [P::default(); MAX_DEGREE + 1];
    let count = points.len();
    row[..count].copy_from_slice(points);
    for last in (1..count).rev() {
        for i in 0..last {
            row[i] = row[i].lerp(row[i + 1], t);
        }
    }
    row[0]
}

/// Writes the control points of the segments before and after t; both slices are as long as `points`.
#[inline]
pub(crate) fn split_into<P: Point>(points: &[P], t: f64, left: &mut [P], right: &mut [P]) {
    right.copy_from_slice(points);
    for (level, first) in left.iter_mut().enumerate() {
        *first = right[0];
        for i in 1..points.len() - level {
            right[i - 1] = right[i - 1].lerp(right[i], t);
        }
    }
}

/// [`split_into`] for interleaved coordinates, `dimension` for each point; both slices hold the control points at
/// first.
#[cfg(feature = "wasm")]
pub(crate) fn split_numbers(left: &mut [f64], right: &mut [f64], dimension: usize, t: f64) {
    let s = 1.0 - t;
    let mut last = right.len();
    for first in left.chunks_exact_mut(dimension) {
        first.copy_from_slice(&right[..dimension]);
        last -= dimension;
        for i in 0..last {
            right[i] = right[i] * s + right[i + dimension] * t;
        }
    }
}

/// Replaces control points by those of the segment from t₀ to t₁.
///
/// The first cut keeps the longer of the ranges from t₀ to 1 and from 0 to t₁. So the parameter of the second cut stays
/// in [0, 1] if t₀ and t₁ do, and every step is a convex combination.
pub(crate) fn blossom_piece<P: Point>(points: &mut [P], t0: f64, t1: f64) {
    if 1.0 - t0 > t1 {
        keep_after(points, t0);
        let t = if t0 == 1.0 {
            1.0
        } else {
            (t1 - t0) / (1.0 - t0)
        };
        keep_before(points, t);
    } else {
        keep_before(points, t1);
        keep_after(points, if t1 == 0.0 { 0.0 } else { t0 / t1 });
    }
}

/// Keeps the segment before t, in place.
fn keep_before<P: Point>(points: &mut [P], t: f64) {
    for level in 1..points.len() {
        for i in (level..points.len()).rev() {
            points[i] = points[i - 1].lerp(points[i], t);
        }
    }
}

/// Keeps the segment after t, in place.
fn keep_after<P: Point>(points: &mut [P], t: f64) {
    for level in 1..points.len() {
        for i in 0..points.len() - level {
            points[i] = points[i].lerp(points[i + 1], t);
        }
    }
}
