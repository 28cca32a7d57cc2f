//! Final corrections of intersections: makes intersections at ends and zeros of B′ exact, merges intersections that
//! rounding separates, and handles pairs of lines.

use super::constants::{
    CLEAR_HEIGHT, CONTACT, LARGEST_GAP, MIN_OVERLAP, NEARBY_PARAMETERS, SAME_POINT_DISTANCE,
};
use super::intersection::IntersectionKind;
use super::pair::{ClassifiedContact, NormalizedPair, sort};
use super::plane_curve::PlaneCurve;
use crate::geometry::point::Point;
use glam::DVec2;

impl<S: PlaneCurve> NormalizedPair<S> {
    /// Whether both curves are lines of non-zero length.
    pub(crate) fn is_of_lines(&self) -> bool {
        let mut curves = self.curves.iter().map(PlaneCurve::points);
        curves.all(|c| c.len() == 2 && c[0] != c[1])
    }

    /// The intersections of two lines. If they overlap, the ends of the overlap are ends of the lines.
    pub(crate) fn lines(&self) -> Vec<ClassifiedContact> {
        let mut ends: Vec<(f64, f64)> = Vec::with_capacity(4);
        // Collects the ends of each line that lie on the other one.
        for end in [0.0, 1.0] {
            for location in [self.foot(1, end), self.foot(0, end)] {
                if self.coincide(location) {
                    ends.push(location);
                }
            }
        }
        let by_t = |p: &(f64, f64), q: &(f64, f64)| p.0.total_cmp(&q.0);
        let (first, last) = (
            ends.iter().copied().min_by(by_t),
            ends.iter().copied().max_by(by_t),
        );
        if let (Some(first), Some(last)) = (first, last) {
            let long = (self.point(0, last.0) - self.point(0, first.0))
                .abs()
                .max_element();
            if long > MIN_OVERLAP * self.slack {
                let (t_end, u_end) = last;
                let kind = IntersectionKind::Overlap { t_end, u_end };
                return vec![ClassifiedContact::new(first, kind)];
            }
            // Prefer an intersection at ends of both lines.
            let both = |&(t, u): &(f64, f64)| t.fract() == 0.0 && u.fract() == 0.0;
            let (t, u) = ends.iter().copied().find(both).unwrap_or(first);
            return vec![self.with_kind(t, u)];
        }
        self.lines_crossing()
            .map(|times| ClassifiedContact::new(times, IntersectionKind::Cross))
            .into_iter()
            .collect()
    }

    /// The crossing of two lines: the ends of each lie on both sides of the other. A crossing of nearly parallel lines
    /// whose points do not agree up to rounding is discarded.
    fn lines_crossing(&self) -> Option<(f64, f64)> {
        let part = |line: usize| {
            let [ours, other] = [line, 1 - line].map(|k| self.curves[k].points());
            let along = other[1] - other[0];
            let [from, to] = [0, 1].map(|k| (ours[k] - other[0]).perp_dot(along));
            (from * to < 0.0).then(|| from / (from - to))
        };
        let (t, u) = (part(0)?, part(1)?);
        // At a small angle u is inaccurate; the point of B nearest to A(t) may still agree.
        let beside = self.project_onto_b(t, u);
        [(t, u), beside]
            .into_iter()
            .find(|&location| self.coincide(location))
    }

