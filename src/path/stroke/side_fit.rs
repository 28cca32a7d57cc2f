//! Cubics along one side of a section of varying radius.
//!
//! A cubic has the points and the directions of the side at its ends. Its handles have the least squares of the distances
//! from some points of the side; then the distance of both curves is bounded, and where the bound is too large the interval
//! is halved.

use super::section::{CHEBYSHEV_NODES, Compared, Disc, SectionEvaluator, SideInterval};
use super::side_bound::{Pair, SideBound, foot_step};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::spline::spline_builder::SplineBuilder;
use casteljau_kernels::bernstein::derivatives::cubic_with_derivative;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use casteljau_kernels::spline::handles::{HandleEquations, MAX_ROUNDS, MIN_DAMPING};
use glam::DVec2;

/// Maximum depth of halvings of a side: a limit for the recursion; its work has one of its own.
const MAX_DEPTH: usize = 40;

/// Maximum number of attempted cubics for one side of a section.
const MAX_STEPS: usize = 1 << 17;

/// The part of the tolerance that is allowed at the compared points; the rest is for the points between them.
const COMPARED_PART: f64 = 0.9;

/// A side is straight if it is this close to its chord, as a part of the tolerance.
const STRAIGHT_PART: f64 = 1.0 / 1024.0;

/// The sides of a stroke thinner than this part of the tolerance may cross at the compared points.
const CROSSING_PART: f64 = 1e-6;

/// One side of a section of varying radius, for its approximation by cubics.
pub(super) struct SideFit<'a> {
    pub(super) evaluator: &'a SectionEvaluator<'a>,
    pub(super) side: f64,
    pub(super) tolerance: f64,
    /// −1 where the side runs backwards.
    pub(super) sign: f64,
}

