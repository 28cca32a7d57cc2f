//! Numbers with double the precision of f64 (a sum of two f64), as a reference for f64 results.

use casteljau::glam::DVec3;
use std::ops::{Add, Mul, Sub};

/// hi + lo, about 106 bits. Source: Dekker, "A floating-point technique for extending the available precision", 1971.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Double {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

pub(crate) fn exactly(x: f64) -> Double {
    Double { hi: x, lo: 0.0 }
}

/// a + b without rounding error.
pub(crate) fn two_sum(a: f64, b: f64) -> Double {
    let hi = a + b;
    let part = hi - a;
    let lo = (a - (hi - part)) + (b - part);
    Double { hi, lo }
}

fn normalised(hi: f64, lo: f64) -> Double {
    let sum = hi + lo;
    let lo = lo - (sum - hi);
    Double { hi: sum, lo }
}

impl Add for Double {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (two_sum(self.hi, other.hi), two_sum(self.lo, other.lo));
        let first = normalised(high.hi, high.lo + low.hi);
        normalised(first.hi, first.lo + low.lo)
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let negative = Self {
            hi: -other.hi,
            lo: -other.lo,
        };
        self + negative
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let hi = self.hi * other.hi;
        let lo = self.hi.mul_add(other.hi, -hi) + (self.hi * other.lo + self.lo * other.hi);
        normalised(hi, lo)
    }
}

/// The sum of numbers, accurate to about one ulp of the sum.
pub(crate) fn sum(numbers: &[f64]) -> f64 {
    let total = numbers
        .iter()
        .fold(exactly(0.0), |total, &x| total + exactly(x));
    total.hi + total.lo
}

/// The value of one coordinate at t, by de Casteljau's algorithm in double the precision of f64.
pub(crate) fn eval_scalar(coefficients: &[f64], t: f64) -> Double {
    eval_row(coefficients.iter().map(|&c| exactly(c)).collect(), t)
}

fn eval_row(mut row: Vec<Double>, t: f64) -> Double {
    let s = two_sum(1.0, -t);
    while row.len() > 1 {
        let step = |pair: &[Double]| pair[0] * s + pair[1] * exactly(t);
        row = row.windows(2).map(step).collect();
    }
    row[0]
}

/// The point at t, correctly rounded (nearly always).
pub(crate) fn eval(points: &[DVec3], t: f64) -> DVec3 {
    derivative(points, t, 0)
}

/// The k-th derivative at t, correctly rounded (nearly always), for moderate coordinates.
pub(crate) fn derivative(points: &[DVec3], t: f64, order: usize) -> DVec3 {
    let axis = |k: usize| {
        let mut row: Vec<Double> = points.iter().map(|p| exactly(p[k])).collect();
        for _ in 0..order.min(points.len()) {
            let factor = exactly(super::real(row.len() - 1));
            let step = |pair: &[Double]| (pair[1] - pair[0]) * factor;
            row = row.windows(2).map(step).collect();
        }
        if row.is_empty() {
            0.0
        } else {
            eval_row(row, t).hi
        }
    };
    DVec3::new(axis(0), axis(1), axis(2))
}
