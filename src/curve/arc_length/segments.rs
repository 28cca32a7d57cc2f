//! Arc lengths of consecutive curves, such as the segments of a spline, and parameters at given arc lengths.

use super::inverse::ArcLengthInverse;
use crate::curve::Curve;
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, ratio, whole_and_rest};

/// The cumulative arc lengths of at least one curve.
pub(crate) struct SegmentLengths {
    /// The arc length from the start to the end of each curve, after a 0.
    ends: Vec<f64>,
    /// The curve that was asked last; successive positions mostly lie on the same curve.
    inverse: Option<(usize, ArcLengthInverse)>,
}

impl SegmentLengths {
    /// Sums the lengths of curves.
    pub(crate) fn new(lengths: impl Iterator<Item = f64>) -> Self {
        let mut whole = 0.0;
        let mut ends = vec![0.0];
        ends.extend(lengths.map(|length| {
            whole += length;
            whole
        }));
        Self {
            ends,
            inverse: None,
        }
    }

    pub(crate) fn ends(&self) -> &[f64] {
        &self.ends
    }

    pub(crate) fn total(&self) -> f64 {
        self.ends[self.last() + 1]
    }

    /// The index of the last curve.
    fn last(&self) -> usize {
        self.ends.len() - 2
    }

    /// The curve and the parameter on it at the arc length s from the start; an s outside the range gives the nearer
    /// end. Where two curves meet, the result is the start of the second one. `margin` is the distance from a joint
    /// within which s counts as the joint.
    pub(crate) fn position<P: Point>(
        &mut self,
        s: f64,
        margin: f64,
        tolerance: Option<f64>,
        curve: &dyn Fn(usize) -> Curve<P>,
    ) -> (usize, f64) {
        let k = self.ends[1..].partition_point(|&end| end <= s + margin);
        if s + margin <= 0.0 {
            return (0, 0.0);
        }
        if k > self.last() {
            return (self.last(), 1.0);
        }
        let rest = s - self.ends[k];
        if rest <= margin {
            return (k, 0.0);
        }
        let mut inverse = match self.inverse.take() {
            Some((of, inverse)) if of == k => inverse,
            _ => ArcLengthInverse::new(&curve(k), tolerance),
        };
        let t = inverse.time(rest);
        self.inverse = Some((k, inverse));
        (k, t)
    }

    /// The `steps` + 1 positions that divide the curves into parts of equal length; of curves of length 0, into even
    /// steps of the parameter.
    pub(crate) fn even_positions<P: Point>(
        mut self,
        steps: usize,
        curve: &dyn Fn(usize) -> Curve<P>,
    ) -> Vec<(usize, f64)> {
        let (whole, last) = (self.total(), self.last());
        let count = as_f64(last + 1);
        let mut positions = Vec::with_capacity(steps + 1);
        for i in 0..steps {
            let part = ratio(i, steps);
            positions.push(if whole > 0.0 {
                self.position(part * whole, 0.0, None, curve)
            } else {
                whole_and_rest(part * count, last)
            });
        }
        positions.push((last, 1.0));
        positions
    }
}
