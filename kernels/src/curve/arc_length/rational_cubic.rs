//! Arc length of rational conics and cubics by integration of the speed.

use crate::curve::rational_cubic::RationalCubic;
use crate::numeric::gauss::{GAUSS_8, GAUSS_16, GAUSS_24, GAUSS_32, GAUSS_48};
use crate::numeric::lanes::f64x2;
use crate::numeric::order::{larger, smaller};
use crate::numeric::work_limit::WorkLimit;
use glam::{DVec2, DVec3};

/// Where a rule of Gauss and Legendre is accurate enough on the interval [−1, 1]; see [`Piece::smallest_rule`].
struct Domain {
    /// T₁ … T₄ at half the major axis of an ellipse without a zero of |D|: the thresholds for polynomial cubics.
    speed: [f64; 4],
    /// The same for the larger ellipse in which 1/w² is bounded: (64/15) ρ⁻²ⁿ/(1 − ρ⁻²) ≤ 10⁻¹⁴, where ρ is the sum of its
    /// half axes and n the number of points.
    weight: [f64; 4],
}

/// The domains of the rules of 8, 16, 24, 32 and 48 points.
const DOMAINS: [Domain; 5] = [
    domain(2.45, 4.16),
    domain(1.29, 1.605),
    domain(1.12, 1.257),
    domain(1.0655, 1.141),
    domain(1.0275, 1.062),
];

/// |D|/w² is at most this multiple of a lower bound of its mean in the ellipse of a rule, whose error is then at most
/// 2.5·10⁻¹³ of the integral.
const MAX_GROWTH: f64 = 50.0;

/// A part of a curve that is shorter than this part of a lower bound of the whole length is negligible.
const NEGLIGIBLE: f64 = 1.0 / (1_u64 << 60) as f64;

/// Maximum number of halvings one after the other.
const MAX_HALVINGS: usize = 128;

/// Maximum number of intervals. After it, the remaining ones are accepted without a check.
const MAX_INTERVALS: usize = 1 << 12;

const fn domain(speed: f64, weight: f64) -> Domain {
    Domain {
        speed: chebyshev_polynomials(speed),
        weight: chebyshev_polynomials(weight),
    }
}

/// T₁ … T₄ at x.
const fn chebyshev_polynomials(x: f64) -> [f64; 4] {
    let second = 2.0 * x * x - 1.0;
    [
        x,
        second,
        (2.0 * second - 1.0) * x,
        2.0 * second * second - 1.0,
    ]
}

/// The arc length of a rational conic or cubic in the plane, with a relative error of some 10⁻¹³. `shortest` is a lower bound
/// of it, above 0.
///
/// The speed |D|/w² is analytic in the ellipses with the foci at both ends of an interval in which neither D·D nor w has a
/// zero, and so a rule of Gauss and Legendre is accurate there. Bounds of D and w in these ellipses follow from their Chebyshev
/// coefficients. An interval where no rule suffices is halved. Source of the error bounds: Trefethen, *Approximation Theory and
/// Approximation Practice*, ch. 19.
pub fn rational_length_in_plane(curve: &RationalCubic<DVec2>, shortest: f64) -> f64 {
    length(
        curve.derivative.map(|d| d.to_array()),
        curve.weights,
        shortest,
    )
}

/// [`rational_length_in_plane`] in space. (A public generic function would be compiled in the calling crate, for size.)
pub fn rational_length_in_space(curve: &RationalCubic<DVec3>, shortest: f64) -> f64 {
    length(
        curve.derivative.map(|d| d.to_array()),
        curve.weights,
        shortest,
    )
}

#[inline(always)]
fn length<const D: usize>(derivative: [[f64; D]; 5], weights: [f64; 4], shortest: f64) -> f64 {
    let whole = Piece {
        derivative,
        weights,
    };
    let mut work = WorkLimit::new(MAX_INTERVALS);
    whole.integral(NEGLIGIBLE * shortest, MAX_HALVINGS, &mut work)
}

/// A part of a curve: the Bernstein coefficients of D, by the part's own parameter from 0 to 1, and of w.
#[derive(Clone, Copy)]
struct Piece<const D: usize> {
    derivative: [[f64; D]; 5],
    weights: [f64; 4],
}

