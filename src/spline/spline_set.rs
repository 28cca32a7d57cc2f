//! Intersections of sets of splines: finds the pairs of curves whose boxes overlap and maps their intersections to
//! spline parameters.
//!
//! Each list of curves has a tree of bounding boxes.

use super::Spline;
use crate::curve::Curve;
use crate::curve::intersect::intersection::{Intersection, IntersectionKind};
use crate::geometry::bounds::Bounds;
use crate::geometry::box_tree::BoxTree;
use crate::numeric::sort::sort_by;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use glam::DVec2;
use std::borrow::Borrow;

/// Boxes are enlarged by this ratio of their coordinates, so that curves separated only by rounding are compared.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Parameter distance within which intersections found on two curves at the same joint are merged: the parameter of a
/// tangency is known only to the square root of the rounding error.
const ONE_JOINT: f64 = 1e-7;

/// A segment of a spline, polynomial or rational.
pub(crate) trait SplineSegment {
    /// Its intersections with another segment.
    fn contacts_with(&self, other: &Self) -> Vec<Intersection>;
    /// The points that it passes twice.
    fn contacts_with_itself(&self) -> Vec<Intersection>;
    /// The box of its control points.
    fn control_box(&self) -> Bounds<DVec2>;
}

impl SplineSegment for Curve<DVec2> {
    fn contacts_with(&self, other: &Self) -> Vec<Intersection> {
        self.intersections(other)
    }

    fn contacts_with_itself(&self) -> Vec<Intersection> {
        self.self_contacts()
    }

    fn control_box(&self) -> Bounds<DVec2> {
        self.control_bounds()
    }
}

/// The segments of several splines in one list of curves.
pub(crate) struct SplineSet<C = Curve<DVec2>> {
    curves: Vec<C>,
    /// For each curve, the index of its spline and its segment index there.
    segment_keys: Vec<(usize, usize)>,
    /// For each spline, its number of segments and whether it is closed.
    sizes: Vec<(usize, bool)>,
    tree: BoxTree,
}

/// An intersection of two splines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SplineIntersection {
    /// The index of the spline in the first list.
    pub(crate) a: usize,
    /// The index of the spline in the second list.
    pub(crate) b: usize,
    /// The intersection, with t on spline `a` and u on spline `b`.
    pub(crate) at: Intersection,
}

impl SplineSet {
    pub(crate) fn new(splines: impl IntoIterator<Item: Borrow<Spline<DVec2>>>) -> Self {
        let (mut curves, mut segment_keys, mut sizes) = (Vec::new(), Vec::new(), Vec::new());
        for (spline_index, spline) in splines.into_iter().enumerate() {
            let spline = spline.borrow();
            let count = spline.segment_count();
            sizes.push((count, spline.is_closed()));
            segment_keys.extend((0..count).map(|k| (spline_index, k)));
            curves.extend(spline.segments());
        }
        Self::with(curves, segment_keys, sizes)
    }

    /// A set with one curve, as a spline of one segment.
    pub(crate) fn of_curve(curve: &Curve<DVec2>) -> Self {
        Self::with(vec![curve.clone()], vec![(0, 0)], vec![(1, false)])
    }
}

impl<C: SplineSegment> SplineSet<C> {
    /// A set with one spline.
    #[cfg(feature = "nurbs")]
    pub(crate) fn of_segments(segments: Vec<C>, closed: bool) -> Self {
        let count = segments.len();
        let keys = (0..count).map(|k| (0, k)).collect();
        Self::with(segments, keys, vec![(count, closed)])
    }

    fn with(curves: Vec<C>, segment_keys: Vec<(usize, usize)>, sizes: Vec<(usize, bool)>) -> Self {
        let boxes: Vec<Bounds<DVec2>> = curves.iter().map(enlarged_box).collect();
        Self {
            curves,
            segment_keys,
            sizes,
            tree: BoxTree::new(&boxes),
        }
    }

    /// The spline parameter of t on a curve; the end of a closed spline maps to its start.
    fn at(&self, curve: usize, t: f64) -> f64 {
        let (spline_index, k) = self.segment_keys[curve];
        self.start_at(spline_index, k as f64 + t)
    }