    /// The parameters of an end of the other line and of its nearest point on the line `curve`.
    fn foot(&self, curve: usize, end: f64) -> (f64, f64) {
        let line = self.curves[curve].points();
        let along = line[1] - line[0];
        let point = self.point(1 - curve, end);
        let x = ((point - line[0]).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        if curve == 1 {
            self.snapped((end, x))
        } else {
            self.snapped((x, end))
        }
    }

    /// The intersections with exact parameters at ends and zeros of B′, and without duplicates.
    pub(crate) fn snap_and_merge(
        &self,
        mut locations: Vec<ClassifiedContact>,
    ) -> Vec<ClassifiedContact> {
        let mut curves = self.curves.iter().map(PlaneCurve::points);
        if curves.any(|c| c.iter().all(|&p| p == c[0])) {
            return locations; // a point has no ends of its own
        }
        for t in [0.0, 1.0] {
            for u in [0.0, 1.0] {
                // Ends at exactly the same point intersect, even if the search has not found an intersection there.
                if self.point(0, t) == self.point(1, u) {
                    self.merge(&mut locations, (t, u), true);
                }
            }
        }
        for curve in [0, 1] {
            for &zero in &self.derivative_zeros[curve] {
                self.merge_at_derivative_zero(&mut locations, curve, zero);
            }
        }
        sort(&mut locations, |p, q| p.times() < q.times());
        self.merge_continued_crossings(&mut locations);
        locations
    }

    /// Moves the intersections next to a zero of B′ to it. Each of them is processed once: the replacement may be too
    /// far from it on the other curve to remove it.
    fn merge_at_derivative_zero(
        &self,
        locations: &mut Vec<ClassifiedContact>,
        curve: usize,
        zero: f64,
    ) {
        let near = |location: &&ClassifiedContact| {
            location.is_point() && self.is_next_to(curve, location, zero)
        };
        let all: Vec<ClassifiedContact> = locations.iter().filter(near).copied().collect();
        for location in all {
            let tip = if curve == 0 {
                self.project_onto_b(zero, location.u)
            } else {
                self.project_onto_a(location.t, zero)
            };
            if locations.contains(&location) && self.coincide(tip) {
                self.merge(locations, tip, false);
            }
        }
    }

    /// Whether the parameter of an intersection on a curve is next to a given one, but not equal.
    fn is_next_to(&self, curve: usize, location: &ClassifiedContact, at: f64) -> bool {
        let t = if curve == 0 { location.t } else { location.u };
        t != at && self.is_near(curve, t, at)
    }

    fn is_near(&self, curve: usize, t: f64, at: f64) -> bool {
        (t - at).abs() <= NEARBY_PARAMETERS
            && (self.point(curve, t) - self.point(curve, at))
                .abs()
                .max_element()
                <= SAME_POINT_DISTANCE
    }

    /// Replaces the intersections next to (t, u) by one at (t, u). With `always`, inserts it even if none is near,
    /// unless an overlap ends there. Returns whether any were replaced.
    fn merge(
        &self,
        locations: &mut Vec<ClassifiedContact>,
        (t, u): (f64, f64),
        always: bool,
    ) -> bool {
        let near = |(p, q): (f64, f64)| self.is_near(0, p, t) && self.is_near(1, q, u);
        let mut ends_overlap = false;
        for location in locations.iter_mut() {
            let start = location.times();
            let IntersectionKind::Overlap { t_end, u_end } = &mut location.kind else {
                continue;
            };
            // An overlap that is shorter than the distance keeps its two ends.
            if near(start) && *t_end > t && *u_end != u {
                (location.t, location.u, ends_overlap) = (t, u, true);
            } else if near((*t_end, *u_end)) && start.0 < t && start.1 != u {
                (*t_end, *u_end, ends_overlap) = (t, u, true);
            }
        }
        let before = locations.len();
        locations.retain(|location| !(location.is_point() && near(location.times())));
        let replaced = locations.len() < before;
        if !ends_overlap && (replaced || always) {
            let k = locations.partition_point(|location| location.times() < (t, u));
            locations.insert(k, self.with_kind(t, u));
        }
        replaced
    }

    /// Merges consecutive crossings between which the curves are separated only by rounding. The result is a crossing,
    /// or a tangency if the curves are on the same side before and after.
    fn merge_continued_crossings(&self, locations: &mut Vec<ClassifiedContact>) {
        let mut k = 1;
        let mut first = 0;
        // The crossings first … k − 1 are one run: each is continued into the next.
        while k < locations.len() {
            if self.is_continued(locations[k - 1], locations[k]) {
                let (p, q) = (locations[first], locations[k]);
                let run_ends =
                    k + 1 == locations.len() || !self.is_continued(locations[k], locations[k + 1]);
                if run_ends {
                    let times = self.intersection_between(p, q);
                    locations[first] = ClassifiedContact::new(times, self.kind_between(p, q));
                    locations.drain(first + 1..=k);
                    // The crossing after the merged one starts a new run.
                    k = first + 1;
                    first = k;
                    k += 1;
                    continue;
                }
            } else {
                first = k;
            }
            k += 1;
        }
    }

    /// An intersection between two others, if the curves coincide between them. If the curves have different speeds, as
    /// next to a reversal, the mean parameters may not match; then the nearest point of one curve to the other's is
    /// used.
    fn intersection_between(&self, p: ClassifiedContact, q: ClassifiedContact) -> (f64, f64) {
        let middle = (0.5 * (p.t + q.t), 0.5 * (p.u + q.u));
        if self.coincide(middle) {
            return middle;
        }
        [
            self.project_onto_b(middle.0, middle.1),
            self.project_onto_a(middle.0, middle.1),
        ]
        .into_iter()
        .find(|&location| self.coincide(location))
        .unwrap_or(p.times())
    }

    fn is_continued(&self, p: ClassifiedContact, q: ClassifiedContact) -> bool {
        let (gap_t, gap_u) = (q.t - p.t, q.u - p.u);
        // A point that a curve passes twice gives two intersections.
        let apart = (self.point(0, p.t) - self.point(0, q.t)).abs();
        let same = apart.max_element() <= self.slack;
        is_crossing(&p)
            && is_crossing(&q)
            && !(same && gap_t.abs().max(gap_u.abs()) > SAME_POINT_DISTANCE)
            && gap_t.abs() < LARGEST_GAP
            && gap_u.abs() < LARGEST_GAP
            && [0.25, 0.5, 0.75].iter().all(|&part| {
                self.height(p.t + part * gap_t, p.u + part * gap_u) <= CONTACT * self.slack
            })
    }

    /// A crossing if the sides before and after differ, otherwise a tangency.
    fn kind_between(&self, p: ClassifiedContact, q: ClassifiedContact) -> IntersectionKind {
        // The sides are determined outside the run, at first at twice its length in t from its ends.
        let (before, after) = (self.side(p, p.t - q.t), self.side(q, q.t - p.t));
        if before * after > 0.0 {
            IntersectionKind::Tangent
        } else {
            IntersectionKind::Cross
        }
    }

    /// The side of the second curve on which the first one is, at some distance from an intersection; 0 if the curve
    /// ends before the distance exceeds rounding.
    fn side(&self, ClassifiedContact { t, u, .. }: ClassifiedContact, mut step: f64) -> f64 {
        let of_b = self.curves[1].jets();
        loop {
            step *= 2.0;
            let at = t + step;
            if !(0.0..=1.0).contains(&at) || step.abs() > LARGEST_GAP || step == 0.0 {
                return 0.0;
            }
            let (_, u) = self.project_onto_b(at, u);
            let [b, direction, _] = of_b(u);
            let gap: DVec2 = self.point(0, at) - b;
            // The signed distance of A from the tangent of B, positive on its left.
            let height = Point::unit(direction).perp_dot(gap);
            if height.abs() > CLEAR_HEIGHT * self.slack {
                return height.signum();
            }
        }
    }
}

fn is_crossing(location: &ClassifiedContact) -> bool {
    location.kind == IntersectionKind::Cross
}
