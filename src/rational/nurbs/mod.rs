//! NURBS curves: rational B-splines.
//!
//! Every nonempty knot span is a rational Bézier curve, its segment. The segments are computed when the curve is made;
//! queries ask them, and only the operations on knots ([`refine`], [`elevate`]) work on the control points.

mod construct;
mod elevate;
pub(super) mod interpolate;
mod intersect;
mod queries;
mod refine;

#[cfg(feature = "surfaces")]
pub(super) use queries::locate;

use super::weighted::WeightedPoint;
use super::{RationalCurve, check_weights};
use crate::curve::eval::MAX_OUTPUT_F64;
use crate::geometry::check::{MAX_COORDINATE, images};
use crate::geometry::error::Error;
use crate::geometry::point::Point;
use crate::numeric::float::as_f64;
use crate::spline::bspline::{MAX_STEPS, checked_knots, to_bezier};
use crate::spline::knots::Knots;

/// A NURBS curve: a non-uniform rational B-spline of degree 1 to 64, in the plane or in space.
///
/// C(t) = Σ wᵢ Nᵢ(t) Pᵢ / Σ wᵢ Nᵢ(t), where the Nᵢ are the B-splines of degree p over the knots u₀ ≤ u₁ ≤ …, with the control
/// points P₀ … Pₙ₋₁ and the weights w₀ … wₙ₋₁ above 0.
///
/// An open curve has n + p + 1 knots, and its domain is [uₚ, uₙ]; it passes through its first and last point if the knot at
/// that end has the multiplicity p (p + 1 with the outer knot, which does not affect the curve). A closed curve has n + 1 knots,
/// the joints of one period, and its domain is [u₀, uₙ]; its first segment depends on the points 0 to p. Parameters outside
/// the domain extrapolate the first and the last segment.
///
/// Source: Piegl and Tiller, *The NURBS Book*, ch. 4.
///
/// ```
/// use casteljau::{NurbsCurve, glam::DVec2};
///
/// let circle = NurbsCurve::circle(DVec2::ZERO, 2.0)?;
/// assert_eq!(circle.control_points().len(), 9);
/// assert_eq!(circle.eval(0.25), DVec2::new(0.0, 2.0));
/// assert!((circle.length() - 4.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "methods return new values"]
pub struct NurbsCurve<P: Point> {
    degree: usize,
    points: Vec<P>,
    weights: Vec<f64>,
    knots: Vec<f64>,
    closed: bool,
    /// The curve over each nonempty knot span.
    segments: Vec<RationalCurve<P>>,
    /// The knots between the segments, and the ends of the domain.
    joints: Vec<f64>,
}

impl<P: Point> NurbsCurve<P> {
    /// Makes a curve; without weights all are 1.
    ///
    /// ```
    /// use casteljau::{NurbsCurve, glam::DVec2};
    ///
    /// let points = [(0.0, 0.0), (1.0, 2.0), (3.0, 2.0), (4.0, 0.0)].map(DVec2::from);
    /// let knots = [0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0];
    /// let curve = NurbsCurve::new(2, &points, Some(&[1.0, 2.0, 2.0, 1.0]), &knots, false)?;
    /// assert_eq!(curve.domain(), [0.0, 2.0]);
    /// assert_eq!(curve.eval(1.0), DVec2::new(2.0, 2.0));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Range`] for a degree outside 1 to 64; [`Error::Count`] for too few points (an open curve needs degree + 1), a
    /// wrong number of weights or of knots; [`Error::NotFinite`] for a NaN or an infinity; [`Error::Item`] for a weight that is
    /// not above 0, a knot that is smaller than its predecessor, beyond ±2⁵⁰⁰, or of too high a multiplicity (at most p inside,
    /// p + 1 at the ends), and for a coordinate beyond [`MAX_COORDINATE`]; [`Error::TooMany`] above 1 GiB or above 2²⁸/p²
    /// segments.
    pub fn new(
        degree: usize,
        points: &[P],
        weights: Option<&[f64]>,
        knots: &[f64],
        closed: bool,
    ) -> Result<Self, Error> {
        let spans = checked_knots(points, degree, Some(knots), closed)?;
        let count = points.len();
        if let Some(weights) = weights {
            check_weights(weights, count)?;
        }
        let limited = |u: &f64| u.abs() <= MAX_COORDINATE;
        if let Some(index) = knots.iter().position(|u| !limited(u)) {
            return Err(Error::Item {
                what: "knots",
                index,
                expected: "knots from -2^500 to 2^500 (3.27e150)",
                got: knots[index],
            });
        }
        // The segments have degree + 1 points and weights each, and take at most degree² steps.
        let limit =
            (MAX_OUTPUT_F64 / (P::DIMENSION + 1) / (degree + 1)).min(MAX_STEPS / degree / degree);
        if spans.spans() > limit {
            return Err(Error::too_many("segments", limit, spans.spans()));
        }
        let weights = weights.map_or_else(|| vec![1.0; count], <[f64]>::to_vec);
        Ok(Self::from_parts(
            degree,
            points.to_vec(),
            weights,
            knots.to_vec(),
            closed,
            &spans,
        ))
    }

