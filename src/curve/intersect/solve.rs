//! The complete intersection of a pair of curves: search, classification, removal of duplicates.

use super::constants::{ONE_PARAMETER, TWO_CROSSINGS};
use super::contact_interval::joined;
use super::intersection::IntersectionKind;
use super::pair::{ClassifiedContact, NormalizedPair, sort};
use super::plane_curve::PlaneCurve;
use crate::bernstein::roots::DOUBLE_ROOT;
use casteljau_kernels::curve::intersect::clipping::Contact;

impl<S: PlaneCurve> NormalizedPair<S> {
    /// All intersections of the curves, in order, and the number of steps of the search.
    pub(crate) fn solve(&self) -> (Vec<ClassifiedContact>, usize) {
        if self.is_of_lines() {
            return (self.lines(), 0);
        }
        let (contacts, steps) = self.contacts();
        (self.snap_and_merge(self.locations(contacts)), steps)
    }

    /// All contacts of the curves, and the number of steps of the search.
    fn contacts(&self) -> (Vec<Contact>, usize) {
        if self.derivative_zeros.iter().all(|zeros| zeros.is_empty()) {
            S::search(
                &self.curves,
                self.slack,
                [&[0.0, 1.0]; 2],
                [(0, 0)].into_iter(),
            )
        } else {
            // The curves are cut at the zeros of B′, so that cusps and reversals are ends of segments.
            let [cuts_a, cuts_b] = self
                .derivative_zeros
                .each_ref()
                .map(|zeros| with_ends(zeros));
            let (n, m) = (cuts_a.len() - 1, cuts_b.len() - 1);
            let pairs = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
            S::search(&self.curves, self.slack, [&cuts_a, &cuts_b], pairs)
        }
    }

    /// The classified intersections of contacts, in order.
    pub(crate) fn locations(&self, found: Vec<Contact>) -> Vec<ClassifiedContact> {
        let mut locations = Vec::with_capacity(found.len());
        if found.iter().all(|contact| contact.crossing) {
            let snap = |contact: &Contact| self.snapped((contact.t[0], contact.u[0]));
            locations.extend(
                found
                    .iter()
                    .map(snap)
                    .map(|times| ClassifiedContact::new(times, IntersectionKind::Cross)),
            );
        } else {
            for interval in joined(self, found) {
                self.classify(&interval, &mut locations);
            }
        }
        sorted_distinct(locations)
    }
}

/// The intersections sorted by t, then by u, with parameters that differ by rounding made equal, and without
/// duplicates.
fn sorted_distinct(mut locations: Vec<ClassifiedContact>) -> Vec<ClassifiedContact> {
    sort(&mut locations, |p, q| p.t < q.t);
    // If two t differ only by rounding, u decides their order.
    for k in 1..locations.len() {
        if locations[k].t - locations[k - 1].t <= ONE_PARAMETER {
            locations[k].t = locations[k - 1].t;
        }
    }
    sort(&mut locations, |p, q| p.times() < q.times());
    let mut kept: Vec<ClassifiedContact> = Vec::with_capacity(locations.len());
    for &location in &locations {
        // An intersection at a cut may be found in the segments on both sides.
        let again = kept
            .iter()
            .rev()
            .any(|q| near(location, q.times(), TWO_CROSSINGS) && q.is_point());
        if !(location.is_point() && (again || is_end_of_overlap(location, &locations))) {
            kept.push(location);
        }
    }
    kept
}

fn near(p: ClassifiedContact, (t, u): (f64, f64), within: f64) -> bool {
    (p.t - t).abs() <= within && (p.u - u).abs() <= within
}

/// Whether an intersection is an end of an overlap.
fn is_end_of_overlap(location: ClassifiedContact, all: &[ClassifiedContact]) -> bool {
    all.iter().any(|q| {
        let IntersectionKind::Overlap { t_end, u_end } = q.kind else {
            return false;
        };
        near(location, q.times(), DOUBLE_ROOT) || near(location, (t_end, u_end), DOUBLE_ROOT)
    })
}

/// The given parameters with 0 and 1 added: the ends of the segments between them.
fn with_ends(inside: &[f64]) -> Vec<f64> {
    let mut all = vec![0.0];
    all.extend(inside);
    all.push(1.0);
    all
}
