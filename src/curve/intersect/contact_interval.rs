//! Contact intervals: contacts that belong together, joined.

use super::constants::{
    CONTACT, LARGEST_GAP, MANY_DOUBLE_ROOTS, MAX_CURVING, MIN_OVERLAP, ONE_CROSSING,
    ONE_END_OF_CONTACTS,
};
use super::pair::NormalizedPair;
use super::plane_curve::PlaneCurve;
use crate::bernstein::roots::DOUBLE_ROOT;
use crate::geometry::point::Point;
use crate::numeric::sort::sort_by;
use casteljau_kernels::curve::intersect::clipping::Contact;

/// A parameter interval on which two curves cannot be distinguished.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContactInterval {
    pub(crate) t: [f64; 2],
    /// The smallest and the largest parameter on the second curve.
    pub(crate) u: [f64; 2],
    /// 1 if u increases with t, −1 if it decreases, 0 if unknown.
    pub(crate) direction: f64,
    /// Whether the interval is only one crossing.
    pub(crate) crossing: bool,
    /// The last contact that was joined to the interval.
    last: Contact,
}

impl ContactInterval {
    fn new(contact: Contact) -> Self {
        let [u0, u1] = contact.u;
        let wide = contact.t[1] - contact.t[0] > MANY_DOUBLE_ROOTS;
        // signum() of 0 is 1, but a single u has no direction.
        let has_direction = wide && u0 != u1;
        Self {
            t: contact.t,
            u: [u0.min(u1), u0.max(u1)],
            direction: if has_direction {
                (u1 - u0).signum()
            } else {
                0.0
            },
            crossing: contact.crossing,
            last: contact,
        }
    }

    /// Both ends, with u in the order of t.
    pub(crate) fn ends(&self) -> [(f64, f64); 2] {
        let [u0, u1] = self.u;
        if self.direction < 0.0 {
            [(self.t[0], u1), (self.t[1], u0)]
        } else {
            [(self.t[0], u0), (self.t[1], u1)]
        }
    }

    /// Whether an intersection lies in the interval, widened by its width on each side.
    pub(crate) fn contains(&self, (t, u): (f64, f64)) -> bool {
        let within = |[from, to]: [f64; 2], x: f64| {
            let margin = (to - from) + DOUBLE_ROOT;
            x >= from - margin && x <= to + margin
        };
        within(self.t, t) && within(self.u, u)
    }

    /// The ranges of the parameter on the second curve at the start and at the end; the whole range if the direction is
    /// unknown.
    fn edges(&self) -> [[f64; 2]; 2] {
        let [u0, u1] = self.u;
        if self.direction == 0.0 {
            [[u0, u1]; 2]
        } else {
            self.ends().map(|(_, u)| [u, u])
        }
    }

    /// Whether a contact that starts later is a part or a continuation of this one.
    fn continues_into(
        &self,
        pair: &NormalizedPair<impl PlaneCurve>,
        next: &ContactInterval,
    ) -> bool {
        if self.direction * next.direction < 0.0 {
            return false;
        }
        let (t, start) = (next.t[0], next.edges()[0]);
        let Contact {
            t: last_t,
            u: last_u,
            ..
        } = self.last;
        if t < last_t[1] - ONE_END_OF_CONTACTS {
            // Inside the last contact: compare with the corresponding parameter.
            let width = last_u[1] - last_u[0];
            let expected_u = last_u[0] + width * (t - last_t[0]) / (last_t[1] - last_t[0]);
            let max = MAX_CURVING * width * width + DOUBLE_ROOT;
            return distance([expected_u, expected_u], start).abs() <= max;
        }
        let end = self.edges()[1];
        let (gap_t, gap_u) = (t - self.t[1], distance(end, start));
        if gap_t <= ONE_END_OF_CONTACTS && gap_u.abs() <= ONE_END_OF_CONTACTS {
            return true;
        }
        // The end of the range that faces the next contact.
        let from = if gap_u > 0.0 { end[1] } else { end[0] };
        // Neither curve may turn back in the gap, and both must be in contact in it.
        gap_t < LARGEST_GAP
            && gap_u.abs() < LARGEST_GAP
            && !pair.turns_back(0, self.t[1], t)
            && !pair.turns_back(1, from, from + gap_u)
            && [0.25, 0.5, 0.75].iter().all(|&part| {
                pair.height(self.t[1] + part * gap_t, from + part * gap_u) <= CONTACT * pair.slack
            })
            && pair.have_equal_boxes([self.t[1], t], [from, from + gap_u], |size| {
                size + MANY_DOUBLE_ROOTS
            })
    }

    fn join(&mut self, next: &ContactInterval) {
        self.t[1] = self.t[1].max(next.t[1]);
        self.u = [self.u[0].min(next.u[0]), self.u[1].max(next.u[1])];
        if self.direction == 0.0 {
            self.direction = next.direction;
        }
        // The result is only one crossing if both are the same one, found in two segments.
        let one = self.t[1] - self.t[0] <= ONE_CROSSING && self.u[1] - self.u[0] <= ONE_CROSSING;
        self.crossing &= next.crossing && one;
        if next.t[1] > self.last.t[1] {
            self.last = next.last;
        }
    }
}

impl<S: PlaneCurve> NormalizedPair<S> {
    /// Whether a curve moves away between two parameters and turns back. If both curves lie on one line, heights do not
    /// show this, because the height is measured from the tangent.
    fn turns_back(&self, curve: usize, from: f64, to: f64) -> bool {
        let away = |zero: f64, t: f64| {
            let gap = self.point(curve, zero) - self.point(curve, t);
            gap.max_abs() > MIN_OVERLAP * self.slack
        };
        self.derivative_zeros[curve].iter().any(|&zero| {
            let is_between = zero > from.min(to) && zero < from.max(to);
            is_between && away(zero, from) && away(zero, to)
        })
    }
}

/// The signed gap from the first interval to the second; 0 if they overlap.
fn distance(first: [f64; 2], second: [f64; 2]) -> f64 {
    (second[0] - first[1]).max(0.0) + (second[1] - first[0]).min(0.0)
}

/// Sorts the contacts and joins those that belong together.
pub(crate) fn joined(
    pair: &NormalizedPair<impl PlaneCurve>,
    mut contacts: Vec<Contact>,
) -> Vec<ContactInterval> {
    sort_by(&mut contacts, |p, q| {
        p.t[0].total_cmp(&q.t[0]).then(p.u[0].total_cmp(&q.u[0]))
    });
    let mut intervals: Vec<ContactInterval> = Vec::with_capacity(contacts.len());
    for contact in contacts {
        let next = ContactInterval::new(contact);
        let near = intervals.iter().rposition(|interval| {
            next.t[0] - interval.t[1] < LARGEST_GAP && interval.continues_into(pair, &next)
        });
        match near {
            Some(k) => intervals[k].join(&next),
            None => intervals.push(next),
        }
    }
    intervals
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_contact_of_one_parameter_has_no_direction() {
        let direction = |u| {
            let t = [0.0, 0.5];
            let crossing = false;
            ContactInterval::new(Contact { t, u, crossing }).direction
        };
        let directions = [[0.2, 0.3], [0.3, 0.2], [0.3, 0.3]].map(direction);
        assert_eq!(directions, [1.0, -1.0, 0.0]);
    }
}
