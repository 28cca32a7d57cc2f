//! Evaluation of polynomials in Bernstein form.
//!
//! Degrees 1 to 3 sum the control points with explicit Bernstein weights. In [0, 1] the weights are positive and sum to
//! 1, so nothing cancels, and nothing overflows unless the result does. Higher degrees use de Casteljau's algorithm,
//! which agrees with the closed forms.

use crate::geometry::error::MAX_DEGREE;
use crate::numeric::list::Scalars;
use casteljau_kernels::bernstein::de_casteljau::{keep_after, lerp};
use casteljau_kernels::numeric::vector::Vector;

/// The point at t of the curve with the given control points (at least one).
#[inline]
pub(crate) fn evaluate<V: Vector>(points: &[V], t: f64) -> V {
    match *points {
        [p0, p1] => lerp(p0, p1, t),
        [p0, p1, p2] => weigh3([p0, p1, p2], t),
        [p0, p1, p2, p3] => weigh4([p0, p1, p2, p3], t),
        _ => evaluate_by_casteljau(points, t),
    }
}

/// The point at t by de Casteljau's algorithm, for one to 65 control points.
pub(crate) fn evaluate_by_casteljau<V: Vector>(points: &[V], t: f64) -> V {
    if let [p] = *points {
        return p;
    }
    let mut row = [V::default(); MAX_DEGREE + 1];
    let count = points.len();
    row[..count].copy_from_slice(points);
    keep_after(&mut row[..count], t);
    row[0]
}

#[inline(always)]
pub(crate) fn weigh3<V: Vector>(points: [V; 3], t: f64) -> V {
    let s = 1.0 - t;
    V::blend3(points, [s * s, 2.0 * s * t, t * t])
}

#[inline(always)]
pub(crate) fn weigh4<V: Vector>(points: [V; 4], t: f64) -> V {
    V::blend4(points, weights4(t))
}

#[inline(always)]
pub(crate) fn weights4(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    let (ss, tt) = (s * s, t * t);
    [ss * s, 3.0 * ss * t, 3.0 * s * tt, tt * t]
}

/// The value at t of the polynomial with the given Bernstein coefficients (at least one). The result has the same bits
/// as a coordinate of [`evaluate`].
pub(crate) fn evaluate_scalar(coefficients: &[f64], t: f64) -> f64 {
    let s = 1.0 - t;
    match *coefficients {
        [a, b] => a * s + b * t,
        [a, b, c] => a * (s * s) + b * (2.0 * s * t) + c * (t * t),
        [a, b, c, d] => weigh4([a, b, c, d], t),
        _ => {
            let mut row = Scalars::from(coefficients);
            keep_after(&mut row, t);
            row[0]
        }
    }
}
