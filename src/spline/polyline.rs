//! The polyline of sampled points that a spline is fitted to, and its division into clusters.

use super::cubics::chord_lengths;
use crate::geometry::bounds::Bounds;
use crate::geometry::point::Point;
use casteljau_kernels::numeric::order::larger;
use casteljau_kernels::numeric::work_limit::WorkLimit;
use std::ops::Range;

/// Sampled points in order, with the chord length from the start at each point.
///
/// A closed polyline ends with a copy of its first point. It is continued periodically: index i + `period` is the same
/// point one round later.
pub(crate) struct SampledPolyline<P> {
    pub(crate) points: Vec<P>,
    lengths: Vec<f64>,
    closed: bool,
}

/// Consecutive points that lie close together, represented by their mean.
#[derive(Clone, Copy)]
pub(crate) struct Cluster<P> {
    /// The index of its first point.
    pub(crate) first: usize,
    pub(crate) mean: P,
    /// The chord length from the first cluster, from mean to mean: it does not grow with the number of points in a cluster,
    /// which may be large where someone stood still.
    pub(crate) length: f64,
    /// The mean of the chord lengths at its points, and the ratio of the size of the cluster to their growth in it.
    polyline_length: f64,
    scale: f64,
}

impl<P> Cluster<P> {
    /// The length from the mean to a point of the cluster with a chord length.
    pub(crate) fn length_to(&self, polyline_length: f64) -> f64 {
        (polyline_length - self.polyline_length) * self.scale
    }
}

impl<P: Point> SampledPolyline<P> {
    pub(crate) fn new(points: Vec<P>, closed: bool) -> Self {
        Self {
            lengths: chord_lengths(&points),
            points,
            closed,
        }
    }

    /// The number of different points.
    pub(crate) fn period(&self) -> usize {
        self.points.len() - usize::from(self.closed)
    }

    pub(crate) fn is_closed(&self) -> bool {
        self.closed
    }

    pub(crate) fn point(&self, index: usize) -> P {
        self.points[index % self.period()]
    }

    /// The chord length from point 0.
    pub(crate) fn length(&self, index: usize) -> f64 {
        let (rounds, rest) = (index / self.period(), index % self.period());
        let around = self.lengths.last().copied().unwrap_or(0.0);
        self.lengths[rest] + around * rounds as f64
    }

    /// Divides the points from index `first` to `last`, inclusive: the points of a cluster lie within `radius` of its
    /// first point.
    pub(crate) fn clusters(&self, first: usize, last: usize, radius: f64) -> Vec<Cluster<P>> {
        let mut clusters: Vec<Cluster<P>> = Vec::new();
        let mut from = first;
        while from <= last {
            let start = self.point(from);
            let (mut sum, mut lengths, mut farthest) = (P::default(), self.length(from), 0.0);
            let mut to = from + 1;
            while to <= last {
                let gap = self.point(to) - start;
                let distance = gap.norm();
                if distance >= radius {
                    break;
                }
                sum += gap;
                lengths += self.length(to);
                farthest = larger(farthest, distance);
                to += 1;
            }
            let count = (to - from) as f64;
            let mean = start + sum / count;
            let step = |before: &Cluster<P>| before.length + (mean - before.mean).norm();
            let around = self.length(to - 1) - self.length(from);
            clusters.push(Cluster {
                first: from,
                mean,
                length: clusters.last().map_or(0.0, step),
                polyline_length: lengths / count,
                scale: if around > 0.0 { farthest / around } else { 1.0 },
            });
            from = to;
        }
        clusters
    }
}

/// Boxes of consecutive points, to find the next one beyond a distance in a time that grows with the logarithm of their
/// number, also where all points are close together.
pub(crate) struct PointTree<'a, P> {
    points: &'a [P],
    /// Node k has the children 2k and 2k + 1; the points are the last nodes.
    boxes: Vec<Bounds<P>>,
}

impl<'a, P: Point> PointTree<'a, P> {
    /// Expects at least one point.
    pub(crate) fn new(points: &'a [P]) -> Self {
        let leaves = points.len().next_power_of_two();
        let last = points[points.len() - 1];
        // Unused leaves repeat the last point. A node with used and unused leaves contains that point anyway.
        let mut boxes = vec![Bounds::from_points(&[last]); 2 * leaves];
        for (leaf, &p) in boxes[leaves..].iter_mut().zip(points) {
            *leaf = Bounds::from_points(&[p]);
        }
        for k in (1..leaves).rev() {
            boxes[k] = boxes[2 * k].union(boxes[2 * k + 1]);
        }
        Self { points, boxes }
    }

    /// The first point of a range at least a distance from p.
    pub(crate) fn first_beyond(&self, p: P, distance: f64, range: Range<usize>) -> Option<usize> {
        self.beyond(p, distance, &range, true)
    }

    /// The last point of a range at least a distance from p.
    pub(crate) fn last_beyond(&self, p: P, distance: f64, range: Range<usize>) -> Option<usize> {
        self.beyond(p, distance, &range, false)
    }

    fn beyond(&self, p: P, distance: f64, range: &Range<usize>, ahead: bool) -> Option<usize> {
        let leaves = self.boxes.len() / 2;
        // The distance of p from the farthest corner of a box.
        let farthest = |k: usize| {
            let Bounds { min, max } = self.boxes[k];
            (p - min).max(max - p).norm()
        };
        let mut work = WorkLimit::new(usize::MAX);
        // Nodes and the points in them; the next one is the last.
        let mut stack = vec![(1, 0..leaves)];
        while let Some((k, own)) = stack.pop() {
            work.count(1);
            let is_outside = own.end <= range.start || range.end <= own.start;
            if is_outside || farthest(k) < distance {
                continue;
            }
            if k >= leaves {
                return (own.start < self.points.len()).then_some(own.start);
            }
            let middle = usize::midpoint(own.start, own.end);
            let halves = [(2 * k, own.start..middle), (2 * k + 1, middle..own.end)];
            let [first, second] = halves;
            stack.extend(if ahead {
                [second, first]
            } else {
                [first, second]
            });
        }
        None
    }
}
