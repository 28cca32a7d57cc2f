//! Classification of contact intervals as crossings, tangencies or overlaps.

use super::constants::{
    END_OF_CONTACT, HIDDEN_TURN, MIN_OVERLAP, NEAR_END, ROTATION, TWO_CROSSINGS,
};
use super::contact_interval::ContactInterval;
use super::intersection::IntersectionKind;
use super::pair::{ClassifiedContact, NormalizedPair};
use super::plane_curve::PlaneCurve;
use crate::geometry::point::Point;
use crate::numeric::list::Scalars;
use glam::DVec2;

impl<S: PlaneCurve> NormalizedPair<S> {
    /// Appends the intersections of an interval with their kinds.
    pub(crate) fn classify(
        &self,
        interval: &ContactInterval,
        locations: &mut Vec<ClassifiedContact>,
    ) {
        if interval.crossing {
            let times = self.snapped(interval.ends()[0]);
            return locations.push(ClassifiedContact::new(times, IntersectionKind::Cross));
        }
        if let Some(overlap) = self.overlap(interval) {
            return locations.push(overlap);
        }
        // The parameter of an end or a zero of B′ is known, so it is preferred to other points of the interval.
        if let Some((t, u)) = self.end_in(interval) {
            return locations.push(self.with_kind(t, u));
        }
        let middle = (
            0.5 * (interval.t[0] + interval.t[1]),
            0.5 * (interval.u[0] + interval.u[1]),
        );
        if let Some(times) = self
            .tangency(middle)
            .filter(|&location| interval.contains(location))
        {
            return locations.push(ClassifiedContact::new(times, IntersectionKind::Tangent));
        }
        let crossing = |location| {
            self.crossing(location)
                .filter(|&location| interval.contains(location))
        };
        // Newton's method from both ends of the interval finds two crossings that are too close for the search, or one.
        match self.paired(interval).map(crossing) {
            [Some(p), Some(q)] if (p.0 - q.0).abs() + (p.1 - q.1).abs() > TWO_CROSSINGS => {
                let cross = |times| ClassifiedContact::new(times, IntersectionKind::Cross);
                locations.extend([p, q].map(cross));
            }
            [Some((t, u)), _] | [None, Some((t, u))] => locations.push(self.with_kind(t, u)),
            // A contact of higher order, or a cusp, that Newton's method does not refine.
            [None, None] => {
                let (t, u) = self.project_onto_b(middle.0, middle.1);
                if self.coincide((t, u)) {
                    locations.push(self.with_kind(t, u));
                }
            }
        }
    }

    /// Moves each parameter to an end of its curve if only rounding separates the two points.
    pub(crate) fn snapped(&self, (t, u): (f64, f64)) -> (f64, f64) {
        let snapped = |curve: usize, t: f64| {
            let end = t.round();
            if t == end || (t - end).abs() > NEAR_END {
                return t;
            }
            let apart = (self.point(curve, t) - self.point(curve, end)).max_abs();
            if apart <= self.slack { end } else { t }
        };
        (snapped(0, t), snapped(1, u))
    }

    /// The ends of an interval. If the interval is too small for a known direction, the pairing with the smaller
    /// distances.
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

    /// An interval is an overlap if it has a length and if each of its ends is at an end of a curve.
    fn overlap(&self, interval: &ContactInterval) -> Option<ClassifiedContact> {
        if !(self.is_long(0, interval.t) && self.is_long(1, interval.u)) {
            return None;
        }
        let [start, end] = self
            .paired(interval)
            .map(|location| self.at_end(interval, self.snapped(location)));
        let (start @ (t, u), (t_end, u_end)) = (start?, end?);
        let shared = self.is_long(0, [t, t_end])
            && self.is_long(1, [u, u_end])
            && self.have_equal_boxes([t, t_end], [u, u_end], |_| 0.0);
        let kind = IntersectionKind::Overlap { t_end, u_end };
        shared.then_some(ClassifiedContact::new(start, kind))
    }