impl<const D: usize> Piece<D> {
    /// ∫ |D|/w² dt from 0 to 1.
    #[inline(never)]
    fn integral(&self, negligible: f64, halvings: usize, work: &mut WorkLimit) -> f64 {
        let powers = self.powers();
        let rule = self.smallest_rule(&powers);
        let is_accepted =
            |work: &mut WorkLimit| !work.spend(1) || halvings == 0 || self.longest() <= negligible;
        if rule < DOMAINS.len() || is_accepted(work) {
            return powers.by_rule(rule);
        }
        let (left, right) = self.halves();
        left.integral(negligible, halvings - 1, work)
            + right.integral(negligible, halvings - 1, work)
    }

    /// An upper bound of the length.
    #[inline(always)]
    fn longest(&self) -> f64 {
        let longest = self.derivative.iter().map(norm).fold(0.0, larger);
        let [a, b, c, d] = self.weights;
        let lightest = smaller(smaller(a, b), smaller(c, d));
        longest / (lightest * lightest)
    }

    #[inline(always)]
    fn halves(&self) -> (Self, Self) {
        let (mut left, mut right) = (*self, *self);
        for level in 0..5 {
            left.derivative[level] = right.derivative[0];
            for i in 1..5 - level {
                let [a, b] = [right.derivative[i - 1], right.derivative[i]];
                right.derivative[i - 1] = std::array::from_fn(|k| 0.5 * (a[k] + b[k]));
            }
        }
        for level in 0..4 {
            left.weights[level] = right.weights[0];
            for i in 1..4 - level {
                right.weights[i - 1] = 0.5 * (right.weights[i - 1] + right.weights[i]);
            }
        }
        // The parameter of a half is twice as fast.
        let slower = |d: [[f64; D]; 5]| d.map(|d| d.map(|x| 0.5 * x));
        left.derivative = slower(left.derivative);
        right.derivative = slower(right.derivative);
        (left, right)
    }

    /// The polynomials in the powers of z = 2t − 1.
    #[inline(always)]
    fn powers(&self) -> Powers<D> {
        let [a, b, c, d, e] = self.derivative;
        let mut derivative = [[0.0; D]; 5];
        for k in 0..D {
            let (outer, inner, middle) = (a[k] + e[k], b[k] + d[k], c[k]);
            let (outer_step, inner_step) = (e[k] - a[k], d[k] - b[k]);
            let powers = [
                (outer + 4.0 * inner + 6.0 * middle) * 0.0625,
                (outer_step + 2.0 * inner_step) * 0.25,
                (outer - 2.0 * middle) * 0.375,
                (outer_step - 2.0 * inner_step) * 0.25,
                (outer - 4.0 * inner + 6.0 * middle) * 0.0625,
            ];
            for (derivative, power) in derivative.iter_mut().zip(powers) {
                derivative[k] = power;
            }
        }
        let [a, b, c, d] = self.weights;
        let (outer, inner, outer_step, inner_step) = (a + d, b + c, d - a, c - b);
        Powers {
            derivative,
            weights: [
                (outer + 3.0 * inner) * 0.125,
                (outer_step + inner_step) * 0.375,
                (outer - inner) * 0.375,
                (outer_step - 3.0 * inner_step) * 0.125,
            ],
        }
    }

