//! The segments of a curve under repeated halving, and a queue of segments ordered by a lower bound.

use crate::bernstein::evaluate::evaluate;
use crate::curve::Curve;
use crate::geometry::point::Point;
use crate::numeric::list::{Points, points_of};
use casteljau_kernels::numeric::order::range;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// The segments of a curve as a binary tree, created on demand.
pub(crate) struct SegmentTree<P: Point>(pub(crate) Vec<TreeSegment<P>>);

pub(crate) struct TreeSegment<P: Point> {
    points: Points<P>,
    lo: f64,
    hi: f64,
    pub(crate) middle: P,
    /// The largest difference of a coordinate from the start.
    pub(crate) size: f64,
    /// The index of the first half, followed by the second; 0 before the halves are created.
    halves: usize,
}

impl<P: Point> TreeSegment<P> {
    fn new(points: Points<P>, lo: f64, hi: f64) -> Self {
        let start = points[0];
        let size = points.iter().map(|&p| (p - start).max_abs());
        Self {
            lo,
            hi,
            middle: evaluate(&points, 0.5),
            size: size.fold(0.0, f64::max),
            points,
            halves: 0,
        }
    }

    pub(crate) fn mid(&self) -> f64 {
        0.5 * (self.lo + self.hi)
    }

    /// The minimum and the maximum of the control points along a direction.
    fn projected_range(&self, direction: P) -> (f64, f64) {
        range(self.points.iter().map(|&p| p.dot(direction)))
    }

    /// The component of a vector perpendicular to the chord.
    fn perpendicular_component(&self, vector: P) -> P {
        let chord = (self.points[self.points.len() - 1] - self.points[0]).unit();
        vector - chord * vector.dot(chord)
    }

    /// A lower bound on the distance of two segments.
    pub(crate) fn distance_bound(&self, other: &Self) -> f64 {
        // The gap between the projections onto any direction is a lower bound, negative if they overlap.
        let vector = self.middle - other.middle;
        let bound = |vector: P| {
            let direction = vector.unit();
            self.projected_range(direction).0 - other.projected_range(direction).1
        };
        bound(vector)
            .max(bound(self.perpendicular_component(vector)))
            .max(bound(other.perpendicular_component(vector)))
    }
}

impl<P: Point> SegmentTree<P> {
    pub(crate) fn new(points: &[P]) -> Self {
        Self(vec![TreeSegment::new(points_of(points), 0.0, 1.0)])
    }

    pub(crate) fn halves(&mut self, index: usize) -> [usize; 2] {
        let segment = &self.0[index];
        if segment.halves == 0 {
            let (left, right) = Curve::from_slice(&segment.points).halve();
            let (lo, mid, hi) = (segment.lo, segment.mid(), segment.hi);
            self.0[index].halves = self.0.len();
            self.0.push(TreeSegment::new(left.points, lo, mid));
            self.0.push(TreeSegment::new(right.points, mid, hi));
        }
        let first = self.0[index].halves;
        [first, first + 1]
    }
}

/// An item with a lower bound; the smallest bound comes first in a heap.
pub(crate) struct Bounded<T> {
    pub(crate) min: f64,
    pub(crate) of: T,
}

pub(crate) type Heap<T> = BinaryHeap<Bounded<T>>;

impl<T> PartialEq for Bounded<T> {
    fn eq(&self, other: &Self) -> bool {
        self.min == other.min
    }
}

impl<T> Eq for Bounded<T> {}

impl<T> Ord for Bounded<T> {
    fn cmp(&self, other: &Self) -> Ordering {
        other.min.total_cmp(&self.min)
    }
}

impl<T> PartialOrd for Bounded<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
