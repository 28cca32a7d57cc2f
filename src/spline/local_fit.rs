//! Least-squares fits of simple models to pairs (point, parameter).

use crate::geometry::point::Point;

/// Two lines that meet at parameter 0: apex + before·min(x, 0) + after·max(x, 0).
pub(crate) struct TwoLines<P> {
    pub(crate) apex: P,
    pub(crate) before: P,
    pub(crate) after: P,
}

impl<P: Point> TwoLines<P> {
    /// Expects parameters below and above 0.
    pub(crate) fn fitted(samples: &[(P, f64)]) -> Self {
        let arm = |sign: f64| {
            let (mut sum, mut square, mut moment) = (0.0, 0.0, P::default());
            for &(p, x) in samples.iter().filter(|&&(_, x)| x * sign > 0.0) {
                sum += x;
                square += x * x;
                moment += p * x;
            }
            (sum, square, moment)
        };
        let ((s0, q0, m0), (s1, q1, m1)) = (arm(-1.0), arm(1.0));
        let total = samples.iter().fold(P::default(), |sum, &(p, _)| sum + p);
        // Normal equations: q₀ before = m₀ − s₀ apex, q₁ after = m₁ − s₁ apex, n apex + s₀ before + s₁ after = total.
        let weight = samples.len() as f64 - s0 * s0 / q0 - s1 * s1 / q1;
        let apex = (total - m0 * (s0 / q0) - m1 * (s1 / q1)) / weight;
        Self {
            apex,
            before: (m0 - apex * s0) / q0,
            after: (m1 - apex * s1) / q1,
        }
    }

    /// The sum of the squared distances.
    pub(crate) fn squares(&self, samples: &[(P, f64)]) -> f64 {
        let square = |&(p, x): &(P, f64)| {
            let off = p - self.apex - self.before * x.min(0.0) - self.after * x.max(0.0);
            off.dot(off)
        };
        samples.iter().map(square).sum()
    }
}

/// A polynomial of degree 2, in the orthogonal basis 1, y, y² − skew·y − spread with y = x − middle.
#[derive(Clone, Copy)]
pub(crate) struct Parabola<P> {
    middle: f64,
    skew: f64,
    spread: f64,
    coefficients: [P; 3],
    /// The sum of the squared distances of the samples.
    pub(crate) squares: f64,
}

impl<P: Point> Parabola<P> {
    /// A line for two samples, a point for one.
    pub(crate) fn fitted(samples: &[(P, f64)]) -> Self {
        let count = samples.len() as f64;
        let middle = samples.iter().map(|&(_, x)| x).sum::<f64>() / count;
        let (mut s2, mut s3, mut s4) = (0.0, 0.0, 0.0);
        let (mut mean, mut first) = (P::default(), P::default());
        let mut whole = 0.0;
        for &(p, x) in samples {
            let y = x - middle;
            (s2, s3, s4) = (s2 + y * y, s3 + y * y * y, s4 + y * y * y * y);
            mean += p;
            first += p * y;
            whole += p.dot(p);
        }
        let mean = mean / count;
        // What an orthogonal basis explains is subtracted from Σ p².
        let rest = whole - count * mean.dot(mean);
        if s2 == 0.0 {
            return Self {
                middle,
                skew: 0.0,
                spread: 0.0,
                coefficients: [mean, P::default(), P::default()],
                squares: rest.max(0.0),
            };
        }
        // With q = y² − skew y − spread, Σ y q = s₃ − skew s₂ = 0 and Σ q = s₂ − spread n = 0, because Σ y = 0.
        let (skew, spread) = (s3 / s2, s2 / count);
        // A second pass over the samples: the sum Σ q² = s₄ − skew s₃ − spread s₂ would cancel.
        let mut second = P::default();
        let mut norm = 0.0;
        for &(p, x) in samples {
            let y = x - middle;
            let q = y * y - skew * y - spread;
            second += p * q;
            norm += q * q;
        }
        let mut rest = rest - first.dot(first) / s2;
        let second = if norm > MIN_NORM * s4 {
            rest -= second.dot(second) / norm;
            second / norm
        } else {
            P::default()
        };
        Self {
            middle,
            skew,
            spread,
            coefficients: [mean, first / s2, second],
            squares: rest.max(0.0),
        }
    }

    pub(crate) fn value(&self, x: f64) -> P {
        let y = x - self.middle;
        let [a, b, c] = self.coefficients;
        a + b * y + c * (y * y - self.skew * y - self.spread)
    }

    pub(crate) fn derivative(&self, x: f64) -> P {
        let [_, b, c] = self.coefficients;
        b + c * (2.0 * (x - self.middle) - self.skew)
    }
}

/// Below this ratio to Σ y⁴, the values of the quadratic basis polynomial at all samples are rounding errors.
const MIN_NORM: f64 = 1e-9;
