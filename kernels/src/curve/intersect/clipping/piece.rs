//! A segment of a plane curve, polynomial or with weights, and operations on one of its coordinates.
//!
//! The coordinates of a rational segment are those of its control points Pᵢ, not multiplied by the weights wᵢ. The weights
//! are positive, so the segment lies in the hull of the Pᵢ, and its direction is a sum of the vectors Pᵢ₊₁ − Pᵢ with
//! positive factors: what the search concludes from points and edges holds for rational curves, too.

use super::constants::SPLIT;
use crate::bernstein::de_casteljau::{keep_after, keep_before, lerp, split};
use crate::bernstein::derivatives::{cubic_with_derivative, with_derivatives};
use crate::bernstein::weights::binomial;
use crate::numeric::order::range;
use crate::numeric::zero::newton_in_bracket;

/// The Bernstein coefficients of one coordinate: an array if the degree is known, otherwise a vector.
pub trait Coefficients: Clone {
    /// The coefficients.
    fn get(&self) -> &[f64];
    /// The coefficients, mutable.
    fn get_mut(&mut self) -> &mut [f64];
}

impl Coefficients for [f64; 4] {
    #[inline(always)]
    fn get(&self) -> &[f64] {
        self
    }
    #[inline(always)]
    fn get_mut(&mut self) -> &mut [f64] {
        self
    }
}

impl Coefficients for Vec<f64> {
    fn get(&self) -> &[f64] {
        self
    }
    fn get_mut(&mut self) -> &mut [f64] {
        self
    }
}

/// The segment of a plane curve between two parameters; `from` > `to` if it runs backwards.
#[derive(Clone, Copy, Debug)]
pub struct Piece<C, W = Unweighted> {
    /// The x coordinates of the control points.
    pub x: C,
    /// The y coordinates of the control points.
    pub y: C,
    /// The weights of the control points.
    pub weights: W,
    /// The parameter of the curve at the start of the segment.
    pub from: f64,
    /// The parameter of the curve at the end of the segment.
    pub to: f64,
}

impl<C: Coefficients, W: Weights<C>> Piece<C, W> {
    /// The degree.
    #[inline(always)]
    pub(super) fn last(&self) -> usize {
        self.x.get().len() - 1
    }

    /// The parameter of the curve at parameter s of the segment; exact at the ends.
    #[inline(always)]
    pub(super) fn at(&self, s: f64) -> f64 {
        if s == 1.0 {
            self.to
        } else {
            self.from + s * (self.to - self.from)
        }
    }

    /// Control point i.
    #[inline(always)]
    pub(super) fn point(&self, i: usize) -> [f64; 2] {
        [self.x.get()[i], self.y.get()[i]]
    }

    /// The vector from control point i to the next.
    #[inline(always)]
    pub(super) fn edge(&self, i: usize) -> [f64; 2] {
        let (x, y) = (self.x.get(), self.y.get());
        [x[i + 1] - x[i], y[i + 1] - y[i]]
    }

    /// The vector from the start to the end.
    #[inline(always)]
    pub(super) fn chord(&self) -> [f64; 2] {
        let (x, y, n) = (self.x.get(), self.y.get(), self.last());
        [x[n] - x[0], y[n] - y[0]]
    }

    /// The larger side of the box of the control points.
    pub(super) fn extent(&self) -> f64 {
        let spread = |row: &[f64]| {
            let (min, max) = range(row.iter().copied());
            max - min
        };
        spread(self.x.get()).max(spread(self.y.get()))
    }

    /// Whether the bounding boxes of the control points are farther apart than the slack.
    pub(super) fn boxes_are_disjoint(&self, other: &Self, slack: f64) -> bool {
        let apart = |a: &[f64], b: &[f64]| {
            let (a, b) = (range(a.iter().copied()), range(b.iter().copied()));
            a.0 > b.1 + slack || b.0 > a.1 + slack
        };
        apart(self.x.get(), other.x.get()) || apart(self.y.get(), other.y.get())
    }

    /// The point and the derivative at s.
    #[inline(always)]
    pub(super) fn taylor(&self, s: f64) -> ([f64; 2], [f64; 2]) {
        let (x, dx) = self.weights.value_and_slope(&self.x, s);
        let (y, dy) = self.weights.value_and_slope(&self.y, s);
        ([x, y], [dx, dy])
    }

    /// The segment between two parameters of this one, s₀ ≤ s₁.
    #[inline]
    pub(super) fn between(&self, s0: f64, s1: f64) -> Self {
        let mut piece = self.clone();
        if s0 > 0.0 {
            W::keep_after(&mut piece, s0);
        }
        // The first cut leaves the segment from s₀ to 1, in which s₁ is at (s₁ − s₀)/(1 − s₀).
        if s1 < 1.0 {
            let s = if s0 < 1.0 {
                (s1 - s0) / (1.0 - s0)
            } else {
                0.0
            };
            W::keep_before(&mut piece, s);
        }
        (piece.from, piece.to) = (self.at(s0), self.at(s1));
        piece
    }

    /// The segments before and after s.
    pub(super) fn split(&self, s: f64) -> (Self, Self) {
        let (mut left, mut right) = (self.clone(), self.clone());
        left.to = self.at(s);
        right.from = left.to;
        W::split(&mut left, &mut right, s);
        (left, right)
    }

    /// The segment in the opposite direction.
    pub(super) fn reversed(&self) -> Self {
        let mut piece = self.clone();
        piece.x.get_mut().reverse();
        piece.y.get_mut().reverse();
        piece.weights.reverse();
        (piece.from, piece.to) = (self.to, self.from);
        piece
    }

    /// The segment in coordinates along a unit vector and across it.
    pub(super) fn turned(&self, [dx, dy]: [f64; 2]) -> Self {
        let mut piece = self.clone();
        let both = piece.x.get_mut().iter_mut().zip(piece.y.get_mut());
        both.for_each(|(x, y)| (*x, *y) = (dx * *x + dy * *y, dx * *y - dy * *x));
        piece
    }

    /// The parameter at which x, which does not decrease, has a value; 0 or 1 for a value outside the range.
    pub(super) fn time_at(&self, value: f64) -> f64 {
        let (x, n) = (self.x.get(), self.last());
        if value <= x[0] {
            return 0.0;
        }
        if value >= x[n] {
            return 1.0;
        }
        let guess = (value - x[0]) / (x[n] - x[0]);
        newton_in_bracket([0.0, 1.0], guess, 0.0, |s| {
            let (v, slope) = self.weights.value_and_slope(&self.x, s);
            (v - value, slope)
        })
    }
}

impl<C: Coefficients> Piece<C, C> {
    /// Both coordinates and the weights.
    pub(super) fn rows_mut(&mut self) -> (&mut [f64], &mut [f64], &mut [f64]) {
        (self.x.get_mut(), self.y.get_mut(), self.weights.get_mut())
    }
}

/// The value and the derivative at s of a polynomial in Bernstein form.
#[inline(always)]
pub(super) fn value_and_slope(row: &[f64], s: f64) -> (f64, f64) {
    if let [a, b, c, d] = *row {
        return cubic_with_derivative(&[a, b, c, d], s);
    }
    value_and_slope_of_any_degree(row, s)
}

fn value_and_slope_of_any_degree(row: &[f64], s: f64) -> (f64, f64) {
    // The maximum degree is 64.
    let mut level = [0.0; 65];
    level[..row.len()].copy_from_slice(row);
    let [value, slope, _] = with_derivatives(&mut level[..row.len()], s);
    (value, slope)
}

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