    fn start_at(&self, spline_index: usize, t: f64) -> f64 {
        let (count, closed) = self.sizes[spline_index];
        if closed && t == count as f64 { 0.0 } else { t }
    }

    /// The spline parameter of an end of an overlap; the end of a closed spline is not mapped to its start.
    fn end_at(&self, curve: usize, t: f64) -> f64 {
        self.segment_keys[curve].1 as f64 + t
    }

    /// All intersections of the splines of this set with those of another one, sorted by splines, then by t, then by u.
    pub(crate) fn intersections_with(&self, other: &Self) -> Vec<SplineIntersection> {
        let mut found = Vec::new();
        // In the worst case all pairs of boxes overlap, and all pairs are compared.
        let mut work = WorkLimit::new(usize::MAX);
        self.tree.pairs_with(&other.tree, &mut work, |i, j| {
            for intersection in self.curves[i].contacts_with(&other.curves[j]) {
                found.push(self.intersection_of(other, (i, j), intersection));
            }
        });
        joined(found, self, other)
    }

    fn intersection_of(
        &self,
        other: &Self,
        (i, j): (usize, usize),
        intersection: Intersection,
    ) -> SplineIntersection {
        let mut at = intersection;
        if let IntersectionKind::Overlap { t_end, u_end } = &mut at.kind {
            (at.t, at.u) = (
                self.end_at(i, intersection.t),
                other.end_at(j, intersection.u),
            );
            (*t_end, *u_end) = (self.end_at(i, *t_end), other.end_at(j, *u_end));
        } else {
            (at.t, at.u) = (self.at(i, intersection.t), other.at(j, intersection.u));
        }
        SplineIntersection {
            a: self.segment_keys[i].0,
            b: other.segment_keys[j].0,
            at,
        }
    }

    /// The self-intersections of the splines of this set and the intersections between them; every pair once, with its
    /// smaller parameter first. Overlaps are omitted.
    pub(crate) fn intersections_within(&self) -> Vec<SplineIntersection> {
        let mut found = Vec::new();
        let mut work = WorkLimit::new(usize::MAX);
        for (i, curve) in self.curves.iter().enumerate() {
            for intersection in curve.contacts_with_itself() {
                found.push(self.intersection_of(self, (i, i), intersection));
            }
        }
        self.tree.pairs_within(&mut work, |i, j, _| {
            let (i, j) = (i.min(j), i.max(j));
            for intersection in self.curves[i].contacts_with(&self.curves[j]) {
                found.push(self.intersection_of(self, (i, j), intersection));
            }
        });
        // The joint of two neighbouring segments is not an intersection.
        found.retain_mut(|m| {
            if m.a == m.b && m.at.t > m.at.u {
                (m.at.t, m.at.u) = (m.at.u, m.at.t);
            }
            let overlap = matches!(m.at.kind, IntersectionKind::Overlap { .. });
            !(overlap || m.a == m.b && self.is_one_joint(m.a, m.at.t, m.at.u))
        });
        joined(found, self, self)
    }

    /// Whether two parameters of a spline denote the same joint.
    fn is_one_joint(&self, spline_index: usize, t: f64, u: f64) -> bool {
        let (count, closed) = self.sizes[spline_index];
        // On a closed spline, t and u may also be next to each other across its start.
        let around = if closed { count as f64 } else { f64::INFINITY };
        let apart = (u - t).abs();
        apart <= ONE_JOINT || around - apart <= ONE_JOINT
    }
}

/// The box of a curve, enlarged by rounding.
fn enlarged_box(curve: &impl SplineSegment) -> Bounds<DVec2> {
    let bounds = curve.control_box();
    bounds.enlarged(bounds.min.abs().max(bounds.max.abs()) * ROUNDING)
}

