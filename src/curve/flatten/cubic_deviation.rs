//! Deviation of a segment of a quadratic or cubic from its chord.
//!
//! Let B(t₀ + τ) = B(t₀) + D₁τ + D₂τ² + D₃τ³. With s = τ/h, the cross product of the segment with its chord of step h
//! is
//!
//!   h³ s (1 − s) [ (a + bh) + s h (b + ch) ],   a = D₁×D₂, b = D₁×D₃, c = D₂×D₃:
//!
//! s(1−s) times a linear function. Divided by the length of the chord, h|u| with u = D₁ + hD₂ + h²D₃, it is the
//! distance from the line of the chord, whose maximum has a closed form. Where the segment extends past the ends of its
//! chord, the overshoot is included.

use super::deviation::{Deviation, Fraction, fourth_root};
use crate::bernstein::roots::roots_inside;
use crate::geometry::point::{CrossProduct, Point};

/// 16 · 0.92: h⁴ |D₁×D₂|² / |D₁|² for a parabola that uses 0.92 of the squared tolerance.
const AIMED_BEND: f64 = 14.7;

/// If the guess leaves at most this many chords, the whole rest is tried first.
const FEW_CHORDS: f64 = 3.0;

/// The value of (chord / speed)² below which the chord of a loop is only rounding and has no direction.
const CLOSED_RATIO: f64 = 1e-20;

/// [`Deviation`] of a curve of degree 1 to 3.
pub(crate) struct CubicDeviation<P: Point> {
    /// The Taylor coefficients at t = 0.
    taylor: [P; 3],
    /// The Taylor coefficients at the current start, and their cross products.
    d: [P; 3],
    a: P::CrossProduct,
    b: P::CrossProduct,
    c: P::CrossProduct,
    per_squared_tolerance: f64,
}

impl<P: Point> CubicDeviation<P> {
    /// Expects 2 to 4 control points of moderate size.
    pub(crate) fn new(points: &[P], tolerance: f64) -> Self {
        let taylor = match *points {
            [p0, p1] => [p1 - p0, P::default(), P::default()],
            [p0, p1, p2] => [(p1 - p0) * 2.0, (p2 - p1) - (p1 - p0), P::default()],
            [p0, p1, p2, p3, ..] => {
                let (e0, e1, e2) = (p1 - p0, p2 - p1, p3 - p2);
                [e0 * 3.0, (e1 - e0) * 3.0, (e2 - e1) - (e1 - e0)]
            }
            _ => [P::default(); 3],
        };
        let zero = P::default().cross(P::default());
        let per_squared_tolerance = 1.0 / (tolerance * tolerance);
        Self {
            taylor,
            d: taylor,
            a: zero,
            b: zero,
            c: zero,
            per_squared_tolerance,
        }
    }

    /// The square of the maximum distance from the line of the chord, times |u|².
    #[inline]
    fn across_squared(&self, h: f64) -> f64 {
        let first = self.a + self.b * h;
        let last = first + (self.b + self.c * h) * h;
        let square = h * h;
        square * square * greatest_squared(first, last)
    }

    /// The squared total deviation, in squares of the tolerance, of a segment that may extend past the ends of its
    /// chord.
    fn squared_past_ends(&self, h: f64, u: P, end: P) -> f64 {
        let d1 = self.d[0];
        let length = u.dot(u);
        if length > CLOSED_RATIO * (d1.dot(d1) + end.dot(end)) {
            let across = self.across_squared(h) / length;
            return (across + self.overshoot_squared(h, u)) * self.per_squared_tolerance;
        }
        // The chord is negligible; the distance of the segment is at most that of its control points.
        let farthest = (d1.length() / 3.0).max((u - end * (1.0 / 3.0)).length()) * h;
        farthest * farthest * self.per_squared_tolerance
    }

    /// The squared overshoot past the ends of the chord.
    fn overshoot_squared(&self, h: f64, u: P) -> f64 {
        let [d1, d2, d3] = self.d;
        let direction = u.normalize_or_zero();
        let (a, b, c) = (
            d1.dot(direction) * h,
            d2.dot(direction) * h * h,
            d3.dot(direction) * h * h * h,
        );
        let length = a + b + c;
        let along = |s: f64| ((c * s + b) * s + a) * s;
        // The component of B′ along the chord in Bernstein form.
        let turns = roots_inside(&[a, a + b, a + 2.0 * b + 3.0 * c]);
        turns
            .iter()
            .map(|&s| (along(s) - length).max(-along(s)).max(0.0).powi(2))
            .fold(0.0, f64::max)
    }
}

