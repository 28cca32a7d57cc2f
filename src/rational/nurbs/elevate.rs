//! Degree elevation.

use super::NurbsCurve;
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::Point;
use crate::numeric::float::{as_f64, unit_scale};
use crate::rational::weighted::{Homogeneous, WeightedPoint};
use crate::spline::bspline::MAX_STEPS;
use casteljau_kernels::bernstein::de_casteljau::lerp;

impl<P: Point> NurbsCurve<P> {
    /// The same curve with degree p + 1; every knot has one more copy, so the curve is as smooth as before.
    ///
    /// Control point i is the mean of the p + 1 values of the curve's blossom at the new knots i + 1 to i + p + 1 without one of
    /// them. An open curve whose end knots have multiplicities below p has them afterwards. The cost is p³ for each point.
    ///
    /// # Errors
    /// [`Error::Range`] at degree 64, [`Error::TooMany`] above 2²⁸/p³ points.
    ///
    /// Source: Ramshaw, "Blossoms are polar forms", CAGD 6 (1989); Prautzsch, "Degree elevation of B-spline curves", CAGD 1
    /// (1984).
    pub fn elevate(&self) -> Result<Self, Error> {
        let p = self.degree;
        if p >= MAX_DEGREE {
            return Err(Error::Range {
                what: "degree",
                expected: "a degree below 64",
                got: 64.0,
            });
        }
        let limit = MAX_STEPS / (p * p * p);
        if self.points.len() > limit {
            return Err(Error::too_many("points", limit, self.points.len()));
        }
        if self.closed {
            return Ok(self.elevated());
        }
        let [start, end] = self.domain();
        let ends = [self.knots[1], self.knots[self.points.len() + p - 1]];
        if ends == [start, end] {
            return Ok(self.elevated());
        }
        Ok(self.part(start, end).elevated())
    }

    /// [`elevate`](Self::elevate) for a closed curve, or one whose end knots have the multiplicity p or p + 1.
    fn elevated(&self) -> Self {
        let p = self.degree;
        let knots = self.elevated_knots();
        let blossom = Blossom::of(self);
        let count = knots.len() - if self.closed { 1 } else { p + 2 };
        // The knots i + 1 to i + p + 1 of a closed curve begin in the period before the first joint.
        let [start, end] = self.domain();
        let period = end - start;
        let knot = |i: usize| {
            if !self.closed {
                return knots[i];
            }
            let turns = (p + 1).div_ceil(count);
            let from_far = i + turns * count - (p + 1);
            let turn = as_f64(from_far / count) - as_f64(turns);
            knots[from_far % count] + turn * period
        };
        let mut parts: Vec<WeightedPoint<P>> = (0..count)
            .map(|i| blossom.mean(&(i..=i + p + 2).map(knot).collect::<Vec<f64>>()))
            .collect();
        if !self.closed {
            // The ends stay exactly.
            let old = self.weighted();
            (parts[0], parts[count - 1]) = (old[0], old[old.len() - 1]);
        }
        self.with_parts(p + 1, &parts, knots)
    }

    /// Each knot with one more copy; of a closed curve, all copies of the joint at the ends of the period are at its start, but for
    /// the last knot.
    fn elevated_knots(&self) -> Vec<f64> {
        let mut knots = Vec::with_capacity(2 * self.knots.len());
        let [start, end] = self.domain();
        let inside = self
            .knots
            .iter()
            .copied()
            .filter(|&u| !self.closed || u != end);
        if self.closed {
            let at_end = self.knots.iter().filter(|&&u| u == end).count();
            knots.extend(std::iter::repeat_n(start, at_end - 1));
        }
        let mut before = None;
        for u in inside {
            let copies = if before == Some(u) { 1 } else { 2 };
            knots.extend(std::iter::repeat_n(u, copies));
            before = Some(u);
        }
        if self.closed {
            knots.push(end);
        }
        knots
    }
}

/// The polar forms of the segments: symmetric functions of p arguments, of degree 1 in each, that are the segment where all
/// arguments are equal.
struct Blossom<P: Point> {
    knots: Vec<f64>,
    points: Vec<Homogeneous<P>>,
    scale: f64,
    p: usize,
}

impl<P: Point> Blossom<P> {
    fn of(curve: &NurbsCurve<P>) -> Self {
        let turns = if curve.closed {
            curve.degree.div_ceil(curve.points.len()) + 1
        } else {
            0
        };
        let (knots, parts) = curve.unwrapped(turns);
        let scale = unit_scale(curve.weights.iter().copied().fold(0.0, f64::max));
        let points = parts.iter();
        Self {
            knots,
            points: points
                .map(|part| Homogeneous::new(part.point, part.weight * scale))
                .collect(),
            scale,
            p: curve.degree,
        }
    }

    /// The mean of the blossom at all but one of the inner knots, where `knots` are the p + 3 knots of a control point of degree
    /// p + 1.
    fn mean(&self, knots: &[f64]) -> WeightedPoint<P> {
        let p = self.p;
        let span = self.span_inside(knots[0], knots[p + 2]);
        let mut sum = Homogeneous::default();
        for left_out in 1..=p + 1 {
            let arguments = (1..=p + 1).filter(|&i| i != left_out).map(|i| knots[i]);
            sum += self.at(span, arguments) * (1.0 / as_f64(p + 1));
        }
        WeightedPoint {
            point: sum.point(),
            weight: sum.weight / self.scale,
        }
    }

    /// The middle one of the spans between two knots: all of them have the same value at the knots in between.
    fn span_inside(&self, from: f64, to: f64) -> usize {
        let (p, count) = (self.p, self.points.len());
        let inside = |&k: &usize| {
            let (a, b) = (self.knots[k], self.knots[k + 1]);
            a < b && from <= a && b <= to
        };
        let first = self
            .knots
            .partition_point(|&u| u < from)
            .clamp(p, count - 1);
        let end = self.knots.partition_point(|&u| u <= to).clamp(p, count);
        let spans: Vec<usize> = (first..end).filter(inside).collect();
        spans.get(spans.len() / 2).copied().unwrap_or(first)
    }

    /// The value of the blossom of a span, by de Boor's algorithm with an argument for each level.
    fn at(&self, span: usize, arguments: impl Iterator<Item = f64>) -> Homogeneous<P> {
        let p = self.p;
        let mut points = self.points[span - p..=span].to_vec();
        for (level, u) in (1..).zip(arguments) {
            for i in 0..=p - level {
                let (from, to) = (self.knots[span - p + i + level], self.knots[span + i + 1]);
                points[i] = lerp(points[i], points[i + 1], (u - from) / (to - from));
            }
        }
        points[0]
    }
}
