//! De Casteljau's algorithm: repeated linear interpolation between neighbouring points.
//!
//! Start with the control points and replace each pair of neighbours by the point that divides their segment in the
//! ratio t : 1 − t. This gives one point fewer. Repeat until one point is left, which is the point of the curve at t.
//! The first points of all levels are the control points of the segment before t, the last ones those of the segment
//! after t. Source: de Casteljau, *Courbes et surfaces à pôles* (Citroën, 1963); Farin, *Curves and Surfaces for CAGD*,
//! §4.2.
//!
//! The control points are numbers, points, groups of lanes, or points with weights. The halves at ½ are sums times ½, with one
//! multiplication instead of two.

use crate::numeric::vector::Interpolate;

/// The value at t between two others; (1 − t)·a + t·b for numbers and points.
#[inline(always)]
pub fn lerp<T: Interpolate>(a: T, b: T, t: f64) -> T {
    a.interpolate(b, t)
}

/// Computes some levels of the triangle in place: `points` then begins with the points of the last one.
#[inline(always)]
pub fn levels<T: Interpolate>(points: &mut [T], count: usize, t: f64) {
    for level in 1..=count {
        for i in 0..points.len() - level {
            points[i] = lerp(points[i], points[i + 1], t);
        }
    }
}

/// Keeps the control points of the segment after t.
#[inline(always)]
pub fn keep_after<T: Interpolate>(points: &mut [T], t: f64) {
    levels(points, points.len().saturating_sub(1), t);
}

/// Keeps the control points of the segment before t.
#[inline(always)]
pub fn keep_before<T: Interpolate>(points: &mut [T], t: f64) {
    for level in 1..points.len() {
        for i in (level..points.len()).rev() {
            points[i] = lerp(points[i - 1], points[i], t);
        }
    }
}

/// Keeps the control points of the segment from t₀ to t₁.
///
/// The first cut keeps the longer of the ranges from t₀ to 1 and from 0 to t₁. So the parameter of the second cut stays
/// in [0, 1] if t₀ and t₁ do, and every step is a convex combination.
pub fn keep_between<T: Interpolate>(points: &mut [T], t0: f64, t1: f64) {
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

/// Splits a curve at t. Both slices hold all control points at first, and those of the segments before and after t
/// afterwards.
#[inline(always)]
pub fn split<T: Interpolate>(left: &mut [T], right: &mut [T], t: f64) {
    split_with(left, right, |a, b| lerp(a, b, t));
}

/// [`split`] at ½ for numbers.
#[inline(always)]
pub fn halve(left: &mut [f64], right: &mut [f64]) {
    split_with(left, right, |a, b| 0.5 * (a + b));
}

/// Splits a net of numbers at ½, along u (the fast index) or along v. `left` holds the net; `right` has the same length.
pub fn halve_net(left: &mut [f64], right: &mut [f64], columns: usize, along_u: bool) {
    right.copy_from_slice(left);
    split_net_with(left, right, columns, along_u, |a, b| 0.5 * (a + b));
}

/// [`split`] with another interpolation between neighbours. For arrays, whose length is known at compile time, the
/// loops are unrolled.
#[inline(always)]
pub fn split_with<T: Copy>(left: &mut [T], right: &mut [T], between: impl Fn(T, T) -> T) {
    for (level, first) in left.iter_mut().enumerate() {
        *first = right[0];
        for i in 1..right.len() - level {
            right[i - 1] = between(right[i - 1], right[i]);
        }
    }
}

/// [`split_with`] for a cubic, written out for builds that do not unroll loops.
#[inline(always)]
pub fn split_cubic_with<T: Copy>(
    [p0, p1, p2, p3]: [T; 4],
    between: impl Fn(T, T) -> T,
) -> ([T; 4], [T; 4]) {
    let (p01, p12, p23) = (between(p0, p1), between(p1, p2), between(p2, p3));
    let (p012, p123) = (between(p01, p12), between(p12, p23));
    let p = between(p012, p123);
    ([p0, p01, p012, p], [p, p123, p23, p3])
}

/// [`split_with`] for a net of control points, along u (the fast index) or along v.
#[inline(always)]
pub fn split_net_with<T: Copy>(
    left: &mut [T],
    right: &mut [T],
    columns: usize,
    along_u: bool,
    between: impl Fn(T, T) -> T,
) {
    if along_u {
        let rows = left.chunks_exact_mut(columns);
        for (left, right) in rows.zip(right.chunks_exact_mut(columns)) {
            split_with(left, right, &between);
        }
    } else {
        split_rows_with(left, right, columns, between);
    }
}

/// [`split_with`] for control points that are rows of `width` numbers each.
#[inline(always)]
fn split_rows_with<T: Copy>(
    left: &mut [T],
    right: &mut [T],
    width: usize,
    between: impl Fn(T, T) -> T,
) {
    let mut end = right.len();
    for first in left.chunks_exact_mut(width) {
        first.copy_from_slice(&right[..width]);
        end -= width;
        for i in 0..end {
            right[i] = between(right[i], right[i + width]);
        }
    }
}
