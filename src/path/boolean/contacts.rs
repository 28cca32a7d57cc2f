//! The contacts of all segments: crossings, tangencies and ends of overlaps, and ends of segments next to others.

use super::box_tree::BoxTree;
use super::segments::{Segment, Segments};
use crate::curve::Curve;
use crate::curve::intersect::IntersectionKind;
use crate::curve::nearest::nearest_on;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::work_limit::WorkLimit;
use glam::DVec2;

/// The steps of the search for contacts: for each segment, and in addition for any number of them. A comparison of two
/// boxes is one step, the examination of a segment [`SEGMENT_STEPS`](super::box_tree::SEGMENT_STEPS). Outlines of fonts and maps need fewer than
/// 2,000 for each segment.
const STEPS_PER_SEGMENT: usize = 1 << 13;
const FURTHER_STEPS: usize = 1 << 26;

/// The largest number of contacts that one operation finds.
const MAX_CONTACTS: usize = 1 << 24;

/// A point where two segments meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    /// The segments and the parameters on them.
    pub(super) places: [(usize, f64); 2],
    /// The distance of an end of the first segment from the second one; 0 for an intersection.
    pub(super) gap: f64,
}

/// Finds all contacts.
///
/// # Errors
/// [`Error::TooMany`] if there are more than 2²⁴ contacts, or too many pairs of segments that might have some.
pub(super) fn contacts(segments: &Segments, tree: &BoxTree) -> Result<Vec<Contact>, Error> {
    let mut found = Vec::new();
    for index in 0..segments.list.len() {
        self_contacts(segments, index, &mut found);
    }
    let mut work = WorkLimit::new(FURTHER_STEPS + STEPS_PER_SEGMENT * segments.list.len());
    tree.pairs(&mut work, |a, b| {
        let (a, b) = (a.min(b), a.max(b));
        if found.len() <= MAX_CONTACTS {
            pair_contacts(segments, a, b, &mut found);
        }
    });
    near_crossings(segments, tree, &mut work, &mut found);
    if work.is_exceeded() || found.len() > MAX_CONTACTS {
        return Err(Error::TooMany {
            what: "contacts",
            limit: MAX_CONTACTS,
            needed: MAX_CONTACTS + 1,
        });
    }
    Ok(found)
}

/// Adds the contacts of crossings with further segments that pass within epsilon of them.
fn near_crossings(
    segments: &Segments,
    tree: &BoxTree,
    work: &mut WorkLimit,
    found: &mut Vec<Contact>,
) {
    for k in 0..found.len() {
        let [(i, t), (j, u)] = found[k].places;
        if t == 0.0 || t == 1.0 || u == 0.0 || u == 1.0 {
            continue; // The end of a segment is compared with all others.
        }
        let p = segments.list[i].at(t);
        tree.around_point(p, work, |other| {
            if other != i && other != j && found.len() <= MAX_CONTACTS {
                point_contact(segments, (i, t), p, other, found);
            }
        });
    }
}

fn self_contacts(segments: &Segments, index: usize, found: &mut Vec<Contact>) {
    let points = &segments.list[index].points;
    if points.len() < 4 {
        return;
    }
    let all = Curve::from_slice(points).self_intersections();
    found.extend(all.into_iter().map(|at| Contact {
        places: [(index, at.t), (index, at.u)],
        gap: 0.0,
    }));
}

fn pair_contacts(segments: &Segments, i: usize, j: usize, found: &mut Vec<Contact>) {
    let (a, b) = (&segments.list[i], &segments.list[j]);
    let epsilon = segments.epsilon;
    if is_beside(&a.points, &b.points, epsilon) || is_beside(&b.points, &a.points, epsilon) {
        return;
    }
    let before = a.ends[1] == b.ends[0];
    let after = b.ends[1] == a.ends[0];
    if before && !after && runs_on(a, b) || after && !before && runs_on(b, a) {
        return;
    }
    if !after {
        end_contact(segments, i, j, found);
    }
    if !before {
        end_contact(segments, j, i, found);
    }
    for at in Curve::from_slice(&a.points).intersections(&Curve::from_slice(&b.points)) {
        let mut push = |t, u| {
            found.push(Contact {
                places: [(i, t), (j, u)],
                gap: 0.0,
            });
        };
        push(at.t, at.u);
        if let IntersectionKind::Overlap { t_end, u_end } = at.kind {
            push(t_end, u_end);
        }
    }
}

/// Whether all of `b` is farther than epsilon from the strip along the chord of `a` that contains `a`.
fn is_beside(a: &[DVec2], b: &[DVec2], epsilon: f64) -> bool {
    let (start, chord) = (a[0], a[a.len() - 1] - a[0]);
    let margin = epsilon * (chord.x.abs() + chord.y.abs());
    let range = |points: &[DVec2]| {
        let heights = points.iter().map(|&p| chord.perp_dot(p - start));
        crate::numeric::order::range(heights)
    };
    let ((min_a, max_a), (min_b, max_b)) = (range(a), range(b));
    min_b > max_a + margin || max_b < min_a - margin
}

/// Whether two consecutive segments lie on different sides of a line through their joint, and so meet only there.
fn runs_on(a: &Segment, b: &Segment) -> bool {
    let joint = b.start();
    let before = Point::normalize_or_zero(joint - a.points[a.points.len() - 2]);
    let after = Point::normalize_or_zero(b.points[1] - joint);
    let whole =
        Point::normalize_or_zero(joint - a.start()) + Point::normalize_or_zero(b.end() - joint);
    [whole, before + after].iter().any(|direction| {
        a.points[..a.points.len() - 1]
            .iter()
            .all(|&p| direction.dot(joint - p) > 0.0)
            && b.points[1..]
                .iter()
                .all(|&p| direction.dot(p - joint) > 0.0)
    })
}

/// The contacts of the start of segment i with segment j, if it is within epsilon of it; its end is the start of the
/// next segment.
fn end_contact(segments: &Segments, i: usize, j: usize, found: &mut Vec<Contact>) {
    let a = &segments.list[i];
    point_contact(segments, (i, 0.0), a.start(), j, found);
    if a.is_last {
        point_contact(segments, (i, 1.0), a.end(), j, found);
    }
}

/// The contact of a point of a segment with segment j, if it is within epsilon of it.
fn point_contact(
    segments: &Segments,
    place: (usize, f64),
    p: DVec2,
    j: usize,
    found: &mut Vec<Contact>,
) {
    let (b, epsilon) = (&segments.list[j], segments.epsilon);
    if (b.bounds.min - p).max(p - b.bounds.max).max_element() > epsilon
        || is_beside(&b.points, &[p], epsilon)
    {
        return;
    }
    let (u, gap) = if p == b.start() {
        (0.0, 0.0)
    } else if p == b.end() {
        (1.0, 0.0)
    } else {
        let nearest = nearest_on(&b.points, p);
        (nearest.t, nearest.distance)
    };
    if gap <= epsilon {
        found.push(Contact {
            places: [place, (j, u)],
            gap,
        });
    }
}
