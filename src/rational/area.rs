//! Signed area swept by a plane curve.

use super::RationalCurve;
use crate::bernstein::evaluate::evaluate_scalar;
use crate::bernstein::wronskian::Wronskian;
use crate::curve::area::triangle_area;
use crate::geometry::normalized::Normalized;
use crate::numeric::list::{Points, Scalars};
use casteljau_kernels::numeric::gauss::GAUSS_16;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec2;

/// Two levels of rules agree up to this part of the squared size: some roundings of a sum of 32 terms.
const AGREEMENT: f64 = 16.0 * f64::EPSILON;

/// The maximum number of intervals; curves with moderate weights need some tens.
const MAX_INTERVALS: usize = 1 << 12;

/// Halvings after which an interval is a point up to rounding.
const INTERVAL_HALVINGS: u32 = f64::MANTISSA_DIGITS;

impl RationalCurve<DVec2> {
    /// The signed area ½ ∫ (x dy − y dx) that the segment from the origin to B(t) sweeps.
    ///
    /// Counter-clockwise sweeps (x right, y up) count as positive. The areas of consecutive curves add up; over a closed
    /// outline their sum is the enclosed area. The integral has no closed form: Gauss–Legendre rules on intervals that are
    /// halved until two levels agree. The error is about 10⁻¹⁴ of the square of the size for weights whose ratios are at most
    /// 2²⁰; at most 4096 intervals are integrated.
    pub fn area(&self) -> f64 {
        let normalized = Normalized::around(self.start(), &self.points);
        let points: Points<DVec2> = normalized.points(&self.points);
        let weights = self.scaled_weights();
        // With the origin at the start and A = wB: B×B′ = A×A′/w².
        let numerator = Wronskian::of_degree(self.degree())
            .coefficients(|i, j| weights[i] * weights[j] * points[i].perp_dot(points[j]));
        let mut integral = Integral {
            numerator,
            weights,
            work: WorkLimit::new(MAX_INTERVALS),
        };
        let whole = integral.rule(0.0, 1.0);
        let area = 0.5 * integral.refined([0.0, 1.0], whole, INTERVAL_HALVINGS);
        area / normalized.scale / normalized.scale + triangle_area(self.start(), self.end())
    }
}

/// The integral of a numerator divided by w².
struct Integral {
    numerator: Scalars,
    weights: Scalars,
    work: WorkLimit,
}

impl Integral {
    /// The sum of both halves, each halved again until they agree with the whole.
    fn refined(&mut self, [lo, hi]: [f64; 2], whole: f64, halvings: u32) -> f64 {
        let mid = 0.5 * (lo + hi);
        let (left, right) = (self.rule(lo, mid), self.rule(mid, hi));
        let both = left + right;
        let agrees = (both - whole).abs() <= AGREEMENT;
        if !self.work.spend(1) || agrees || halvings == 0 {
            return both;
        }
        self.refined([lo, mid], left, halvings - 1) + self.refined([mid, hi], right, halvings - 1)
    }

    fn rule(&self, lo: f64, hi: f64) -> f64 {
        let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let at = |t: f64| {
            let w = evaluate_scalar(&self.weights, t);
            evaluate_scalar(&self.numerator, t) / (w * w)
        };
        let pairs = GAUSS_16.nodes.iter().zip(&GAUSS_16.weights);
        let sum: f64 = pairs
            .map(|(z, w)| w * (at(middle - half * z) + at(middle + half * z)))
            .sum();
        sum * half
    }
}
