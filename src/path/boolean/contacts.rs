//! The contacts of all segments: crossings, tangencies and ends of overlaps, and ends of segments next to others.

use super::segments::{Segment, Segments};
use crate::curve::Curve;
use crate::curve::intersect::IntersectionKind;
use crate::curve::nearest::nearest_on;
use crate::geometry::bounds::Bounds;
use crate::geometry::box_tree::BoxTree;
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::list::Points;
use crate::numeric::sort::sort_by;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec2;

/// The steps that the search for contacts may take: for each segment and for each contact that is found, and in addition
/// for any number of them. A step is a comparison of two boxes, about 5 ns.
pub(super) const STEPS_PER_ITEM: usize = 1 << 13;
const BASE_STEPS: usize = 1 << 30;

/// The steps of the comparison of two segments whose boxes overlap: whether one is beside the other, the examination of
/// a pair where neither is, and each pair of pieces of two cubics in their search for intersections.
const BESIDE_STEPS: usize = 4;
const PAIR_STEPS: usize = 64;
const CLIPPING_STEPS: usize = 32;

/// The largest number of contacts that one operation finds. The memory of an operation is about 700 bytes for each.
const MAX_CONTACTS: usize = 1 << 22;

/// The number of cuts in each part of a segment in the tree of the search for segments next to crossings.
const CUTS_PER_PART: usize = 4;

/// Crossings in the same square of this width, in parts of epsilon, are at one point: less than the smallest tolerance.
const SAME_POINT_WIDTH: f64 = 1e-6;

/// A point where two segments meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    /// The segments and the parameters on them.
    pub(super) places: [(usize, f64); 2],
    /// The distance of an end of the first segment from the second one; 0 for an intersection.
    pub(super) gap: f64,
}

/// Finds all contacts. The tree has the boxes of the segments, enlarged by epsilon.
///
/// # Errors
/// [`Error::TooMany`] if there are more than 2²² contacts, or too many pairs of segments that might have some.
pub(super) fn contacts(segments: &Segments, tree: &BoxTree) -> Result<Vec<Contact>, Error> {
    let mut found = Vec::new();
    for index in 0..segments.list.len() {
        self_contacts(segments, index, &mut found);
    }
    let mut work = search_limit(segments.list.len());
    tree.pairs_within(&mut work, |a, b, work| {
        let before = found.len();
        let steps = pair_contacts(segments, a.min(b), a.max(b), &mut found);
        // Each contact allows further steps, so the limit stops only searches that find nothing.
        work.raise_limit(STEPS_PER_ITEM, found.len() - before);
        work.count(steps);
        if found.len() > MAX_CONTACTS {
            work.stop();
        }
    });
    near_crossings(segments, &mut work, &mut found);
    common_corners(segments, &mut found);
    if found.len() > MAX_CONTACTS {
        return Err(Error::too_many(
            "contacts of segments",
            MAX_CONTACTS,
            found.len(),
        ));
    }
    Error::unless_within("steps of the search for contacts", &work)?;
    Ok(found)
}

/// The steps that a search among a number of items may take, without those for what it finds.
pub(super) fn search_limit(items: usize) -> WorkLimit {
    let mut work = WorkLimit::new(BASE_STEPS);
    work.raise_limit(STEPS_PER_ITEM, items);
    work
}

/// Adds the contacts of crossings with further segments that pass within epsilon of them.
///
/// The boxes of long segments contain most crossings, so the search is in a tree of parts with few cuts each.
fn near_crossings(segments: &Segments, work: &mut WorkLimit, found: &mut Vec<Contact>) {
    let crossings = crossings_at_different_points(segments, found);
    if crossings.is_empty() {
        return;
    }
    let parts = parts_with_few_cuts(segments, found);
    let boxes: Vec<Bounds<DVec2>> = parts
        .iter()
        .map(|part| {
            Bounds::from_points(&part.points(segments)).enlarged(DVec2::splat(segments.epsilon))
        })
        .collect();
    let tree = BoxTree::new(&boxes);
    let mut seen = Vec::new();
    for k in crossings {
        let [(i, t), (j, _)] = found[k].places;
        let p = segments.list[i].at(t);
        seen.clear();
        seen.extend([i, j]);
        tree.around_point(p, work, |part, work| {
            let other = parts[part].segment;
            if !seen.contains(&other) {
                work.count(BESIDE_STEPS);
                if !is_beside(&parts[part].points(segments), &[p], segments.epsilon) {
                    seen.push(other);
                    work.count(PAIR_STEPS);
                    point_contact(segments, (i, t), p, other, found);
                }
            }
        });
        if work.is_exceeded() || found.len() > MAX_CONTACTS {
            return;
        }
    }
}

/// The indices of the crossings inside both segments, one of those at the same point. Ends of segments are compared
/// with all others, so they are not among them.
fn crossings_at_different_points(segments: &Segments, found: &[Contact]) -> Vec<usize> {
    let width = SAME_POINT_WIDTH * segments.epsilon;
    let is_inside = |(_, t): (usize, f64)| t != 0.0 && t != 1.0;
    let mut keys: Vec<(DVec2, usize)> = Vec::new();
    for (k, contact) in found.iter().enumerate() {
        let [(i, t), _] = contact.places;
        if contact.places.into_iter().all(is_inside) {
            keys.push(((segments.list[i].at(t) / width).floor(), k));
        }
    }
    sort_by(&mut keys, |(p, k), (q, l)| {
        let by_place = p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y));
        by_place.then(k.cmp(l))
    });
    keys.dedup_by_key(|(square, _)| *square);
    keys.into_iter().map(|(_, k)| k).collect()
}

