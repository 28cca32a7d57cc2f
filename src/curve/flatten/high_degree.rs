//! Deviation of a segment of a curve of any degree from its chord.
//!
//! Relative to the chord, a segment has control points fᵢ with f₀ = fₙ = 0, so it is s(1−s) Σ gᵢ Bᵢⁿ⁻²(s) with gᵢ =
//! n(n−1) / ((i+1)(n−1−i)) · fᵢ₊₁. As the segment gets shorter, the gᵢ approach a linear function; the bound is the
//! exact maximum for that linear function plus the deviation of the gᵢ from it.

use super::cubic_deviation::greatest_squared;
use super::deviation::{Deviation, Fraction};
use crate::bernstein::de_casteljau::keep_between;
use crate::bernstein::evaluate::{evaluate, evaluate_scalar};
use crate::bernstein::roots::roots_inside;
use crate::curve::Curve;
use crate::geometry::point::Point;
use crate::numeric::float::ratio;
use crate::numeric::list::{Points, Scalars};
use glam::DVec3;

/// After four halvings the bound of a parabola is 0.4 % above its height.
const MAX_HALVINGS: usize = 4;

/// [`Deviation`] of a curve of degree 2 to 64.
pub(crate) struct PieceDeviation {
    points: Points<DVec3>,
    start: f64,
    /// The point at the start.
    from: DVec3,
    tolerance: f64,
}

impl PieceDeviation {
    /// Expects control points of moderate size. Plane points are converted to space, so that the code is compiled once.
    pub(crate) fn new(points: Points<DVec3>, tolerance: f64) -> Self {
        Self {
            start: 0.0,
            from: points[0],
            points,
            tolerance,
        }
    }

    /// An upper bound on the distance of the segment from the line through its chord; `direction` has length 1.
    fn across(&self, piece: &[DVec3], direction: DVec3) -> f64 {
        let distances: Points<DVec3> = piece
            .iter()
            .map(|&p| direction.cross(p - piece[0]))
            .collect();
        let bound = nearly_cubic_bound(&distances);
        let undecided =
            bound > self.tolerance && Point::length(evaluate(&distances, 0.5)) <= self.tolerance;
        if undecided {
            bound.min(halved_bound(&distances, MAX_HALVINGS))
        } else {
            bound
        }
    }

    /// Quick test: whether one of three points of the segment is farther from its chord than the tolerance.
    fn leaves_chord(&self, h: f64) -> bool {
        let at = |part: f64| evaluate(&self.points, (self.start + h * part).min(1.0)) - self.from;
        let direction = Point::normalize_or_zero(at(1.0));
        [0.5, 0.25, 0.75]
            .iter()
            .any(|&part| Point::length(direction.cross(at(part))) > self.tolerance)
    }

    /// The overshoot of the segment past the ends of its chord.
    fn overshoot(piece: &[DVec3], direction: DVec3, length: f64) -> f64 {
        let along: Scalars = piece
            .iter()
            .map(|&p| (p - piece[0]).dot(direction))
            .collect();
        if along.iter().all(|a| (0.0..=length).contains(a)) {
            return 0.0;
        }
        let slopes: Scalars = along.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let past = |&s: &f64| {
            let a = evaluate_scalar(&along, s);
            (a - length).max(-a).max(0.0)
        };
        roots_inside(&slopes).iter().map(past).fold(0.0, f64::max)
    }
}

/// A bound on Σ fᵢ Bᵢ(s) with f₀ = fₙ = 0; the closer the curve is to a cubic, the tighter the bound.
fn nearly_cubic_bound(f: &[DVec3]) -> f64 {
    let n = f.len() - 1;
    let bend = |i: usize| f[i + 1] * ratio(n * (n - 1), (i + 1) * (n - 1 - i));
    let (first, last) = (bend(0), bend(n - 2));
    let beside_linear =
        |i: usize| Point::length(bend(i) - first.lerp(last, ratio(i, (n - 2).max(1))));
    greatest_squared(first, last).sqrt() + 0.25 * (1..n - 1).map(beside_linear).fold(0.0, f64::max)
}

/// The largest control point after some halvings; each halving brings the control points four times closer to the
/// curve.
fn halved_bound(f: &[DVec3], halvings: usize) -> f64 {
    if halvings == 0 {
        return f.iter().map(|&p| Point::length(p)).fold(0.0, f64::max);
    }
    let (left, right) = Curve::from_slice(f).halve();
    halved_bound(left.control_points(), halvings - 1)
        .max(halved_bound(right.control_points(), halvings - 1))
}

impl Deviation for PieceDeviation {
    fn start_at(&mut self, t: f64) {
        self.start = t;
        self.from = evaluate(&self.points, t);
    }

    fn squared(&mut self, h: f64) -> Fraction {
        let mut piece = self.points.clone();
        keep_between(&mut piece, self.start, (self.start + h).min(1.0));
        let chord = piece[piece.len() - 1] - piece[0];
        let direction = Point::normalize_or_zero(chord);
        let distance = if direction == DVec3::ZERO {
            piece
                .iter()
                .map(|&p| Point::length(p - piece[0]))
                .fold(0.0, f64::max)
        } else {
            self.across(&piece, direction).hypot(Self::overshoot(
                &piece,
                direction,
                Point::length(chord),
            ))
        };
        Fraction {
            over: (distance / self.tolerance).powi(2),
            under: 1.0,
        }
    }

    fn guess(&self, expected: f64) -> f64 {
        if expected > 0.0 {
            return expected;
        }
        // The second differences of the whole curve, as an estimate for the start.
        let n = ratio(self.points.len() - 1, 1);
        let second = |w: &[DVec3]| Point::length((w[2] - w[1]) - (w[1] - w[0]));
        let bend = self.points.windows(3).map(second).fold(0.0, f64::max) * n * (n - 1.0);
        (8.0 * self.tolerance / bend).sqrt().min(1.0)
    }

    /// A curve of high degree may return to its chord more than once, so steps are tried from the whole rest downwards.
    fn first_try(&mut self, guess: f64, rest: f64) -> f64 {
        let mut h = rest;
        while h > 2.0 * guess && (self.leaves_chord(h) || !self.squared(h).bounded_by(1.0)) {
            h *= 0.5;
        }
        h
    }
}
