//! One cubic along a run of points: least squares for the lengths of its handles.

use super::handles::{HandleEquations, MAX_ROUNDS};
use crate::bernstein::derivatives::CubicWithDerivatives;
use crate::numeric::order::larger;
use crate::numeric::vector::Euclidean;
use glam::{DVec2, DVec3};

/// The maximum number of points used for least squares; all points are checked.
const MAX_SAMPLES: usize = 16;

/// Iterations of Newton's method for a foot.
const FOOT_ROUNDS: usize = 2;

/// If the error exceeds this many tolerances after the first two iterations, the fit is given up.
const MAX_INITIAL_ERROR: f64 = 50.0;

/// The minimum damping of the normal equations. The points may have noise, to which handles along a nearly straight run
/// must not be fitted: with the damping of exact targets, fits of noisy points take 2 % more cubics.
const MIN_DAMPING: f64 = 1e-6;

/// The minimum and the maximum length of a handle as a ratio of the chord length of its run. A handle of length 0 would
/// leave the tangent at the joint undefined.
const SHORTEST_HANDLE: f64 = 1.0 / 64.0;
const LONGEST_HANDLE: f64 = 1.5;

/// How much farther than the tolerance a cubic may be from the edge between two sampled points, in lengths of the edge:
/// the height of an arc that turns by 74°.
pub const EDGE_ALLOWANCE: f64 = 1.0 / 6.0;

/// The same in tolerances, where the points are as close together as their noise is large.
const NOISE: f64 = 0.25;

/// How far, in tolerances, a point may lie from the part of the cubic after the feet of the points before it.
const MAX_STEP_BACK: f64 = 3.0;

/// A run of points along which a cubic is fitted, and what it must satisfy.
pub struct FitRun<'a, V> {
    /// The points, at least 2.
    pub points: &'a [V],
    /// The chord length at each point.
    pub lengths: &'a [f64],
    /// The ends of the cubic.
    pub ends: [V; 2],
    /// Its unit tangents there.
    pub tangents: [V; 2],
    /// The maximum distance between a point and its foot on the cubic.
    pub tolerance: f64,
    /// Whether the edges between the points must be within the tolerance, too.
    pub bound_edges: bool,
    /// Whether the cubic is a line.
    pub is_line: bool,
    /// The cubic as it is returned, with rounded control points; `None` if it is refused.
    pub rounded: &'a dyn Fn([V; 4]) -> Option<[V; 4]>,
}

/// The inner control points of a cubic along a run in the plane, or `None` if none was found.
pub fn plane_handles(run: &FitRun<DVec2>) -> Option<[DVec2; 2]> {
    run.handles()
}

/// The inner control points of a cubic along a run in space, or `None` if none was found.
pub fn space_handles(run: &FitRun<DVec3>) -> Option<[DVec3; 2]> {
    run.handles()
}

