//! Values together with derivatives, by de Casteljau's algorithm.
//!
//! The k-th derivative is n(n − 1)…(n − k + 1) times the k-th difference of the level with k + 1 points.

use super::de_casteljau::lerp;
use crate::numeric::vector::Vector;

/// The value and the derivative of a cubic at t.
#[inline]
pub fn cubic_with_derivative<T: Vector>(points: &[T; 4], t: f64) -> (T, T) {
    let [p0, p1, p2, p3] = *points;
    let (p01, p12, p23) = (lerp(p0, p1, t), lerp(p1, p2, t), lerp(p2, p3, t));
    let (before, after) = (lerp(p01, p12, t), lerp(p12, p23, t));
    (lerp(before, after, t), (after - before) * 3.0)
}

/// The value and the first two derivatives at t, for any degree. `row` holds the control points, at least one, and is
/// overwritten.
#[inline]
pub fn with_derivatives<T: Vector>(row: &mut [T], t: f64) -> [T; 3] {
    let n = row.len() - 1;
    let degree = n as f64;
    let (mut first, mut second) = (T::default(), T::default());
    for last in (1..=n).rev() {
        if last == 2 {
            second = ((row[2] - row[1]) - (row[1] - row[0])) * (degree * (degree - 1.0));
        }
        if last == 1 {
            first = (row[1] - row[0]) * degree;
        }
        for i in 0..last {
            row[i] = lerp(row[i], row[i + 1], t);
        }
    }
    [row[0], first, second]
}