    /// The index of the smallest rule that is accurate enough, or that after the last one.
    ///
    /// Let cₖ be the Chebyshev coefficients of D, and z in an ellipse with half the major axis a, in which |Tₖ(z)| ≤ Tₖ(a). In the
    /// plane of c₀ and c₁ as complex numbers, c₀ + c₁z has one zero, and so |c₀ + c₁z| ≥ (|c₀ + c₁| + |c₀ − c₁|)/2 − a|c₁|. Where this is
    /// more than the sum of the other |cₖ|Tₖ(a), D has no zero: in the plane, where D·D is the product of two such functions. In
    /// space the other terms also count across that plane: at most √2 times as much.
    #[inline(always)]
    fn smallest_rule(&self, powers: &Powers<D>) -> usize {
        let [a, b, c, d, e] = powers.derivative;
        let constant = |k: usize| a[k] + 0.5 * c[k] + 0.375 * e[k];
        let linear = |k: usize| b[k] + 0.75 * d[k];
        let stretch = if D == 2 {
            1.0
        } else {
            std::f64::consts::SQRT_2
        };
        let sizes = [
            by::<D>(linear),
            stretch * by::<D>(|k| 0.5 * (c[k] + e[k])),
            stretch * by::<D>(|k| 0.25 * d[k]),
            stretch * by::<D>(|k| 0.125 * e[k]),
        ];
        let ends = by::<D>(|k| constant(k) + linear(k)) + by::<D>(|k| constant(k) - linear(k));
        // The mean of the speed is at least the length of the mean of D divided by the square of the largest weight.
        let mean = by::<D>(|k| a[k] + c[k] * (1.0 / 3.0) + e[k] * 0.2);
        let [t, u, v, w] = self.weights;
        let heaviest = larger(larger(t, u), larger(v, w));
        let [t, u, v, w] = powers.weights;
        let (weight, changes) = (
            t + 0.5 * v,
            [(u + 0.75 * w).abs(), 0.5 * v.abs(), 0.25 * w.abs(), 0.0],
        );
        let sum =
            |[a, b, c, d]: [f64; 4], [t, u, v, w]: [f64; 4]| (a * t + b * u) + (c * v + d * w);
        let is_enough = |domain: &Domain| {
            let least = weight - sum(changes, domain.weight);
            let largest = 0.5 * ends + sum(sizes, domain.speed);
            let ratio = heaviest / least;
            sum(sizes, domain.speed) < 0.5 * ends
                && least > 0.0
                && largest * (ratio * ratio) <= MAX_GROWTH * mean
        };
        DOMAINS.iter().position(is_enough).unwrap_or(DOMAINS.len())
    }
}

/// D and w in powers of z.
struct Powers<const D: usize> {
    derivative: [[f64; D]; 5],
    weights: [f64; 4],
}

impl<const D: usize> Powers<D> {
    /// Half the integral from −1 to 1 by the rule with an index; by the last one for larger indices.
    #[inline(always)]
    fn by_rule(&self, rule: usize) -> f64 {
        let (nodes, weights): (&[f64], &[f64]) = match rule {
            0 => (&GAUSS_8.nodes, &GAUSS_8.weights),
            1 => (&GAUSS_16.nodes, &GAUSS_16.weights),
            2 => (&GAUSS_24.nodes, &GAUSS_24.weights),
            3 => (&GAUSS_32.nodes, &GAUSS_32.weights),
            _ => (&GAUSS_48.nodes, &GAUSS_48.weights),
        };
        0.5 * self.sum(nodes, weights)
    }

    /// The value of a rule for the integral from −1 to 1: two nodes at a time, and their mirror images.
    #[inline(always)]
    fn sum(&self, nodes: &[f64], weights: &[f64]) -> f64 {
        // The coefficients of each coordinate.
        let d: [[f64x2; 5]; D] =
            std::array::from_fn(|k| self.derivative.map(|d| f64x2::splat(d[k])));
        let w = self.weights.map(f64x2::splat);
        let zero = f64x2::splat(0.0);
        let mut sum = zero;
        for (z, share) in nodes.chunks_exact(2).zip(weights.chunks_exact(2)) {
            let (z, share) = (f64x2::new([z[0], z[1]]), f64x2::new([share[0], share[1]]));
            let square = z * z;
            let (mut here, mut mirrored) = (zero, zero);
            for d in &d {
                // The value at z is the sum of the even and the odd part, that at −z their difference.
                let even = d[0] + (d[2] + d[4] * square) * square;
                let odd = (d[1] + d[3] * square) * z;
                let (x, y) = (even + odd, even - odd);
                here += x * x;
                mirrored += y * y;
            }
            let (even, odd) = (w[0] + w[2] * square, (w[1] + w[3] * square) * z);
            let (x, y) = (even + odd, even - odd);
            let (x, y) = (x * x, y * y);
            // Both quotients with one division.
            sum += share * ((here.sqrt() * y + mirrored.sqrt() * x) / (x * y));
        }
        let [a, b] = sum.to_array();
        a + b
    }
}

/// The length of the vector with the coordinates f(0), f(1), …
#[inline(always)]
fn by<const D: usize>(f: impl Fn(usize) -> f64) -> f64 {
    norm::<D>(&std::array::from_fn(f))
}

#[inline(always)]
fn norm<const D: usize>(vector: &[f64; D]) -> f64 {
    let mut sum = 0.0;
    for x in vector {
        sum += x * x;
    }
    sum.sqrt()
}