impl<V: Euclidean> FitRun<'_, V> {
    fn handles(&self) -> Option<[V; 2]> {
        let last = self.points.len() - 1;
        let chord_length = self.lengths[last] - self.lengths[0];
        let ([start, end], [t0, t1]) = (self.ends, self.tangents);
        let mut samples = [(0, 0.0); MAX_SAMPLES];
        let samples = self.samples(&mut samples);
        let (mut a, mut b) = (chord_length / 3.0, chord_length / 3.0);
        let mut previous = f64::INFINITY;
        for round in 0..MAX_ROUNDS {
            let cubic = if self.is_line {
                let third = |k: f64| start * (1.0 - k / 3.0) + end * (k / 3.0);
                [start, third(1.0), third(2.0), end]
            } else {
                [start, start + t0 * a, end + t1 * -b, end]
            };
            let fitted = CubicWithDerivatives::new(cubic);
            let mut equations = HandleEquations::default();
            let mut worst: f64 = 0.0;
            for (index, u) in samples.iter_mut() {
                let p = self.points[*index];
                if round > 0 {
                    *u = foot(&fitted, p, *u);
                }
                let [q, w, _] = fitted.at(*u);
                worst = larger(worst, (q - p).norm());
                // The first round has chord-length parameters and no feet: the whole residual counts.
                let along = if round > 0 { w.unit() } else { V::default() };
                let across = |v: V| v - along * v.dot(along);
                equations.add(*u, [across(t0), across(t1)], q - p);
            }
            if worst <= self.tolerance
                && let Some(cubic) = (self.rounded)(cubic)
                && self.is_within_tolerance(cubic, samples)
            {
                return Some(if self.is_line {
                    [start, end]
                } else {
                    [cubic[1], cubic[2]]
                });
            }
            let limit = MAX_INITIAL_ERROR * self.tolerance;
            // The first improvements may be small; after them the error must decrease by a fifth in each round.
            if round > 1 && !(worst < 0.8 * previous && worst < limit) {
                return None;
            }
            previous = worst;
            let [da, db] = equations.solved(MIN_DAMPING);
            let clamped = |length: f64| {
                length.clamp(
                    SHORTEST_HANDLE * chord_length,
                    LONGEST_HANDLE * chord_length,
                )
            };
            (a, b) = (clamped(a + da), clamped(b + db));
        }
        None
    }

    /// Inner points of the run at equal distances of their indices, and their chord-length parameters.
    fn samples<'s>(&self, out: &'s mut [(usize, f64); MAX_SAMPLES]) -> &'s mut [(usize, f64)] {
        let last = self.points.len() - 1;
        let count = (last - 1).min(MAX_SAMPLES);
        for (k, sample) in out[..count].iter_mut().enumerate() {
            let index = (k + 1) * last / (count + 1);
            *sample = (index, self.part(0, last, index));
        }
        &mut out[..count]
    }

    /// The position of a point between two others by chord length, 0 to 1.
    fn part(&self, from: usize, to: usize, index: usize) -> f64 {
        let (a, b) = (self.lengths[from], self.lengths[to]);
        if b > a {
            (self.lengths[index] - a) / (b - a)
        } else {
            0.5
        }
    }

    /// Whether the cubic satisfies the criteria at all points.
    fn is_within_tolerance(&self, cubic: [V; 4], samples: &[(usize, f64)]) -> bool {
        let cubic = &CubicWithDerivatives::new(cubic);
        let to = self.points.len() - 1;
        let mut known = samples.iter().copied().chain([(to, 1.0)]);
        let (mut left, mut right) = ((0, 0.0), known.next().unwrap_or((to, 1.0)));
        let mut last: (f64, f64) = (0.0, (self.ends[0] - self.points[0]).norm());
        for index in 1..=to {
            while index > right.0 {
                (left, right) = (right, known.next().unwrap_or((to, 1.0)));
            }
            // Interpolate the parameter between the neighbouring samples by chord length.
            let guess = left.1 + (right.1 - left.1) * self.part(left.0, right.0, index);
            let p = self.points[index];
            let u = if index == to {
                1.0
            } else {
                foot(cubic, p, guess)
            };
            let distance = |u: f64| (cubic.at(u)[0] - p).norm();
            // The feet must be in order: a foot before the last one is replaced by that one.
            let forward = larger(u, last.0);
            let tolerance = self.tolerance;
            let (u, off) = if self.bound_edges {
                (forward, distance(forward))
            } else if forward > u && distance(forward) > MAX_STEP_BACK * tolerance {
                return false;
            } else {
                (forward, distance(u))
            };
            let room = if self.bound_edges {
                0.0
            } else {
                let edge = (p - self.points[index - 1]).norm();
                larger(EDGE_ALLOWANCE * edge, NOISE * tolerance)
            };
            // The chord between two feet is as near to the edge as its ends are to the points; `sag` bounds the rest.
            if off > tolerance || larger(off, last.1) + sag(cubic, last.0, u) > tolerance + room {
                return false;
            }
            last = (u, off);
        }
        true
    }
}

/// The parameter of the foot of a point on a cubic, by Newton's method from the guess `u`.
#[inline]
fn foot<V: Euclidean>(cubic: &CubicWithDerivatives<V>, p: V, mut u: f64) -> f64 {
    for _ in 0..FOOT_ROUNDS {
        let [q, w, b] = cubic.at(u);
        let gap = p - q;
        let slope = w.dot(w) - gap.dot(b);
        // Where the squared distance is not convex, a step would lead away from the minimum.
        if slope > 0.0 {
            u = (u + gap.dot(w) / slope).clamp(0.0, 1.0);
        }
    }
    u
}

/// A bound of the Hausdorff distance between a cubic and its chord over [u0, u1]: h²/8 times the maximum of the second
/// derivative, of its component across the chord if the cubic advances along the chord throughout.
#[inline]
fn sag<V: Euclidean>(cubic: &CubicWithDerivatives<V>, u0: f64, u1: f64) -> f64 {
    let h = u1 - u0;
    let [[p, v0, a0], [q, v1, a1]] = [cubic.at(u0), cubic.at(u1)];
    let chord = (q - p).unit();
    // The derivative along the chord as a quadratic Bézier polynomial.
    let advances = [v0, v0 + a0 * (0.5 * h), v1]
        .iter()
        .all(|v| v.dot(chord) >= 0.0);
    let across = |a: V| {
        if advances {
            a - chord * a.dot(chord)
        } else {
            a
        }
    };
    larger(across(a0).norm(), across(a1).norm()) * h * h * 0.125
}
