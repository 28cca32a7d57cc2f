//! Bounds for one piece: the higher derivatives of the source, and the effect of rounding on the offset.

use super::source::MAX_POINTS;
use super::source::{OffsetSample, Source};
use super::{End, OffsetCurve, VANISHING_SPEED};
use crate::bernstein::de_casteljau::{keep_after, keep_between};
use glam::DVec2;

/// Rounding error of B′, as a part of the sum of its terms' lengths.
const SLOPE_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// For degrees above 3, bounds are tightened on pieces up to this length; longer ones use the bounds of the whole
/// curve.
const SHORT_PIECE: f64 = 0.125;

impl OffsetCurve<'_> {
    /// The offset curve with the bounds for one piece.
    ///
    /// The tolerance stays the same where rounding changes the direction of a small B′: the normal then rotates about a
    /// point, so rounding moves a point of the offset along the offset curve and not away from it.
    pub(super) fn on_piece(&self, from: &End, to: &End) -> Self {
        let mut local = Self {
            source: self.source,
            ..*self
        };
        let (t0, t1) = (from.sample.t, to.sample.t);
        if self.source.degree() > 3 && t1 - t0 <= SHORT_PIECE {
            local.third = self.source.derivative_bound(3, t0, t1).min(self.third);
            local.fourth = self.source.derivative_bound(4, t0, t1).min(self.fourth);
        }
        local
    }

    /// The distance by which rounding of B′ moves the point of the offset.
    pub(super) fn noise(&self, at: &OffsetSample) -> f64 {
        let terms = self.source.slope_terms(at.t);
        self.distance.abs() * SLOPE_ROUNDING * terms / at.first.length()
    }
}

impl Source {
    /// Whether B′ is zero up to rounding.
    pub(super) fn is_still(&self, at: &OffsetSample) -> bool {
        at.first.length() <= VANISHING_SPEED * self.slope_terms(at.t)
    }

    /// n Σ Bᵢ(t) |Pᵢ₊₁ − Pᵢ|: the sum of the lengths of the terms of B′.
    fn slope_terms(&self, t: f64) -> f64 {
        let s = 1.0 - t;
        if self.degree() <= 3 {
            let [a, b, c] = self.first_vectors().map(DVec2::length);
            // The quadratic with the coefficients a, b and c; they contain the factor n.
            return (a * s + b * t) * s + (b * s + c * t) * t;
        }
        let n = self.degree();
        let mut row = [0.0; MAX_POINTS];
        for (length, v) in row.iter_mut().zip(self.differences()) {
            *length = v.length();
        }
        keep_after(&mut row[..n], t);
        row[0] * n as f64
    }

    /// Whether all control vectors of the derivative between two parameters have a property.
    pub(super) fn slopes_between(&self, t0: f64, t1: f64, holds: impl Fn(DVec2) -> bool) -> bool {
        if self.degree() <= 3 {
            let (from, to) = (self.at(t0), self.at(t1));
            // The middle control vector of B′, a quadratic, between both parameters.
            let middle = from.first + from.second * (0.5 * (t1 - t0));
            return holds(from.first) && holds(middle) && holds(to.first);
        }
        let n = self.degree();
        let mut row = [DVec2::default(); MAX_POINTS];
        row[..n].copy_from_slice(self.differences());
        keep_between(&mut row[..n], t0, t1);
        row[..n].iter().all(|&v| holds(v))
    }

    /// A bound on the length of the k-th derivative between two parameters, for degrees above 3.
    pub(super) fn derivative_bound(&self, k: usize, t0: f64, t1: f64) -> f64 {
        let mut row = [DVec2::default(); MAX_POINTS];
        let mut count = self.degree();
        row[..count].copy_from_slice(self.differences());
        // The control vectors of the k-th derivative are n(n − 1)…(n − k + 1) times the k-th differences.
        let mut factor = count as f64;
        for _ in 1..k {
            factor *= (count - 1) as f64;
            for i in 0..count - 1 {
                row[i] = row[i + 1] - row[i];
            }
            count -= 1;
        }
        keep_between(&mut row[..count], t0, t1);
        let max = row[..count]
            .iter()
            .fold(0.0, |m: f64, v| m.max(v.length_squared()));
        factor * max.sqrt()
    }
}
