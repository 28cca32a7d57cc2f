//! The weights of the control points of a segment, or none for a polynomial curve.
//!
//! The coordinates of a rational segment are those of its control points Pᵢ, not multiplied by the weights wᵢ. The weights
//! are positive, so the segment lies in the hull of the Pᵢ, and its direction is a sum of the vectors Pᵢ₊₁ − Pᵢ with
//! positive factors: what the search concludes from points and edges holds for rational curves, too.

use super::constants::SPLIT;
use super::piece::{Coefficients, Piece, value_and_slope};
use crate::bernstein::de_casteljau::{keep_after, keep_before, lerp, split};
use crate::bernstein::weights::binomial;

/// What depends on the weights of a segment.
pub trait Weights<C>: Clone {
    /// Weight i.
    fn weight(&self, i: usize) -> f64;

    /// Keeps the control points of the segment after s.
    fn keep_after(piece: &mut Piece<C, Self>, s: f64);

    /// Keeps the control points of the segment before s.
    fn keep_before(piece: &mut Piece<C, Self>, s: f64);

    /// Splits a segment at s. Both pieces hold all control points at first, and those before and after s afterwards.
    fn split(left: &mut Piece<C, Self>, right: &mut Piece<C, Self>, s: f64);

    /// Reverses the order of the weights.
    fn reverse(&mut self);

    /// The parameter at which a segment is halved.
    #[inline(always)]
    fn middle(&self) -> f64 {
        SPLIT
    }

    /// Whether a segment is not cut any more, because its parameters are equal up to rounding. Where weights differ much, its
    /// points need not be.
    #[inline(always)]
    fn is_indivisible(_piece: &Piece<C, Self>) -> bool {
        false
    }

    /// The parameters between which a segment is kept, with their rounding if that moves a point by more than the slack.
    #[inline(always)]
    fn widened(&self, lo: f64, hi: f64) -> (f64, f64) {
        (lo, hi)
    }

    /// The value and the derivative at s of a coordinate of the segment.
    fn value_and_slope(&self, row: &C, s: f64) -> (f64, f64);

    /// Coefficients 0 to `last` between which the vector A(s) − B(s) lies, and `last`. The first and the last one are the
    /// vectors at both ends.
    fn differences<'a>(
        a: &'a Piece<C, Self>,
        b: &'a Piece<C, Self>,
    ) -> (usize, impl Fn(usize) -> [f64; 2] + 'a)
    where
        C: 'a,
        Self: 'a;
}

/// A polynomial curve: all weights are 1.
#[derive(Clone, Copy, Debug)]
pub struct Unweighted;

impl<C: Coefficients> Weights<C> for Unweighted {
    #[inline(always)]
    fn weight(&self, _i: usize) -> f64 {
        1.0
    }

    #[inline(always)]
    fn keep_after(piece: &mut Piece<C>, s: f64) {
        keep_after(piece.x.get_mut(), s);
        keep_after(piece.y.get_mut(), s);
    }

    #[inline(always)]
    fn keep_before(piece: &mut Piece<C>, s: f64) {
        keep_before(piece.x.get_mut(), s);
        keep_before(piece.y.get_mut(), s);
    }

    #[inline(always)]
    fn split(left: &mut Piece<C>, right: &mut Piece<C>, s: f64) {
        split(left.x.get_mut(), right.x.get_mut(), s);
        split(left.y.get_mut(), right.y.get_mut(), s);
    }

    #[inline(always)]
    fn reverse(&mut self) {}

    #[inline(always)]
    fn value_and_slope(&self, row: &C, s: f64) -> (f64, f64) {
        value_and_slope(row.get(), s)
    }

    /// The differences of the control points.
    #[inline(always)]
    fn differences<'a>(a: &'a Piece<C>, b: &'a Piece<C>) -> (usize, impl Fn(usize) -> [f64; 2] + 'a)
    where
        C: 'a,
    {
        let difference = |i: usize| {
            let ([ax, ay], [bx, by]) = (a.point(i), b.point(i));
            [ax - bx, ay - by]
        };
        (a.last(), difference)
    }
}

/// A rational curve. Source: Farin, *Curves and Surfaces for CAGD*, §13.3, for cutting.
impl<C: Coefficients> Weights<C> for C {
    #[inline(always)]
    fn weight(&self, i: usize) -> f64 {
        self.get()[i]
    }

    fn keep_after(piece: &mut Piece<C, C>, s: f64) {
        let (x, y, w) = piece.rows_mut();
        for level in 1..w.len() {
            for i in 0..w.len() - level {
                let (weight, share) = weigh(w[i], w[i + 1], s);
                x[i] = lerp(x[i], x[i + 1], share);
                y[i] = lerp(y[i], y[i + 1], share);
                w[i] = weight;
            }
        }
    }

    fn keep_before(piece: &mut Piece<C, C>, s: f64) {
        let (x, y, w) = piece.rows_mut();
        for level in 1..w.len() {
            for i in (level..w.len()).rev() {
                let (weight, share) = weigh(w[i - 1], w[i], s);
                x[i] = lerp(x[i - 1], x[i], share);
                y[i] = lerp(y[i - 1], y[i], share);
                w[i] = weight;
            }
        }
    }

