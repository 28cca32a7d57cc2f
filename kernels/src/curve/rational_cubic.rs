//! Rational cubics in homogeneous form.

use crate::bernstein::de_casteljau::{split_cubic_with, split_with};
use crate::numeric::vector::Euclidean;

/// A rational curve A/w of degree 2 or 3, with D = wA′ − w′A.
///
/// All are polynomials in Bernstein form. A conic has the coefficients of the same polynomials in the higher degrees. Only
/// differences of points enter D. Source: Saito, Wang and Sederberg, "Hodographs and normals of rational curves and
/// surfaces", CAGD 12 (1995).
#[derive(Clone, Copy)]
pub struct RationalCubic<V> {
    /// A.
    pub points: [V; 4],
    /// w.
    pub weights: [f64; 4],
    /// D.
    pub derivative: [V; 5],
}

impl<V: Euclidean> RationalCubic<V> {
    /// The curve of degree 2 or 3 with these control points and weights; `None` for another degree.
    #[inline(always)]
    pub fn new(points: &[V], weights: &[f64]) -> Option<Self> {
        match (points, weights) {
            (&[a, b, c, d], &[t, u, v, w]) => Some(Self {
                points: [a * t, b * u, c * v, d * w],
                weights: [t, u, v, w],
                derivative: [
                    (b - a) * (3.0 * t * u),
                    (c - a) * (1.5 * t * v),
                    (d - a) * (0.5 * t * w) + (c - b) * (1.5 * u * v),
                    (d - b) * (1.5 * u * w),
                    (d - c) * (3.0 * v * w),
                ],
            }),
            (&[a, b, c], &[t, u, v]) => {
                let ends = [(b - a) * (2.0 * t * u), (c - b) * (2.0 * u * v)];
                let middle = (c - a) * (t * v);
                let (third, two) = (1.0 / 3.0, 2.0 / 3.0);
                let (p, q, r) = (a * t, b * u, c * v);
                Some(Self {
                    points: [p, p * third + q * two, q * two + r * third, r],
                    weights: [t, t * third + u * two, u * two + v * third, v],
                    derivative: [
                        ends[0],
                        (ends[0] + middle) * 0.5,
                        (ends[0] + middle * 4.0 + ends[1]) * (1.0 / 6.0),
                        (middle + ends[1]) * 0.5,
                        ends[1],
                    ],
                })
            }
            _ => None,
        }
    }

    /// Both halves.
    #[inline(never)]
    pub(crate) fn halves(&self) -> (Self, Self) {
        let (left, right) = split_cubic_with(self.points, |a, b| (a + b) * 0.5);
        let (lighter, heavier) = split_cubic_with(self.weights, |a, b| (a + b) * 0.5);
        let (mut before, mut after) = (self.derivative, self.derivative);
        split_with(&mut before, &mut after, |a, b| (a + b) * 0.5);
        // The parameter of a half is twice as fast.
        let half = |points, weights, derivative: [V; 5]| Self {
            points,
            weights,
            derivative: derivative.map(|d| d * 0.5),
        };
        (half(left, lighter, before), half(right, heavier, after))
    }

    /// The part from lo to hi, which halvings give.
    pub(crate) fn part(&self, lo: f64, hi: f64) -> Self {
        let (mut part, mut start, mut length) = (*self, 0.0, 1.0);
        while length > hi - lo {
            length *= 0.5;
            let (left, right) = part.halves();
            if start + length <= lo {
                (part, start) = (right, start + length);
            } else {
                part = left;
            }
        }
        part
    }
}
