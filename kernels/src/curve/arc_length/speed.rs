//! Arc length of a curve of any degree, in space, by one quadrature rule.

use crate::numeric::gauss::GAUSS_16;
use crate::numeric::lanes::f64x2;
use glam::DVec3;

/// ∫ |q(t)| dt from `lo` to `hi` by the 16-point Gauss–Legendre rule, for 0 ≤ lo ≤ hi ≤ 1.
///
/// q(t) = Σ cᵢ tⁱ (1 − t)ᵈ⁻ⁱ: `coefficients` are Bernstein coefficients, each multiplied by its binomial coefficient.
/// Every term equals its exact value up to rounding, so no accuracy is lost at high degrees.
pub fn speed_integral(coefficients: &[DVec3], lo: f64, hi: f64) -> f64 {
    integral(lo, hi, |t, s| size(coefficients, t, s))
}

/// ∫ |q(t)| / w(t)² dt: as [`speed_integral`], for a rational curve with the denominator w and the numerator q of its
/// derivative.
pub fn rational_speed_integral(numerator: &[DVec3], denominator: &[f64], lo: f64, hi: f64) -> f64 {
    integral(lo, hi, |t, s| {
        let (mut w, mut power) = (f64x2::splat(0.0), f64x2::splat(1.0));
        for &c in denominator.iter().rev() {
            w = w * t + power * f64x2::splat(c);
            power *= s;
        }
        size(numerator, t, s) / (w * w)
    })
}

/// The integral of a function of t and 1 − t by the 16-point rule.
#[inline(always)]
fn integral(lo: f64, hi: f64, f: impl Fn(f64x2, f64x2) -> f64x2) -> f64 {
    let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    // 1 − t is computed from the ends, so that it keeps its digits next to t = 1.
    let (t, s) = (
        f64x2::splat(middle),
        f64x2::splat(0.5 * ((1.0 - lo) + (1.0 - hi))),
    );
    let half_twice = f64x2::splat(half);
    let mut sum = f64x2::splat(0.0);
    let (nodes, weights) = (
        GAUSS_16.nodes.chunks_exact(2),
        GAUSS_16.weights.chunks_exact(2),
    );
    for (z, w) in nodes.zip(weights) {
        let off = half_twice * f64x2::new([z[0], z[1]]);
        let both = f(t - off, s + off) + f(t + off, s - off);
        sum += f64x2::new([w[0], w[1]]) * both;
    }
    let [a, b] = sum.to_array();
    half * (a + b)
}

/// |q| at two parameters t, where s is 1 − t.
#[inline(always)]
fn size(coefficients: &[DVec3], t: f64x2, s: f64x2) -> f64x2 {
    let zero = f64x2::splat(0.0);
    let (mut x, mut y, mut z, mut power) = (zero, zero, zero, f64x2::splat(1.0));
    // Horner's scheme in t, from the last coefficient down, with the powers of s computed alongside.
    for c in coefficients.iter().rev() {
        x = x * t + power * f64x2::splat(c.x);
        y = y * t + power * f64x2::splat(c.y);
        z = z * t + power * f64x2::splat(c.z);
        power *= s;
    }
    (x * x + y * y + z * z).sqrt()
}