    fn split(left: &mut Piece<C, C>, right: &mut Piece<C, C>, s: f64) {
        Self::keep_before(left, s);
        Self::keep_after(right, s);
    }

    fn reverse(&mut self) {
        self.get_mut().reverse();
    }

    /// That of the curve with equal weights at both ends, so that the halves have about the same size.
    fn middle(&self) -> f64 {
        let (w, n) = (self.get(), self.get().len() - 1);
        let speed = balancing_speed(w[0] / w[n], n);
        let middle = SPLIT * speed / (1.0 - SPLIT + SPLIT * speed);
        middle.clamp(SHORTEST, 1.0 - ROUNDING)
    }

    fn is_indivisible(piece: &Piece<C, C>) -> bool {
        (piece.to - piece.from).abs() <= SHORTEST
    }

    fn widened(&self, lo: f64, hi: f64) -> (f64, f64) {
        ((lo - ROUNDING).max(0.0), (hi + ROUNDING).min(1.0))
    }

    /// With the last two points p, q of de Casteljau's triangle and their weights v, w: the derivative is
    /// n v w (q − p) divided by the square of the weight at s. Source: Floater, "Derivatives of rational Bézier curves", CAGD 9 (1992).
    fn value_and_slope(&self, row: &C, s: f64) -> (f64, f64) {
        let (mut row, mut weights) = (row.clone(), self.clone());
        let (row, w) = (row.get_mut(), weights.get_mut());
        let n = row.len() - 1;
        for level in 1..n {
            for i in 0..=n - level {
                let (weight, share) = weigh(w[i], w[i + 1], s);
                row[i] = lerp(row[i], row[i + 1], share);
                w[i] = weight;
            }
        }
        let (weight, share) = weigh(w[0], w[1], s);
        let rate = n as f64 * (w[0] / weight) * (w[1] / weight);
        (lerp(row[0], row[1], share), rate * (row[1] - row[0]))
    }

    /// A(s) − B(s) is a rational function of degree 2n: its weights are sums of wᵢ wⱼ C(n, i) C(n, j) with i + j = k, and
    /// its coefficients the means of Aᵢ − Bⱼ with these weights.
    ///
    /// The weights of B are multiplied by powers, which changes the speed along B: at s = ½ both segments then have the
    /// same x. If B runs along A, B and A are the same function of s, because two parameters of one rational curve are
    /// related by (1 − u)/u = c (1 − s)/s.
    fn differences<'a>(
        a: &'a Piece<C, C>,
        b: &'a Piece<C, C>,
    ) -> (usize, impl Fn(usize) -> [f64; 2] + 'a)
    where
        C: 'a,
    {
        let n = a.last();
        let middle = b.time_at(a.weights.value_and_slope(&a.x, 0.5).0);
        let ratio = middle / (1.0 - middle);
        // A segment with no extent in x has no such parameter.
        let ratio = if SPEED_RATIOS.contains(&ratio) {
            ratio
        } else {
            1.0
        };
        let (mut of_a, mut of_b) = (a.weights.clone(), b.weights.clone());
        let mut power = 1.0;
        for i in 0..=n {
            let share = binomial(n, i);
            of_a.get_mut()[i] *= share;
            of_b.get_mut()[i] *= share * power;
            power *= ratio;
        }
        let difference = |k: usize| {
            let (mut x, mut y, mut sum) = (0.0, 0.0, 0.0);
            for i in k.saturating_sub(n)..=k.min(n) {
                let ([ax, ay], [bx, by]) = (a.point(i), b.point(k - i));
                let weight = of_a.get()[i] * of_b.get()[k - i];
                x += weight * (ax - bx);
                y += weight * (ay - by);
                sum += weight;
            }
            [x / sum, y / sum]
        };
        let all: Vec<[f64; 2]> = (0..=2 * n).map(difference).collect();
        (2 * n, move |k| all[k])
    }
}

/// The power of two next to the n-th root of a ratio w₀/wₙ of the weights at the ends of a curve of degree n: with the
/// weights wᵢ times its i-th power, which is the same curve, they are about equal.
pub fn balancing_speed(mut ratio: f64, n: usize) -> f64 {
    let step = (0..n).fold(1.0, |power, _| power * 2.0);
    let mut speed = 1.0;
    while ratio * ratio > step {
        (speed, ratio) = (speed * 2.0, ratio / step);
    }
    while ratio * ratio * step < 1.0 {
        (speed, ratio) = (speed * 0.5, ratio * step);
    }
    speed
}

/// The shortest range of parameters that is cut: a part of the rounding of 1, as parameters near 0 are more accurate.
const SHORTEST: f64 = f64::EPSILON / 256.0;

/// The rounding of a parameter.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The range of ratios of speeds that are adapted; others occur where a segment is a point up to rounding.
const SPEED_RATIOS: std::ops::RangeInclusive<f64> = 0.0625..=16.0;

/// The weight at s between two others, and the part of the way from the first point to the second.
#[inline(always)]
fn weigh(v: f64, w: f64, s: f64) -> (f64, f64) {
    let weight = lerp(v, w, s);
    (weight, s * w / weight)
}