    /// A curve from valid parts.
    fn from_parts(
        degree: usize,
        points: Vec<P>,
        weights: Vec<f64>,
        knots: Vec<f64>,
        closed: bool,
        spans: &Knots,
    ) -> Self {
        let count = points.len();
        let mut segments: Vec<RationalCurve<P>> = Vec::new();
        let mut joints = Vec::new();
        let first = if closed { 0 } else { degree };
        let mut local = vec![0.0; 2 * degree + 1];
        for k in spans.starts() {
            let at = |i: usize| WeightedPoint {
                point: points[(k + i) % count],
                weight: weights[(k + i) % count],
            };
            let mut segment: Vec<WeightedPoint<P>> = (0..=degree).map(at).collect();
            let knot = |(i, u): (usize, &mut f64)| *u = spans.at(k + i);
            local.iter_mut().enumerate().for_each(knot);
            to_bezier(&mut segment, &local);
            // Each joint has the bits of the segment that starts there.
            if let Some(before) = segments.last_mut() {
                before.end_at(segment[0]);
            }
            segments.push(RationalCurve::from_weighted(&segment));
            joints.push(knots[k + first]);
        }
        if closed && let [first, ..] = &segments[..] {
            let start = first.weighted()[0];
            let last = segments.len() - 1;
            segments[last].end_at(start);
        }
        joints.push(knots[count]);
        Self {
            degree,
            points,
            weights,
            knots,
            closed,
            segments,
            joints,
        }
    }

    /// The degree p of every segment.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The control points.
    pub fn control_points(&self) -> &[P] {
        &self.points
    }

    /// The weight of each control point.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The knots, in ascending order.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// Whether points and knots are periodic.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The ends of the range of t.
    pub fn domain(&self) -> [f64; 2] {
        [self.joints[0], self.joints[self.segments.len()]]
    }

    /// The rational Bézier curves over the nonempty knot spans, from the first to the last. Each ends at the point, and
    /// with the weight, with which the next one starts.
    pub fn segments(&self) -> &[RationalCurve<P>] {
        &self.segments
    }

    /// The values of t at the ends of the segments: one more than segments.
    pub fn joints(&self) -> &[f64] {
        &self.joints
    }

    /// The first point of the curve.
    pub fn start(&self) -> P {
        self.segments[0].start()
    }

    /// The last point of the curve.
    pub fn end(&self) -> P {
        self.segments[self.segments.len() - 1].end()
    }

    /// The Greville abscissae: the mean of the p knots that belong to each control point, where it pulls the curve most.
    ///
    /// Source: Farin, *Curves and Surfaces for CAGD*, §8.6.
    pub fn greville(&self) -> Vec<f64> {
        let (knots, _) = self.unwrapped(0);
        let mean = |i: usize| {
            let knots = knots[i + 1..=i + self.degree].iter();
            knots.map(|u| u / as_f64(self.degree)).sum()
        };
        (0..self.points.len()).map(mean).collect()
    }

