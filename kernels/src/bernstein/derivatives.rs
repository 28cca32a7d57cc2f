//! Values together with derivatives.
//!
//! By de Casteljau's algorithm, the k-th derivative is n(n − 1)…(n − k + 1) times the k-th difference of the level with
//! k + 1 points.

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

/// A cubic with the control points of its derivatives, which are computed once for many parameters.
#[derive(Clone, Copy)]
pub struct CubicWithDerivatives<T> {
    /// The control points.
    pub points: [T; 4],
    /// Those of the derivative.
    pub first: [T; 3],
    second: [T; 2],
}

impl<T: Vector> CubicWithDerivatives<T> {
    /// The cubic with these control points.
    #[inline(always)]
    pub fn new(points: [T; 4]) -> Self {
        let [p0, p1, p2, p3] = points;
        let first = [(p1 - p0) * 3.0, (p2 - p1) * 3.0, (p3 - p2) * 3.0];
        let second = [(first[1] - first[0]) * 2.0, (first[2] - first[1]) * 2.0];
        Self {
            points,
            first,
            second,
        }
    }

    /// The value and the first two derivatives at t, by Bernstein weights.
    #[inline(always)]
    pub fn at(&self, t: f64) -> [T; 3] {
        let ([p, q, r, s], [v, w, x], [y, z]) = (self.points, self.first, self.second);
        let u = 1.0 - t;
        let (uu, ut, tt) = (u * u, 2.0 * (u * t), t * t);
        let (a, b, c, d) = (uu * u, 3.0 * (uu * t), 3.0 * (u * tt), tt * t);
        [
            (p * a + q * b) + (r * c + s * d),
            v * uu + w * ut + x * tt,
            y * u + z * t,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::{CubicWithDerivatives, cubic_with_derivative, with_derivatives};

    /// tⁿ has the coefficients 0, …, 0, 1.
    #[test]
    fn powers_of_t() {
        for n in 0..=9_i32 {
            for t in [0.0, 0.3, 1.0, 1.5] {
                let mut row: Vec<f64> = (0..=n).map(|i| f64::from(u8::from(i == n))).collect();
                let found = with_derivatives(&mut row, t);
                let degree = f64::from(n);
                let power = |k: i32| if n < k { 0.0 } else { t.powi(n - k) };
                let expected = [
                    power(0),
                    degree * power(1),
                    degree * (degree - 1.0) * power(2),
                ];
                for (a, b) in found.iter().zip(expected) {
                    assert!((a - b).abs() <= 1e-13 * b.abs(), "t^{n} at {t}: {found:?}");
                }
            }
        }
    }

    #[test]
    fn cubics() {
        let points = [1.0, -2.0, 4.0, 0.5];
        for t in [0.0, 0.3, 1.0, -0.5] {
            let general = with_derivatives(&mut points.clone(), t);
            let weighted = CubicWithDerivatives::new(points).at(t);
            let apart = general.iter().zip(weighted).map(|(a, b)| (a - b).abs());
            assert!(
                apart.fold(0.0, f64::max) < 1e-13,
                "{general:?} {weighted:?}"
            );
            assert_eq!(cubic_with_derivative(&points, t), (general[0], general[1]));
        }
    }
}
