//! Whether a cubic stays within the tolerance of one side of a stroke of varying radius: the bound between two pairs of
//! points, with halvings where it is too large.

use super::section::{Disc, SectionEvaluator};
use crate::geometry::point::Point;
use casteljau_kernels::bernstein::derivatives::cubic_with_derivative;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use casteljau_kernels::spline::offset::side_bound::side_bound;
use glam::{DVec2, DVec3};

/// Maximum number of bounds evaluated for one cubic before it is rejected.
const MAX_BOUNDS: usize = 96;

/// Newton steps to the point of a cubic next to a point of the side.
const FOOT_STEPS: usize = 2;

/// A point of a cubic, and the disc whose point of the side is next to it.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    /// The parameter of the cubic.
    pub(super) u: f64,
    /// The parameter of the disc on the section.
    pub(super) t: f64,
    pub(super) disc: Disc,
}

/// A cubic that may stand for a part of a side.
pub(super) struct SideBound<'a> {
    pub(super) evaluator: &'a SectionEvaluator<'a>,
    pub(super) side: f64,
    /// −1 where the side runs backwards.
    pub(super) sign: f64,
    pub(super) tolerance: f64,
    pub(super) cubic: [DVec2; 4],
}

impl SideBound<'_> {
    /// Whether the cubic is proved to be within the tolerance of the side between the first and the last pair.
    pub(super) fn is_proved(&self, pairs: &[Pair]) -> bool {
        let mut work = WorkLimit::new(MAX_BOUNDS);
        pairs
            .windows(2)
            .all(|pair| self.holds_between(&pair[0], &pair[1], &mut work))
    }

    fn holds_between(&self, from: &Pair, to: &Pair, work: &mut WorkLimit) -> bool {
        if self.bound(from, to) <= self.tolerance {
            return true;
        }
        if !work.spend(1) {
            return false;
        }
        let t = 0.5 * (from.t + to.t);
        let disc = self.evaluator.at(t);
        let point = disc.point(self.side);
        let mut u = 0.5 * (from.u + to.u);
        for _ in 0..FOOT_STEPS {
            u = foot_step(&self.cubic, u, point).clamp(from.u, to.u);
        }
        let middle = Pair { u, t, disc };
        Point::norm(cubic_with_derivative(&self.cubic, u).0 - point) <= self.tolerance
            && self.holds_between(from, &middle, work)
            && self.holds_between(&middle, to, work)
    }

    /// The bound between two pairs; infinite or NaN if there is none.
    fn bound(&self, from: &Pair, to: &Pair) -> f64 {
        let (du, dt) = (to.u - from.u, to.t - from.t);
        // (B, −r) and W at both ends.
        let [p, q] = [from, to].map(|pair| pair.disc.center.extend(-pair.disc.radius()));
        let [v, w] = [from, to].map(|pair| {
            let disc = &pair.disc;
            disc.tangent.extend(-disc.slope) * (disc.speed * dt)
        });
        let slopes = [v, (q - p) * 3.0 - v - w, w];
        // M, from its values and derivatives at the ends.
        let [a, d] = [(from, p, v), (to, q, w)].map(|(pair, disc, rate)| {
            let (point, first) = cubic_with_derivative(&self.cubic, pair.u);
            [(point, disc), (first * du, rate)]
                .map(|(of_cubic, of_disc)| of_cubic.extend(0.0) - of_disc)
        });
        let m = [a[0], a[0] + a[1] / 3.0, d[0] - d[1] / 3.0, d[0]];
        let rest = self
            .evaluator
            .section
            .hermite_error(slopes.map(DVec3::truncate), dt);
        side_bound(&m, &slopes, self.sign, rest, self.tolerance)
    }
}

/// A Newton step from a parameter of a cubic to that of its point next to another one.
pub(super) fn foot_step(cubic: &[DVec2; 4], t: f64, point: DVec2) -> f64 {
    let (p, first) = cubic_with_derivative(cubic, t);
    let step = (p - point).dot(first) / first.dot(first);
    if step.is_finite() {
        (t - step).clamp(0.0, 1.0)
    } else {
        t
    }
}
