//! What is an interval of contact?

use super::super::{Scalars, evaluate};
use super::contact_interval::ContactInterval;
use super::near::taylor;
use super::pair::{ClassifiedPoint, NormalizedPair};
use super::{Curve, IntersectionKind};
use crate::point::Point;
use glam::DVec2;

/// An end is looked for this near to a parameter.
const NEAR_END: f64 = 1e-5;

/// A shared piece is longer than this many times what rounding may move; a shorter one is a point.
const LEAST_OVERLAP: f64 = 64.0;

/// Two crossings in one interval are two if they are farther apart than this.
const TWO_CROSSINGS: f64 = 1e-10;

/// Directions closer than this are equal where rounding hides them: next to cusps, 1e-8 from which they turn by as much.
const HIDDEN_TURN: f64 = 1e-6;

impl NormalizedPair {
    /// Says what an interval is.
    pub(super) fn classify(&self, interval: &ContactInterval, places: &mut Vec<ClassifiedPoint>) {
        if interval.crossing {
            let (t, u) = self.snapped(interval.ends()[0]);
            return places.push((t, u, IntersectionKind::Cross));
        }
        if let Some(overlap) = self.overlap(interval) {
            return places.push(overlap);
        }
        if let Some((t, u)) = self.end_in(interval) {
            return places.push((t, u, self.kind(t, u)));
        }
        let middle = (
            0.5 * (interval.t[0] + interval.t[1]),
            0.5 * (interval.u[0] + interval.u[1]),
        );
        if let Some((t, u)) = self.tangency(middle).filter(|&place| interval.holds(place)) {
            return places.push((t, u, IntersectionKind::Tangent));
        }
        let crossing = |place| self.crossing(place).filter(|&place| interval.holds(place));
        match self.paired(interval).map(crossing) {
            [Some(p), Some(q)] if (p.0 - q.0).abs() + (p.1 - q.1).abs() > TWO_CROSSINGS => {
                places.extend([p, q].map(|(t, u)| (t, u, IntersectionKind::Cross)));
            }
            [Some((t, u)), _] | [None, Some((t, u))] => places.push((t, u, self.kind(t, u))),
            // A contact of higher order, or a cusp, that Newton's method does not sharpen.
            [None, None] => {
                let (t, u) = self.opposite(middle.0, middle.1);
                if self.one((t, u)) {
                    places.push((t, u, self.kind(t, u)));
                }
            }
        }
    }

    /// The same place, at an end where only rounding keeps it from it.
    pub(super) fn snapped(&self, (t, u): (f64, f64)) -> (f64, f64) {
        let snapped = |curve: usize, t: f64| {
            let end = t.round();
            if t == end || (t - end).abs() > NEAR_END {
                return t;
            }
            let points = &self.curves[curve];
            let apart = (evaluate(points, t) - evaluate(points, end)).max_abs();
            if apart <= self.slack { end } else { t }
        };
        (snapped(0, t), snapped(1, u))
    }

    /// The ends of an interval; of one too small to know its direction, as they are closer together.
    fn paired(&self, interval: &ContactInterval) -> [(f64, f64); 2] {
        let ends = interval.ends();
        let crossed = [(ends[0].0, ends[1].1), (ends[1].0, ends[0].1)];
        let apart = |ends: [(f64, f64); 2]| {
            self.apart(ends[0].0, ends[0].1) + self.apart(ends[1].0, ends[1].1)
        };
        if interval.direction == 0.0 && apart(crossed) < apart(ends) {
            crossed
        } else {
            ends
        }
    }

    /// A interval that has a length and ends where a curve does is a shared piece.
    fn overlap(&self, interval: &ContactInterval) -> Option<ClassifiedPoint> {
        let start = evaluate(&self.curves[0], interval.t[0]);
        let long = [0.25, 0.5, 0.75, 1.0].iter().any(|&part| {
            let t = interval.t[0] + part * (interval.t[1] - interval.t[0]);
            (evaluate(&self.curves[0], t) - start).max_abs() > LEAST_OVERLAP * self.slack
        });
        if !long {
            return None;
        }
        let [start, end] = self
            .paired(interval)
            .map(|place| self.at_end(self.snapped(place)));
        let ((t, u), (t_end, u_end)) = (start?, end?);
        Some((t, u, IntersectionKind::Overlap { t_end, u_end }))
    }

    /// A place where a curve ends, made exact on the other; `None` where none does.
    fn at_end(&self, (t, u): (f64, f64)) -> Option<(f64, f64)> {
        let better = |place: (f64, f64)| {
            if self.apart(place.0, place.1) < self.apart(t, u) {
                place
            } else {
                (t, u)
            }
        };
        match (self.ends(0).contains(&t), self.ends(1).contains(&u)) {
            (true, true) => Some((t, u)),
            (true, false) => Some(better(self.opposite(t, u))),
            (false, true) => Some(better(self.across(t, u))),
            (false, false) => None,
        }
    }

    /// Where a curve starts, ends or stops.
    fn ends(&self, curve: usize) -> Scalars {
        self.stops[curve]
            .iter()
            .copied()
            .chain([0.0, 1.0])
            .collect()
    }

    /// A place of the interval where a curve ends: both if there is one.
    fn end_in(&self, interval: &ContactInterval) -> Option<(f64, f64)> {
        let within = |curve: usize, [from, to]: [f64; 2]| -> Scalars {
            let inside = |&t: &f64| t >= from && t <= to;
            self.ends(curve).into_iter().filter(inside).collect()
        };
        let (ts, us) = (within(0, interval.t), within(1, interval.u));
        let middle = (
            0.5 * (interval.t[0] + interval.t[1]),
            0.5 * (interval.u[0] + interval.u[1]),
        );
        let both = ts.iter().flat_map(|&t| us.iter().map(move |&u| (t, u)));
        let on_b = ts.iter().map(|&t| self.opposite(t, middle.1));
        let on_a = us.iter().map(|&u| self.across(middle.0, u));
        both.chain(on_b).chain(on_a).find(|&place| self.one(place))
    }

    /// Tangent where the directions differ by no more than rounding can turn them.
    pub(super) fn kind(&self, t: f64, u: f64) -> IntersectionKind {
        let [a, b] = [(0, t), (1, u)].map(|(k, t)| {
            let points = &self.curves[k];
            let tangent = Curve::from_slice(points).tangent(t);
            (tangent, 1.0 / Point::length(taylor(points, t)[1]))
        });
        let turned = (16.0 * self.slack * (a.1 + b.1)).min(HIDDEN_TURN);
        let directed = a.0 != DVec2::ZERO && b.0 != DVec2::ZERO;
        if directed && a.0.perp_dot(b.0).abs() <= turned {
            IntersectionKind::Tangent
        } else {
            IntersectionKind::Cross
        }
    }
}