    /// Whether both curves have the same degree and structure, every control point lies within `tolerance` of its counterpart, and
    /// weights and knots are equal within `tolerance` times the largest one.
    pub fn approx_eq(&self, other: &Self, tolerance: f64) -> bool {
        let close = |(&a, &b): (&P, &P)| a == b || (a - b).norm() <= tolerance;
        let alike = |a: &[f64], b: &[f64]| {
            let size = a.iter().chain(b).fold(0.0, |max: f64, x| max.max(x.abs()));
            let mut pairs = a.iter().zip(b);
            a.len() == b.len() && pairs.all(|(a, b)| (a - b).abs() <= tolerance * size)
        };
        self.degree == other.degree
            && self.closed == other.closed
            && self.points.len() == other.points.len()
            && self.points.iter().zip(&other.points).all(close)
            && alike(&self.weights, &other.weights)
            && alike(&self.knots, &other.knots)
    }

    /// The same curve with reversed direction and the same domain.
    pub fn reverse(&self) -> Self {
        let [from, to] = self.domain();
        // The ends of the domain are exchanged without rounding.
        let mirrored = |&u: &f64| if u == from { to } else { from + (to - u) };
        let knots = self.knots.iter().rev().map(mirrored).collect();
        let mut points: Vec<P> = self.points.iter().rev().copied().collect();
        let mut weights: Vec<f64> = self.weights.iter().rev().copied().collect();
        if self.closed {
            // The last segment depends on the points n − 1 to n − 1 + p, the last of which is now the first.
            let turn = self.degree % points.len();
            points.rotate_right(turn);
            weights.rotate_right(turn);
        }
        self.rebuilt(self.degree, points, weights, knots)
    }

    /// The image of the curve under an affine map, which is the curve of the mapped control points.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Item`] for an image that is not finite or exceeds [`MAX_COORDINATE`].
    pub fn transform(&self, map: &P::Affine) -> Result<Self, Error> {
        let points = images(&self.points, map)?;
        Ok(self.rebuilt(
            self.degree,
            points,
            self.weights.clone(),
            self.knots.clone(),
        ))
    }

    /// The image of the curve under a projective map; see [`RationalCurve::project`].
    ///
    /// # Errors
    /// As there.
    pub fn project(&self, matrix: &P::Projective) -> Result<Self, Error> {
        let (points, weights) = super::transform::projected(&self.points, &self.weights, matrix)?;
        Ok(self.rebuilt(self.degree, points, weights, self.knots.clone()))
    }

    /// A curve of the same kind from valid parts.
    fn rebuilt(&self, degree: usize, points: Vec<P>, weights: Vec<f64>, knots: Vec<f64>) -> Self {
        let count = points.len();
        // The knots of a curve that is changed stay in order and keep their multiplicities; rounding of a difference cannot
        // separate or exchange them.
        match Knots::new(Some(&knots), count, degree, self.closed) {
            Ok(spans) => Self::from_parts(degree, points, weights, knots, self.closed, &spans),
            Err(_) => self.clone(),
        }
    }

    /// Control points with weights.
    pub(super) fn weighted(&self) -> Vec<WeightedPoint<P>> {
        let parts = self.points.iter().zip(&self.weights);
        parts
            .map(|(&point, &weight)| WeightedPoint { point, weight })
            .collect()
    }

    /// The knots and the control points as those of an open curve; those of a closed one continue periodically `turns`·n points
    /// before the first one and as far after the p points that follow the last one.
    fn unwrapped(&self, turns: usize) -> (Vec<f64>, Vec<WeightedPoint<P>>) {
        let parts = self.weighted();
        if !self.closed {
            return (self.knots.clone(), parts);
        }
        let (n, p) = (self.points.len(), self.degree);
        let (start, end) = (self.knots[0], self.knots[n]);
        let period = end - start;
        // The joint between two periods has the same bits on both sides, and those of the curve at its start and end.
        let seam = |turn: f64| {
            if turn == 1.0 {
                end
            } else {
                start + turn * period
            }
        };
        let count = (2 * turns + 1) * n + p;
        // Knot i + p of the whole turn is the joint at which segment i starts.
        let before = turns * n + p;
        let knot = |i: usize| {
            let from_far = i + (before.div_ceil(n) * n - before);
            let turn = as_f64(from_far / n) - as_f64(before.div_ceil(n));
            match self.knots[from_far % n] {
                u if u == start => seam(turn),
                u if u == end => seam(turn + 1.0),
                u => u + turn * period,
            }
        };
        let knots = (0..=count + p).map(knot).collect();
        (knots, (0..count).map(|i| parts[i % n]).collect())
    }
}
