//! The polyline of sampled points that a spline is fitted to, and its division into clusters.

use super::cubics::chord_lengths;
use crate::geometry::point::Point;

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
    /// The mean of the chord lengths at its points.
    pub(crate) length: f64,
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
        let mut clusters = Vec::new();
        let mut from = first;
        while from <= last {
            let start = self.point(from);
            let (mut sum, mut length) = (P::default(), 0.0);
            let mut to = from;
            while to <= last && (self.point(to) - start).norm() < radius {
                sum += self.point(to) - start;
                length += self.length(to);
                to += 1;
            }
            let to = to.max(from + 1);
            let count = (to - from) as f64;
            clusters.push(Cluster {
                first: from,
                mean: start + sum / count,
                length: length.max(self.length(from)) / count,
            });
            from = to;
        }
        clusters
    }
}
