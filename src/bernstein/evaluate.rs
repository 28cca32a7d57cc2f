//! Evaluation of polynomials in Bernstein form.
//!
//! Degrees 1 to 3 sum the control points with explicit Bernstein weights. In [0, 1] the weights are positive and sum to
//! 1, so nothing cancels, and nothing overflows unless the result does. Higher degrees use de Casteljau's algorithm,
//! which agrees with the closed forms.

use super::de_casteljau::keep_after;
use crate::geometry::error::MAX_DEGREE;
use crate::geometry::point::Point;
use crate::numeric::list::Scalars;

/// The point at t of the curve with the given control points (at least one).
#[inline]
pub(crate) fn evaluate<P: Point>(points: &[P], t: f64) -> P {
    match *points {
        [p0, p1] => p0.lerp(p1, t),
        [p0, p1, p2] => weigh3([p0, p1, p2], t),
        [p0, p1, p2, p3] => weigh4([p0, p1, p2, p3], t),
        _ => evaluate_by_casteljau(points, t),
    }
}

/// The point at t by de Casteljau's algorithm, for one to 65 control points.
pub(crate) fn evaluate_by_casteljau<P: Point>(points: &[P], t: f64) -> P {
    if let [p] = *points {
        return p;
    }
    let mut row = [P::default(); MAX_DEGREE + 1];
    let count = points.len();
    row[..count].copy_from_slice(points);
    keep_after(&mut row[..count], t);
    row[0]
}

#[inline(always)]
pub(crate) fn weigh3<P: Point>(points: [P; 3], t: f64) -> P {
    let s = 1.0 - t;
    P::blend3(points, [s * s, 2.0 * s * t, t * t])
}

#[inline(always)]
pub(crate) fn weigh4<P: Point>(points: [P; 4], t: f64) -> P {
    P::blend4(points, weights4(t))
}

#[inline(always)]
pub(crate) fn weights4(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    let (ss, tt) = (s * s, t * t);
    [ss * s, 3.0 * ss * t, 3.0 * s * tt, tt * t]
}

/// One coordinate of a cubic at t.
#[inline(always)]
pub(crate) fn cubic_scalar([a, b, c, d]: [f64; 4], t: f64) -> f64 {
    let [u, v, w, s] = weights4(t);
    a * u + b * v + c * w + d * s
}

/// The value at t of the polynomial with the given Bernstein coefficients (at least one). The result has the same bits
/// as a coordinate of [`evaluate`].
pub(crate) fn evaluate_scalar(coefficients: &[f64], t: f64) -> f64 {
    let s = 1.0 - t;
    match *coefficients {
        [a, b] => a * s + b * t,
        [a, b, c] => a * (s * s) + b * (2.0 * s * t) + c * (t * t),
        [a, b, c, d] => cubic_scalar([a, b, c, d], t),
        _ => {
            let mut row = Scalars::from(coefficients);
            keep_after(&mut row, t);
            row[0]
        }
    }
}
