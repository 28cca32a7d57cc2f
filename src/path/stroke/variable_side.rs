//! Cubics that approximate one side of a stroke of varying width.

use super::variable_pen::{LEFT, PenAt, RIGHT, SectionEvaluator};
use crate::curve::with_derivatives::CurveWithDerivatives;
use crate::geometry::point::Point;
use crate::numeric::work_limit::WorkLimit;
use crate::spline::spline_builder::SplineBuilder;
use glam::DVec2;

/// Maximum depth of halvings of a side.
pub(super) const MAX_HALVINGS: usize = 40;

/// The parameters at which a cubic is compared with the side, as parts of an interval: Chebyshev points, which are dense
/// at the ends, where a side may start with a high speed.
const COMPARED: [f64; 8] = [
    0.0096, 0.0843, 0.2222, 0.4025, 0.5975, 0.7778, 0.9157, 0.9904,
];

/// The cosine of the largest turn of a side between two of these points.
const MAX_TURN: f64 = 0.8;

/// The part of the tolerance that is allowed at these points; the rest is for the points between them.
const COMPARED_PART: f64 = 0.75;

/// A side is straight if it is this close to its chord, as a part of the tolerance.
const STRAIGHT_PART: f64 = 1.0 / 1024.0;

/// Rounds of least squares for the handles of a cubic, each with parameters nearer to the compared points.
const FIT_ROUNDS: usize = 4;

/// Maximum depth of halvings of the curve about which the normals of a side turn.
const MAX_PIVOT_HALVINGS: usize = 8;

/// Appends a line unless it has no length.
pub(super) fn push_line(chain: &mut SplineBuilder, to: DVec2) {
    if chain.points.last() != Some(&to) {
        chain.line_to(to);
    }
}

impl SectionEvaluator<'_> {
    /// The pens with which a cubic is compared in an interval.
    pub(super) fn inside(&self, [a, b]: [f64; 2]) -> [PenAt; COMPARED.len()] {
        COMPARED.map(|part| self.at(a + (b - a) * part))
    }
}

/// One side of a section, for its approximation by cubics.
pub(super) struct SideFit<'a> {
    pub(super) evaluator: &'a SectionEvaluator<'a>,
    pub(super) side: f64,
    /// −1 where the side runs backwards.
    pub(super) sign: f64,
    pub(super) tolerance: f64,
}