/// Sorts the intersections, merges overlaps that continue across joints, and removes duplicates found on both sides of
/// a joint.
fn joined<C: SplineSegment>(
    mut found: Vec<SplineIntersection>,
    a: &SplineSet<C>,
    b: &SplineSet<C>,
) -> Vec<SplineIntersection> {
    let order = |p: &SplineIntersection, q: &SplineIntersection| {
        (p.a, p.b)
            .cmp(&(q.a, q.b))
            .then(p.at.t.total_cmp(&q.at.t))
            .then(p.at.u.total_cmp(&q.at.u))
    };
    sort_by(&mut found, order);
    let (overlaps, points): (Vec<SplineIntersection>, Vec<SplineIntersection>) = found
        .into_iter()
        .partition(|m| matches!(m.at.kind, IntersectionKind::Overlap { .. }));
    // The ends of all overlaps: an isolated intersection at one of them is a part of the overlap.
    let mut ends: Vec<(usize, usize, f64, f64)> = overlaps
        .iter()
        .flat_map(|m| {
            let (t_end, u_end) = end_of(m);
            [(m.at.t, m.at.u), (t_end, u_end)]
                .map(|(t, u)| (m.a, m.b, a.start_at(m.a, t), b.start_at(m.b, u)))
        })
        .collect();
    sort_by(&mut ends, |p, q| {
        (p.0, p.1).cmp(&(q.0, q.1)).then(p.2.total_cmp(&q.2))
    });
    let overlaps = joined_overlaps(overlaps);
    let mut all: Vec<SplineIntersection> = Vec::with_capacity(overlaps.len() + points.len());
    for point in points {
        let near = |t: f64, u: f64| {
            (t - point.at.t).abs() <= ONE_JOINT && (u - point.at.u).abs() <= ONE_JOINT
        };
        let same = |q: &SplineIntersection| (q.a, q.b) == (point.a, point.b);
        let mut before = all
            .iter_mut()
            .rev()
            .take_while(|q| point.at.t - q.at.t <= ONE_JOINT && same(q));
        // The same intersection on the neighbouring segment; it is tangential if it is so on either segment.
        if let Some(again) = before.find(|q| near(q.at.t, q.at.u)) {
            if point.at.kind == IntersectionKind::Tangent {
                again.at.kind = IntersectionKind::Tangent;
            }
            continue;
        }
        let from = (point.a, point.b, point.at.t - ONE_JOINT);
        let start = ends.partition_point(|&(a, b, t, _)| (a, b, t) < from);
        let at_overlap = ends[start..]
            .iter()
            .take_while(|&&(a, b, t, _)| {
                (a, b) == (point.a, point.b) && t <= point.at.t + ONE_JOINT
            })
            .any(|&(_, _, t, u)| near(t, u));
        if !at_overlap {
            all.push(point);
        }
    }
    all.extend(overlaps);
    sort_by(&mut all, order);
    all
}

/// The parameters of the end of an overlap; for an isolated intersection, its parameters.
fn end_of(intersection: &SplineIntersection) -> (f64, f64) {
    match intersection.at.kind {
        IntersectionKind::Overlap { t_end, u_end } => (t_end, u_end),
        _ => (intersection.at.t, intersection.at.u),
    }
}

/// Merges overlaps, sorted by the pair of splines and by t, that continue where another one ends in the same direction.
fn joined_overlaps(overlaps: Vec<SplineIntersection>) -> Vec<SplineIntersection> {
    let mut all: Vec<SplineIntersection> = Vec::new();
    // Those of the same pair that do not end before the current one starts.
    let mut open: Vec<usize> = Vec::new();
    for overlap in overlaps {
        let (t_end, u_end) = end_of(&overlap);
        let after = |q: &SplineIntersection| overlap.at.t - end_of(q).0;
        open.retain(|&k| {
            (all[k].a, all[k].b) == (overlap.a, overlap.b) && after(&all[k]) <= ONE_JOINT
        });
        let continues = |q: &SplineIntersection| {
            after(q) >= -ONE_JOINT
                && (end_of(q).1 - overlap.at.u).abs() <= ONE_JOINT
                && (end_of(q).1 - q.at.u) * (u_end - overlap.at.u) > 0.0
        };
        match open.iter().rev().find(|&&k| continues(&all[k])) {
            Some(&k) => all[k].at.kind = IntersectionKind::Overlap { t_end, u_end },
            None => {
                open.push(all.len());
                all.push(overlap);
            }
        }
    }
    all
}