    /// Whether a segment of a curve is longer than the effect of rounding.
    fn is_long(&self, curve: usize, [from, to]: [f64; 2]) -> bool {
        let start = self.point(curve, from);
        // The end alone is not enough: the segment may return to its start.
        [0.25, 0.5, 0.75, 1.0].iter().any(|&part| {
            let t = from + part * (to - from);
            (self.point(curve, t) - start).max_abs() > MIN_OVERLAP * self.slack
        })
    }

    /// The intersection at an end of a curve, refined on the other curve; `None` if no end of a curve lies on the other
    /// curve.
    fn at_end(&self, interval: &ContactInterval, location: (f64, f64)) -> Option<(f64, f64)> {
        let both = |&(t, u): &(f64, f64)| self.ends(0).contains(&t) && self.ends(1).contains(&u);
        let met = |&(t, u): &(f64, f64)| self.apart(t, u) <= END_OF_CONTACT * self.slack;
        let first = Some(location).filter(both);
        let mut all = first
            .into_iter()
            .chain(self.opposite_ends(interval, location));
        all.find(met)
    }

    /// Candidates for the intersection at an end of a curve, which is at `t` or at `u`.
    ///
    /// The interval may be longer than the overlap: where both curves are straight, gaps between contacts are not
    /// detected. So the search for the nearest point on the other curve also starts at both ends of the interval.
    fn opposite_ends(&self, interval: &ContactInterval, (t, u): (f64, f64)) -> Vec<(f64, f64)> {
        let (t_ends, u_ends) = (self.ends(0), self.ends(1));
        let inside = |x: &f64, [from, to]: [f64; 2]| *x >= from && *x <= to;
        let mut locations = Vec::new();
        if t_ends.contains(&t) {
            locations.extend([u, interval.u[0], interval.u[1]].map(|u| self.project_onto_b(t, u)));
            let zeros = u_ends.iter().filter(|u| inside(u, interval.u));
            locations.extend(zeros.map(|&u| (t, u)));
        }
        if u_ends.contains(&u) {
            locations.extend([t, interval.t[0], interval.t[1]].map(|t| self.project_onto_a(t, u)));
            let zeros = t_ends.iter().filter(|t| inside(t, interval.t));
            locations.extend(zeros.map(|&t| (t, u)));
        }
        locations
    }

    /// The parameters of the start, the end and the zeros of B′.
    fn ends(&self, curve: usize) -> Scalars {
        self.derivative_zeros[curve]
            .iter()
            .copied()
            .chain([0.0, 1.0])
            .collect()
    }

    /// An intersection in the interval at an end of a curve; preferably at ends of both curves.
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
        let on_b = ts.iter().map(|&t| self.project_onto_b(t, middle.1));
        let on_a = us.iter().map(|&u| self.project_onto_a(middle.0, u));
        both.chain(on_b)
            .chain(on_a)
            .find(|&location| self.coincide(location))
    }

    /// The intersection at the given parameters, with its kind.
    pub(crate) fn with_kind(&self, t: f64, u: f64) -> ClassifiedContact {
        ClassifiedContact::new((t, u), self.kind(t, u))
    }

    /// `Tangent` if the directions differ by no more than rounding can rotate them, otherwise `Cross`.
    fn kind(&self, t: f64, u: f64) -> IntersectionKind {
        let [a, b] = [(0, t), (1, u)].map(|(k, t)| {
            let [_, derivative, _] = self.curves[k].jets()(t);
            (self.curves[k].tangent_at(t), 1.0 / Point::norm(derivative))
        });
        // At a zero of the derivative 1/speed is infinite, and `HIDDEN_TURN` is the limit.
        let max_sine = (ROTATION * self.slack * (a.1 + b.1)).min(HIDDEN_TURN);
        let directed = a.0 != DVec2::ZERO && b.0 != DVec2::ZERO;
        if directed && a.0.perp_dot(b.0).abs() <= max_sine {
            IntersectionKind::Tangent
        } else {
            IntersectionKind::Cross
        }
    }
}