/// A part of a segment.
struct SegmentRange {
    segment: usize,
    t: [f64; 2],
}

impl SegmentRange {
    fn points(&self, segments: &Segments) -> Points<DVec2> {
        segments.part(self.segment, self.t[0], self.t[1])
    }
}

/// The segments in parts with few cuts, if they are not at one point.
fn parts_with_few_cuts(segments: &Segments, found: &[Contact]) -> Vec<SegmentRange> {
    let mut cuts: Vec<(usize, f64)> = Vec::with_capacity(2 * found.len());
    cuts.extend(found.iter().flat_map(|contact| contact.places));
    sort_by(&mut cuts, |a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut parts = Vec::with_capacity(segments.list.len() + cuts.len() / CUTS_PER_PART);
    let mut rest = &cuts[..];
    for (segment, curve) in segments.list.iter().enumerate() {
        let own = rest.iter().take_while(|cut| cut.0 == segment).count();
        let mut from = 0.0;
        let mut start = curve.start();
        for group in rest[..own].chunks_exact(CUTS_PER_PART) {
            let to = group[CUTS_PER_PART - 1].1;
            let end = curve.at(to);
            if to < 1.0 && (end - start).max_abs() > segments.epsilon {
                parts.push(SegmentRange {
                    segment,
                    t: [from, to],
                });
                (from, start) = (to, end);
            }
        }
        parts.push(SegmentRange {
            segment,
            t: [from, 1.0],
        });
        rest = &rest[own..];
    }
    parts
}

/// Adds a contact of each two consecutive ends of noded segments at the same point.
fn common_corners(segments: &Segments, found: &mut Vec<Contact>) {
    let noded = segments.list.iter().enumerate().filter(|(_, s)| s.is_noded);
    let mut ends: Vec<(DVec2, (usize, f64))> = noded
        .flat_map(|(k, s)| [(s.start(), (k, 0.0)), (s.end(), (k, 1.0))])
        .collect();
    sort_by(&mut ends, |(p, a), (q, b)| {
        let by_place = p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y));
        by_place.then(a.0.cmp(&b.0)).then(a.1.total_cmp(&b.1))
    });
    let same = ends.windows(2).filter(|pair| pair[0].0 == pair[1].0);
    found.extend(same.map(|pair| Contact {
        places: [pair[0].1, pair[1].1],
        gap: 0.0,
    }));
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

/// Adds the contacts of two segments, and returns the number of steps.
fn pair_contacts(segments: &Segments, i: usize, j: usize, found: &mut Vec<Contact>) -> usize {
    let (a, b) = (&segments.list[i], &segments.list[j]);
    let epsilon = segments.epsilon;
    // Their common ends are found by `common_corners`.
    if a.is_noded && b.is_noded {
        return BESIDE_STEPS;
    }
    if is_beside(&a.points, &b.points, epsilon) || is_beside(&b.points, &a.points, epsilon) {
        return BESIDE_STEPS;
    }
    // Consecutive segments of an outline have a joint in common, which is a vertex without a contact.
    let before = a.ends[1] == b.ends[0];
    let after = b.ends[1] == a.ends[0];
    if before && !after && meet_only_at_joint(a, b) || after && !before && meet_only_at_joint(b, a)
    {
        return BESIDE_STEPS;
    }
    if !after {
        end_contact(segments, i, j, found);
    }
    if !before {
        end_contact(segments, j, i, found);
    }
    let (a, b) = (Curve::from_slice(&a.points), Curve::from_slice(&b.points));
    let (intersections, steps) = a.intersections_and_steps(&b);
    for at in intersections {
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
    // The time of a step of clipping grows with the square of the degree; CLIPPING_STEPS is that of cubics.
    let degree = a.degree().max(b.degree()).max(3);
    PAIR_STEPS + steps * CLIPPING_STEPS * degree * degree / 9
}

/// Whether all of `b` is farther than epsilon from the strip along the chord of `a` that contains `a`.
fn is_beside(a: &[DVec2], b: &[DVec2], epsilon: f64) -> bool {
    let (start, chord) = (a[0], a[a.len() - 1] - a[0]);
    // Heights are distances times |chord|, which is at most |x| + |y|.
    let margin = epsilon * (chord.x.abs() + chord.y.abs());
    let range = |points: &[DVec2]| {
        let heights = points.iter().map(|&p| chord.perp_dot(p - start));
        casteljau_kernels::numeric::order::range(heights)
    };
    let ((min_a, max_a), (min_b, max_b)) = (range(a), range(b));
    min_b > max_a + margin || max_b < min_a - margin
}

/// Whether two consecutive segments lie on different sides of a line through their joint, and so meet only there.
fn meet_only_at_joint(a: &Segment, b: &Segment) -> bool {
    let joint = b.start();
    let before = Point::unit(joint - a.points[a.points.len() - 2]);
    let after = Point::unit(b.points[1] - joint);
    let whole = Point::unit(joint - a.start()) + Point::unit(b.end() - joint);
    // A line that separates the control points also separates the curves, because these are in the convex hulls.
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
    if b.bounds.outside(p).max_element() > epsilon || is_beside(&b.points, &[p], epsilon) {
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