impl<P: Point> Deviation for CubicDeviation<P> {
    #[inline]
    fn start_at(&mut self, t: f64) {
        let [d1, d2, d3] = self.taylor;
        self.d = [
            (d3 * (1.5 * t) + d2) * (2.0 * t) + d1,
            d3 * (3.0 * t) + d2,
            d3,
        ];
        let [d1, d2, d3] = self.d;
        (self.a, self.b, self.c) = (d1.cross(d2), d1.cross(d3), d2.cross(d3));
    }

    #[inline]
    fn squared(&mut self, h: f64) -> Fraction {
        let [d1, d2, d3] = self.d;
        let u = d1 + (d2 + d3 * h) * h;
        let end = d1 + (d2 * 2.0 + d3 * (3.0 * h)) * h;
        let length = u.dot(u);
        let (along_start, along_end) = (d1.dot(u), end.dot(u));
        // If the inner control points project into the chord, the segment does so too.
        let inside =
            along_start.min(along_end) >= 0.0 && along_start.max(along_end) <= 3.0 * length;
        if inside && length > 0.0 {
            return Fraction {
                over: self.across_squared(h) * self.per_squared_tolerance,
                under: length,
            };
        }
        Fraction {
            over: self.squared_past_ends(h, u, end),
            under: 1.0,
        }
    }

    #[inline]
    fn guess(&self, expected: f64) -> f64 {
        // Around the middle of the step the segment is nearly a parabola: h²|D₁×D₂| / (4|D₁|) equals the tolerance.
        let [d1, d2, d3] = self.d;
        let x = 0.5 * expected;
        let bend = d2 + d3 * (3.0 * x);
        let speed = d1 + (d2 + bend) * x;
        let across = speed.cross(bend).size_squared() * self.per_squared_tolerance;
        let square = AIMED_BEND * speed.dot(speed);
        if expected > 0.0 {
            return expected
                * fourth_root(
                    square,
                    across * (expected * expected) * (expected * expected),
                );
        }
        let h = (square / across).sqrt().sqrt();
        if h > 0.0 { h } else { 1.0 }
    }

    #[inline]
    fn first_try(&mut self, guess: f64, rest: f64) -> f64 {
        if guess >= rest || (guess * FEW_CHORDS >= rest && self.squared(rest).bounded_by(1.0)) {
            rest
        } else {
            guess
        }
    }
}

/// The square of the maximum over [0, 1] of |s(1−s)((1−s)·first + s·last)|, or up to 1.5 % more.
///
/// If the two vectors have a non-negative scalar product, K(E(|first|² + |last|²) + 2M first·last) bounds it without a
/// square root: each s²(1−s)²|…|² is linear in the three products, so it is sufficient that the bound holds for
/// orthogonal vectors, where E is the maximum, and for parallel ones, where M makes it exact for equal vectors and K is
/// the largest ratio.
#[inline]
pub(crate) fn greatest_squared<C: CrossProduct>(first: C, last: C) -> f64 {
    const E: f64 = LOBE_OF_ONE_END * LOBE_OF_ONE_END;
    const M: f64 = 1.0 / 32.0 - E;
    const K: f64 = 1.01466;
    let dot = first.dot(last);
    if dot >= 0.0 {
        return K * (E * (first.size_squared() + last.size_squared()) + 2.0 * M * dot);
    }
    greatest_squared_of_opposed(first, last)
}

/// [`greatest_squared`] for vectors with a negative scalar product, as around an inflection; exact for parallel ones.
fn greatest_squared_of_opposed<C: CrossProduct>(first: C, last: C) -> f64 {
    let (large, small) = if first.size_squared() >= last.size_squared() {
        (first, last)
    } else {
        (last, first)
    };
    let square = large.size_squared();
    let along = small.dot(large) / square;
    let sideways = (small + large * -along).size_squared() / square;
    let along_chord = lobe(along);
    square * (along_chord * along_chord + sideways * LOBE_OF_ONE_END * LOBE_OF_ONE_END)
}

/// The maximum of s(1−s)·s, at s = ⅔.
const LOBE_OF_ONE_END: f64 = 4.0 / 27.0;

/// The maximum over [0, 1] of |s(1−s)((1−s) + r s)| for r in [−1, 1], at s = 1/(2 − r + √(1 − r + r²)).
fn lobe(r: f64) -> f64 {
    let s = 1.0 / (2.0 - r + (1.0 - r + r * r).sqrt());
    s * (1.0 - s) * ((1.0 - s) + r * s)
}
