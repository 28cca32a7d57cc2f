//! A segment of a plane curve, and operations on one of its coordinates.

use super::weights::{Unweighted, Weights};
use crate::bernstein::derivatives::{cubic_with_derivative, with_derivatives};
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
