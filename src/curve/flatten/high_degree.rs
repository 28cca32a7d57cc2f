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
use crate::numeric::float::{as_f64, ratio};
use crate::numeric::list::{Points, Scalars};
use glam::DVec3;

/// After four halvings the bound of a parabola is 0.4 % above its height.
const MAX_HALVINGS: usize = 4;

/// Long chords are tried only to points of the curve at multiples of 1/64 in t, one for each control point at the highest
/// degree.
const SAMPLE_STEPS: usize = 64;

/// Maximum number of long chords that are measured for one vertex.
const MAX_LONG_CHORDS: usize = 3;

/// [`Deviation`] of a curve of degree 2 to 64.
pub(crate) struct PieceDeviation {
    points: Points<DVec3>,
    /// Points of the curve at equal steps of t, the first one after the start.
    samples: Vec<DVec3>,
    start: f64,
    /// The point at the start.
    from: DVec3,
    tolerance: f64,
}

impl PieceDeviation {
    /// Expects control points of moderate size. Plane points are converted to space, so that the code is compiled once.
    pub(crate) fn new(points: Points<DVec3>, tolerance: f64) -> Self {
        let sample = |k: usize| evaluate(&points, ratio(k, SAMPLE_STEPS));
        Self {
            start: 0.0,
            from: points[0],
            samples: (1..=SAMPLE_STEPS).map(sample).collect(),
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

    /// The index of the first sample after a parameter.
    fn first_sample_after(&self, t: f64) -> usize {
        (1..SAMPLE_STEPS)
            .position(|k| ratio(k, SAMPLE_STEPS) > t)
            .unwrap_or(SAMPLE_STEPS - 1)
    }

    /// Quick test: whether one of the samples from `first` to `last` is farther from the chord to the last one than the
    /// tolerance.
    fn leaves_chord(&self, first: usize, last: usize) -> bool {
        let chord = self.samples[last] - self.from;
        let square = chord.dot(chord);
        self.samples[first..last].iter().any(|&p| {
            let gap = p - self.from;
            let along = gap.dot(chord);
            let part = if square > 0.0 {
                (along / square).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let off = gap - chord * part;
            off.dot(off) > self.tolerance * self.tolerance
        })
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
        let n = as_f64(self.points.len() - 1);
        let second = |w: &[DVec3]| Point::length((w[2] - w[1]) - (w[1] - w[0]));
        let bend = self.points.windows(3).map(second).fold(0.0, f64::max) * n * (n - 1.0);
        (8.0 * self.tolerance / bend).sqrt().min(1.0)
    }

    /// A curve of high degree may return to its chord more than once, so chords to the samples are tried, from the end
    /// of the curve downwards.
    fn first_try(&mut self, guess: f64, rest: f64) -> f64 {
        let first = self.first_sample_after(self.start);
        let mut measured = 0;
        for last in (first..SAMPLE_STEPS).rev() {
            let h = ratio(last + 1, SAMPLE_STEPS) - self.start;
            if h <= 2.0 * guess || measured == MAX_LONG_CHORDS {
                break;
            }
            if self.leaves_chord(first, last) {
                continue;
            }
            if self.squared(h).bounded_by(1.0) {
                return h;
            }
            measured += 1;
        }
        if rest <= 2.0 * guess { rest } else { guess }
    }
}