impl SideFit<'_> {
    /// Appends cubics along an interval to a chain that ends at its start.
    pub(super) fn add(&self, run: &SideInterval, chain: &mut SplineBuilder) -> Result<(), Error> {
        let mut work = WorkLimit::new(MAX_STEPS);
        self.add_between(run.span, run.ends, MAX_DEPTH, chain, &mut work);
        Error::unless_within("steps of a stroke", &work)
    }

    fn add_between(
        &self,
        [a, b]: [f64; 2],
        ends: [Disc; 2],
        halvings: usize,
        chain: &mut SplineBuilder,
        work: &mut WorkLimit,
    ) {
        let inside = &self.evaluator.compared([a, b]);
        let [start, end] = ends.map(|disc| disc.point(self.side));
        let pairs = |us: Compared<f64>| {
            let mut pairs = [Pair {
                u: 0.0,
                t: a,
                disc: ends[0],
            }; CHEBYSHEV_NODES.len() + 2];
            for (k, pair) in pairs[1..].iter_mut().enumerate() {
                *pair = match inside.get(k) {
                    Some(&disc) => Pair {
                        u: us[k],
                        t: a + (b - a) * CHEBYSHEV_NODES[k],
                        disc,
                    },
                    None => Pair {
                        u: 1.0,
                        t: b,
                        disc: ends[1],
                    },
                };
            }
            pairs
        };
        let holds = |[b, c]: [DVec2; 2], us: Compared<f64>| {
            let bound = SideBound {
                evaluator: self.evaluator,
                side: self.side,
                sign: self.sign,
                tolerance: self.tolerance,
                cubic: [start, b, c, end],
            };
            bound.is_proved(&pairs(us))
        };
        if let Some(us) = self.along_chord(start, end, inside)
            && holds([1.0, 2.0].map(|k| start + (end - start) * (k / 3.0)), us)
        {
            return chain.connect_to(end);
        }
        if let Some((handles, us)) = self.handles(&ends, inside)
            && holds(handles, us)
        {
            return chain.cubic_to([handles[0], handles[1], end]);
        }
        if halvings == 0 || !work.spend(1) {
            return chain.connect_to(end);
        }
        let middle = 0.5 * (a + b);
        let between = self.evaluator.at(middle);
        let halves = [
            ([a, middle], [ends[0], between]),
            ([middle, b], [between, ends[1]]),
        ];
        for (interval, ends) in halves {
            self.add_between(interval, ends, halvings - 1, chain, work);
        }
    }

    /// The parameters of the compared points on the chord, if they are next to it and in order.
    fn along_chord(
        &self,
        start: DVec2,
        end: DVec2,
        inside: &Compared<Disc>,
    ) -> Option<Compared<f64>> {
        let chord = end - start;
        let length = Point::norm(chord);
        let max = STRAIGHT_PART * self.tolerance;
        let mut us = CHEBYSHEV_NODES;
        let mut last = 0.0;
        for (u, disc) in us.iter_mut().zip(inside) {
            let gap = disc.point(self.side) - start;
            // A chord without length has no direction.
            if length <= max {
                if Point::norm(gap) > max {
                    return None;
                }
                continue;
            }
            let along = gap.dot(chord) / length;
            if gap.perp_dot(chord).abs() > max * length
                || along < last - max
                || along > length + max
            {
                return None;
            }
            last = along.clamp(last, length);
            *u = last / length;
        }
        Some(us)
    }

    /// The inner control points of the cubic with the same ends and end directions that has the least squares of the
    /// distances at the compared points, and their parameters; `None` if one of the distances is too large.
    fn handles(
        &self,
        ends: &[Disc; 2],
        inside: &Compared<Disc>,
    ) -> Option<([DVec2; 2], Compared<f64>)> {
        let [start, end] = ends.map(|disc| disc.point(self.side));
        let [d0, d1] = ends.map(|disc| disc.forward(self.side) * self.sign);
        let points = inside.map(|disc| disc.point(self.side));
        let mut us = [0.0; CHEBYSHEV_NODES.len()];
        let mut length = 0.0;
        for (k, &p) in points.iter().enumerate() {
            length += Point::norm(p - if k == 0 { start } else { points[k - 1] });
            us[k] = length;
        }
        length += Point::norm(end - points[CHEBYSHEV_NODES.len() - 1]);
        us.iter_mut().for_each(|u| *u /= length);
        let mut worst = f64::INFINITY;
        let thirds = [length / 3.0; 2];
        let cubic_with = |[a, b]: [f64; 2]| [start, start + d0 * a, end - d1 * b, end];
        let mut arms = thirds;
        for _ in 0..MAX_ROUNDS {
            let changes = self.changes(&cubic_with(arms), [d0, d1], inside, &us);
            arms = [arms[0] + changes[0], arms[1] + changes[1]];
            // Handles that point backwards or are longer than the side could make a loop.
            if !arms.iter().all(|arm| (0.0..=length).contains(arm)) {
                arms = thirds;
            }
            let cubic = cubic_with(arms);
            let before = worst;
            worst = 0.0;
            let mut last = 0.0;
            for (k, &p) in points.iter().enumerate() {
                for _ in 0..2 {
                    us[k] = foot_step(&cubic, us[k], p);
                }
                // The sides of a thin stroke must not cross.
                let most = (COMPARED_PART * self.tolerance).min(0.5 * inside[k].radius());
                let off = Point::norm(cubic_with_derivative(&cubic, us[k]).0 - p);
                let distance = off / most.max(CROSSING_PART * self.tolerance);
                // The feet of the points must have their order.
                worst = if us[k] >= last {
                    distance.max(worst)
                } else {
                    f64::INFINITY
                };
                last = us[k];
            }
            if worst <= 1.0 {
                return Some(([cubic[1], cubic[2]], us));
            }
            // The distances fall by less than half: the interval is halved instead.
            if worst > 0.5 * before {
                return None;
            }
        }
        None
    }

    /// The changes of the lengths of both handles with the least squares of the distances at the compared points.
    fn changes(
        &self,
        cubic: &[DVec2; 4],
        [d0, d1]: [DVec2; 2],
        inside: &Compared<Disc>,
        us: &Compared<f64>,
    ) -> [f64; 2] {
        let mut equations = HandleEquations::default();
        for (disc, &u) in inside.iter().zip(us) {
            // Only distances along the normal count, since the parameter may move along the side.
            let normal = disc.normal(self.side);
            let off = cubic_with_derivative(cubic, u).0 - disc.point(self.side);
            equations.add(u, [d0.dot(normal), d1.dot(normal)], off.dot(normal));
        }
        equations.solved(MIN_DAMPING)
    }
}