impl SideFit<'_> {
    /// Appends cubics for an interval, from the point of the side at its start; `inside` are the pens to compare with.
    pub(super) fn add(
        &self,
        [a, b]: [f64; 2],
        ends: [PenAt; 2],
        inside: &[PenAt; COMPARED.len()],
        halvings: usize,
        chain: &mut SplineBuilder,
        work: &mut WorkLimit,
    ) {
        let end = ends[1].point(self.side);
        if self.is_sampled(&ends, inside) {
            if self.is_straight(&ends, inside) {
                return push_line(chain, end);
            }
            if let Some([b, c]) = self.handles(&ends, inside) {
                chain.points.extend([b, c, end]);
                chain.degrees.push(3);
                return;
            }
        }
        if halvings == 0 || !work.spend(1) {
            return push_line(chain, end);
        }
        let middle = 0.5 * (a + b);
        let between = self.evaluator.at(middle);
        let halves = [
            ([a, middle], [ends[0], between]),
            ([middle, b], [between, ends[1]]),
        ];
        for (interval, ends) in halves {
            let inside = self.evaluator.inside(interval);
            self.add(interval, ends, &inside, halvings - 1, chain, work);
        }
    }

    /// Whether the normal turns little between the compared points, so that they show all of the side.
    fn is_sampled(&self, ends: &[PenAt; 2], inside: &[PenAt]) -> bool {
        let mut last = &ends[0];
        inside.iter().chain([&ends[1]]).all(|pen| {
            let [a, b] = [last, pen].map(|pen| pen.normal(self.side));
            last = pen;
            let is_small = Point::norm(a - b) * pen.radius <= STRAIGHT_PART * self.tolerance;
            is_small || a.dot(b) >= MAX_TURN
        })
    }

    /// Whether the side is next to its chord, in order.
    fn is_straight(&self, ends: &[PenAt; 2], inside: &[PenAt]) -> bool {
        let [start, end] = ends.map(|pen| pen.point(self.side));
        let chord = end - start;
        let length = Point::norm(chord);
        let max = STRAIGHT_PART * self.tolerance;
        let mut along = -max;
        inside.iter().all(|pen| {
            let gap = pen.point(self.side) - start;
            if length <= max {
                return Point::norm(gap) <= max;
            }
            let last = along;
            along = gap.dot(chord) / length;
            gap.perp_dot(chord).abs() <= max * length
                && along >= last - max
                && along <= length + max
        })
    }

    /// The inner control points of the cubic with the same ends and end directions that has the least squares of the
    /// distances at the compared points; `None` if one of these is too large.
    fn handles(&self, ends: &[PenAt; 2], inside: &[PenAt; COMPARED.len()]) -> Option<[DVec2; 2]> {
        let [start, end] = ends.map(|pen| pen.point(self.side));
        let [d0, d1] = ends.map(|pen| pen.forward(self.side) * self.sign);
        let points = inside.map(|pen| pen.point(self.side));
        let mut ts = [0.0; COMPARED.len()];
        let mut length = 0.0;
        for (k, &p) in points.iter().enumerate() {
            length += Point::norm(p - if k == 0 { start } else { points[k - 1] });
            ts[k] = length;
        }
        length += Point::norm(end - points[COMPARED.len() - 1]);
        ts.iter_mut().for_each(|t| *t /= length);
        let mut worst = f64::INFINITY;
        let mut handles = [start, end];
        for _ in 0..FIT_ROUNDS {
            let arms = self.arms([start, end], [d0, d1], inside, &points, &ts, length);
            handles = [start + d0 * arms[0], end - d1 * arms[1]];
            let cubic = [start, handles[0], handles[1], end];
            let with = CurveWithDerivatives::new(&cubic);
            let before = worst;
            worst = 0.0;
            let mut last = 0.0;
            for (k, &p) in points.iter().enumerate() {
                for _ in 0..2 {
                    let [q, first, _] = with.jet(ts[k]);
                    let step = (q - p).dot(first) / first.dot(first);
                    if step.is_finite() {
                        ts[k] = (ts[k] - step).clamp(0.0, 1.0);
                    }
                }
                // The sides of a thin stroke must not cross.
                let most = (COMPARED_PART * self.tolerance).min(0.5 * inside[k].radius);
                let distance =
                    Point::norm(with.at(ts[k]) - p) / most.max(STRAIGHT_PART * self.tolerance);
                // The feet of the points must have their order.
                worst = if ts[k] >= last {
                    distance.max(worst)
                } else {
                    f64::INFINITY
                };
                last = ts[k];
            }
            if worst <= 1.0 {
                return Some(handles);
            }
            if worst > 0.5 * before {
                return None;
            }
        }
        (worst <= 1.0).then_some(handles)
    }

    /// The lengths of both handles.
    fn arms(
        &self,
        [start, end]: [DVec2; 2],
        [d0, d1]: [DVec2; 2],
        inside: &[PenAt; COMPARED.len()],
        points: &[DVec2; COMPARED.len()],
        ts: &[f64; COMPARED.len()],
        length: f64,
    ) -> [f64; 2] {
        let (mut aa, mut ab, mut bb, mut ar, mut br) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (k, pen) in inside.iter().enumerate() {
            let (t, normal) = (ts[k], pen.normal(self.side));
            let u = 1.0 - t;
            let (w1, w2) = (3.0 * u * u * t, 3.0 * u * t * t);
            let fixed = start * (u * u * u + w1) + end * (t * t * t + w2);
            let (a, b) = (w1 * d0.dot(normal), -w2 * d1.dot(normal));
            let rest = (points[k] - fixed).dot(normal);
            aa += a * a;
            ab += a * b;
            bb += b * b;
            ar += a * rest;
            br += b * rest;
        }
        let det = aa * bb - ab * ab;
        let arms = [(bb * ar - ab * br) / det, (aa * br - ab * ar) / det];
        let is_plain = |arm: f64| (0.0..=length).contains(&arm);
        if det > 1e-9 * aa * bb && arms.iter().all(|&arm| is_plain(arm)) {
            return arms;
        }
        [length / 3.0; 2]
    }

    /// Completes the contour of what the side sweeps backwards, which starts as the side itself: along the points about
    /// which the chord of both sides turns, back to the start.
    pub(super) fn close_fold(&self, [a, b]: [f64; 2], fold: &mut SplineBuilder) {
        let start = fold.points[0];
        let [from, to] = [b, a].map(|t| self.pivot(t));
        fold.line_to(from);
        self.add_pivots([b, a], [from, to], MAX_PIVOT_HALVINGS, fold);
        fold.line_to(start);
        if self.side == RIGHT {
            fold.points.reverse();
            fold.degrees.reverse();
        }
    }

    /// The point of the chord between both sides that moves along the chord.
    fn pivot(&self, t: f64) -> DVec2 {
        let (pen, [_, left, right]) = self.evaluator.evaluate(t);
        let [own, other] = [self.side, -self.side].map(|side| pen.point(side));
        let (ahead, beyond) = if self.side == LEFT {
            (left, right)
        } else {
            (right, left)
        };
        let part = ahead / (ahead - beyond);
        own + (other - own) * if part > 0.0 { part.min(1.0) } else { 0.0 }
    }

    fn add_pivots(
        &self,
        [a, b]: [f64; 2],
        [from, to]: [DVec2; 2],
        halvings: usize,
        fold: &mut SplineBuilder,
    ) {
        let middle = 0.5 * (a + b);
        let between = self.pivot(middle);
        let is_close = Point::norm(between - (from + to) * 0.5) <= 0.5 * self.tolerance;
        if halvings == 0 || is_close && halvings < MAX_PIVOT_HALVINGS {
            return fold.line_to(to);
        }
        self.add_pivots([a, middle], [from, between], halvings - 1, fold);
        self.add_pivots([middle, b], [between, to], halvings - 1, fold);
    }
}
