//! Equal steps in t along the parts of a curve, whose chords keep a tolerance.
//!
//! On a part of unit length in its own parameter, let V be the control vectors of B′ and G those of B″. For a step h, let
//! c be the chord divided by h: an average of B′, hence in the convex hull of V.
//!
//! - The distance of the curve from the chord at equal parameters is at most h²/8 · max |B″|, and |B″| ≤ max |Gᵢ|.
//! - Across the chord it is at most h²/8 · max |B″ × c| / |c|, and |B″ × c| ≤ max |Gᵢ × Vⱼ|. If d is a unit vector with
//!   Vⱼ·d ≥ |Vⱼ|/√2 for all j, any two directions of B′ are at most 90° apart, so the curve does not pass the ends of the
//!   chord, and |c| ≥ c·d ≥ min Vⱼ·d.
//!
//! Both bounds hold for every step of the part, so nothing has to be measured. A part where they are far above what its
//! curvature needs is halved. Source of the first bound: Wang, "The subdivision method for finding the intersection
//! between two Bézier curves or surfaces" (1984).

use crate::geometry::error::MAX_DEGREE;
use crate::geometry::point::Point;
use casteljau_kernels::bernstein::de_casteljau::split_with;
use glam::DVec3;

/// A part is halved if that may save more than about half this number of steps: one is lost at each end.
const MAX_WASTE: f64 = 1.5;

/// Halvings after which the bounds are used as they are: a part of 2⁻⁴⁸, 32 roundings of the parameter, is a point up to
/// rounding.
const PART_HALVINGS: u32 = f64::MANTISSA_DIGITS - 5;

/// A part of a curve, and the number of equal steps in it.
#[derive(Clone, Copy)]
pub(super) struct EqualSteps {
    pub(super) from: f64,
    pub(super) length: f64,
    /// A whole number, at least 1.
    pub(super) count: f64,
}

/// Finds the parts of a curve of degree 4 to 64.
pub(super) struct StepPlanner<'a, F> {
    tolerance: f64,
    /// 1 / (8 · tolerance).
    per_tolerance: f64,
    degree: usize,
    visit: &'a mut F,
}

impl<'a, F: FnMut(EqualSteps)> StepPlanner<'a, F> {
    pub(super) fn new(degree: usize, tolerance: f64, visit: &'a mut F) -> Self {
        Self {
            tolerance,
            per_tolerance: 0.125 / tolerance,
            degree,
            visit,
        }
    }

    /// Passes on the parts of the curve with the given control points, from its start to its end.
    pub(super) fn plan(
        &mut self,
        points: &[DVec3; MAX_DEGREE + 1],
        [from, length]: [f64; 2],
        halvings: u32,
    ) {
        let n = self.degree;
        let (steps, min_squared) = self.steps_and_min_squared(&points[..=n]);
        // The possible saving is steps − min = (steps² − min²) / (steps + min).
        let waste_squared = steps * steps - min_squared;
        let is_flat = steps <= 1.0 || is_flat(&points[..=n], self.tolerance);
        if is_flat || waste_squared <= MAX_WASTE * steps || halvings == PART_HALVINGS {
            let count = if is_flat { 1.0 } else { steps.ceil() };
            return (self.visit)(EqualSteps {
                from,
                length,
                count,
            });
        }
        let (mut left, mut right) = (*points, *points);
        split_with(&mut left[..=n], &mut right[..=n], |a, b| (a + b) * 0.5);
        let half = 0.5 * length;
        self.plan(&left, [from, half], halvings + 1);
        self.plan(&right, [from + half, half], halvings + 1);
    }

    /// The number of steps that is enough, and the square of an estimate of the smallest number that is possible.
    fn steps_and_min_squared(&self, points: &[DVec3]) -> (f64, f64) {
        let n = points.len() - 1;
        // The control vectors of B′ and of B″.
        let (mut v, mut g) = ([DVec3::ZERO; MAX_DEGREE], [DVec3::ZERO; MAX_DEGREE]);
        for i in 0..n {
            v[i] = (points[i + 1] - points[i]) * n as f64;
        }
        for i in 0..n - 1 {
            g[i] = (v[i + 1] - v[i]) * (n - 1) as f64;
        }
        let chord = points[n] - points[0];
        let square = chord.dot(chord);
        let (mut bend, mut turn, mut turn_sum): (f64, f64, f64) = (0.0, 0.0, 0.0);
        let (mut along, mut is_narrow, mut speeds) = (f64::INFINITY, true, 0.0);
        for &v in &v[..n] {
            let ahead = v.dot(chord);
            along = along.min(ahead);
            // |Vⱼ·d| ≥ |Vⱼ|/√2 for the direction d of the chord; `along` gives the sign.
            is_narrow &= 2.0 * ahead * ahead >= v.dot(v) * square;
            speeds += v.dot(v);
        }
        for (i, &g) in g[..n - 1].iter().enumerate() {
            bend = bend.max(g.dot(g));
            turn_sum += Point::norm(g.cross(v[i]));
            for &v in &v[..n] {
                turn = turn.max(g.cross(v).length_squared());
            }
        }
        let mut squared = bend.sqrt();
        if is_narrow && along > 0.0 {
            // max |Gᵢ × Vⱼ| / min Vⱼ·d.
            squared = squared.min(turn.sqrt() * square.sqrt() / along);
        }
        // An estimate of |B″ × B′| / |B′|: the mean of |Gᵢ × Vᵢ| divided by the root mean square of |Vⱼ|.
        let min_squared = turn_sum / ((n - 1) as f64 * (speeds / n as f64).sqrt());
        // Steps h = 1/N keep the tolerance if h²/8 · bound ≤ tolerance, so N² = bound / (8 · tolerance).
        (
            (squared * self.per_tolerance).sqrt(),
            min_squared * self.per_tolerance,
        )
    }
}

/// Whether all points are within the tolerance of the segment from the first to the last one, and so the curve.
fn is_flat(points: &[DVec3], tolerance: f64) -> bool {
    let chord = points[points.len() - 1] - points[0];
    let square = chord.dot(chord);
    points.iter().all(|&p| {
        let gap = p - points[0];
        let along = gap.dot(chord);
        let part = if along > 0.0 {
            (along / square).min(1.0)
        } else {
            0.0
        };
        let off = gap - chord * part;
        off.dot(off) <= tolerance * tolerance
    })
}
