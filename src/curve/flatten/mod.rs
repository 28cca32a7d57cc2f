//! Flattening: approximation of a curve by a polyline.
//!
//! Flattening replaces a curve by chords. The tolerance is the maximum distance of any point of the curve from the
//! polyline; the number of chords is about √(size / tolerance). Bounds on the derivatives in a part of the curve say how
//! many equal steps keep the tolerance there, so that few chords have to be measured: see [`cubic`] up to degree 3, and
//! [`steps`] above. Where the bounds are far above what the curvature needs, as next to a cusp, the curve is halved.

mod cubic;
mod steps;

use super::Curve;
use super::nearest::as_cubic;
use super::straight::Chord;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::{Error, MAX_DEGREE};
use crate::geometry::point::{CrossProduct, Point};
use crate::numeric::float::ulp;
use cubic::{CubicParts, visit_parts};
use glam::DVec3;
use std::borrow::Borrow;
use steps::{EqualSteps, StepPlanner};

/// The largest number of vertices that flattening returns.
pub(crate) const MAX_VERTICES: usize = 1 << 24;

/// Rounding of points on a line, and of the test for it, in ulps of the largest coordinate.
const STRAIGHT_ULPS: f64 = 8.0;

/// A curve counts as straight if its control points are within this part of the tolerance of a line.
const NEARLY_STRAIGHT: f64 = 0.25;

/// Outside this range of coordinates, squares of products leave the range of f64, and a scaled copy of the curve is
/// used.
const PLAIN_RANGE: std::ops::Range<f64> = 1e-20..1e20;

/// A polyline that approximates a curve.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
pub struct Polyline<P> {
    /// The vertices: the start of the curve, points of the curve, its end.
    pub points: Vec<P>,
    /// The parameters of the vertices, increasing from 0 to 1.
    pub ts: Vec<f64>,
}

impl<P: Point> Polyline<P> {
    /// Appends the vertices of a curve whose parameters start at `from`. The start is left out if the polyline has
    /// vertices, the last of which is then the start.
    pub(crate) fn append(&mut self, curve: &Curve<P>, from: f64, tolerance: f64) {
        let joined = !self.ts.is_empty();
        visit_vertices(&curve.points, joined, tolerance, |t, point| {
            self.ts.push(from + t);
            self.points.push(point);
        });
    }
}

impl<P: Point> Curve<P> {
    /// A polyline whose distance from every point of the curve is at most `tolerance`, in the unit of the input.
    ///
    /// The number of chords is about a quarter more than the minimum by longest-chord search; where a curve nearly
    /// reverses, it may be some tens more. The first and the last vertex are the end points. Where a straight curve
    /// reverses there is a vertex (unless another vertex lies within the tolerance). A curve that is a point gives that
    /// point twice. Source of the bound: h²/8 · max |B″| for a step h (Wang, "The subdivision method for finding the
    /// intersection between two Bézier curves or surfaces", 1984), here for the part of B″ across the chord.
    ///
    /// # Errors
    /// [`Error::Range`] for a tolerance that is not above 0, [`Error::Tolerance`] for one below 4 ulps of the largest
    /// coordinate, [`Error::TooMany`] for more than 2²⁴ vertices.
    ///
    /// Cost: up to degree 3 about 200 ns, and 2 ns for each vertex. Above degree 3, n² steps for each vertex and for
    /// each part of the curve.
    pub fn flatten(&self, tolerance: f64) -> Result<Polyline<P>, Error> {
        self.check_flatten(tolerance)?;
        let mut line = Polyline::default();
        line.append(self, 0.0, tolerance);
        Ok(line)
    }

    /// Same as [`flatten`](Self::flatten), but passes each vertex to `vertex` instead of collecting them.
    ///
    /// # Errors
    /// Same as `flatten`, before the first vertex.
    pub fn flatten_with(&self, tolerance: f64, vertex: impl FnMut(f64, P)) -> Result<(), Error> {
        self.check_flatten(tolerance)?;
        visit_vertices(&self.points, false, tolerance, vertex);
        Ok(())
    }

    /// Returns an error before anything is allocated.
    fn check_flatten(&self, tolerance: f64) -> Result<(), Error> {
        let size = self.max_abs();
        check_tolerance(tolerance, size)?;
        let all = (self.points.len(), size);
        check_vertices(all, || std::iter::once(self), tolerance, MAX_VERTICES)
    }

    /// Passes on the vertices inside (0, 1).
    fn visit_inner_vertices(&self, tolerance: f64, vertex: &mut impl FnMut(f64, P)) {
        let size = self.max_abs();
        let scale = if PLAIN_RANGE.contains(&size) {
            1.0
        } else {
            1.0 / size
        };
        let straight = (STRAIGHT_ULPS * ulp(size)).max(NEARLY_STRAIGHT * tolerance);
        // The quick test is only used where its squares of products are in the range of f64.
        if !(scale == 1.0 && self.is_clearly_bent(straight))
            && let Some(turns) = self.turns_of_straight(tolerance)
        {
            return turns.into_iter().for_each(|t| vertex(t, self.eval(t)));
        }
        // A part of the tolerance is for the rounding of vertices.
        let tolerance = tolerance - 2.0 * ulp(size);
        if let Some(points) = as_cubic(&self.points) {
            let mut visit = |parts: &CubicParts<P>, [from, length]: [f64; 2]| {
                if length == 1.0 {
                    return parts.visit_inner_vertices(vertex);
                }
                // The curve is halved: later parts start with a vertex, and vertices are points of the whole curve.
                if from > 0.0 {
                    vertex(from, self.eval(from));
                }
                parts.visit_inner_vertices(&mut |t, _| {
                    vertex(from + length * t, self.eval(from + length * t))
                });
            };
            return visit_parts(points, [0.0, 1.0], scale, tolerance, &mut visit);
        }
        self.each_step(scale, tolerance, |steps| {
            let mut k = 1.0;
            while k <= steps.count {
                let t = steps.from + steps.length * (k / steps.count);
                // The caller adds the end of the curve.
                if t < 1.0 {
                    vertex(t, self.eval(t));
                }
                k += 1.0;
            }
        });
    }

    /// The number of chords of a curve that is not straight, except for those that end at the boundaries of parts of a
    /// cubic.
    fn chord_count(&self, tolerance: f64) -> f64 {
        let scale = 1.0 / self.max_abs();
        let mut sum = 0.0;
        if let Some(points) = as_cubic(&self.points) {
            let mut add = |parts: &CubicParts<P>, _| sum += parts.chord_count();
            visit_parts(points, [0.0, 1.0], scale, tolerance, &mut add);
            return sum;
        }
        self.each_step(scale, tolerance, |steps| sum += steps.count);
        sum
    }

    /// Passes on the parts of a curve of any degree and the steps in them. Plane points are converted to space, so that
    /// the code is compiled once.
    fn each_step(&self, scale: f64, tolerance: f64, mut visit: impl FnMut(EqualSteps)) {
        let mut points = [DVec3::ZERO; MAX_DEGREE + 1];
        for (to, &p) in points.iter_mut().zip(&self.points) {
            *to = ((p - self.start()) * scale).to_3d();
        }
        let mut planner = StepPlanner::new(self.degree(), tolerance * scale, &mut visit);
        planner.plan(&points, [0.0, 1.0], 0);
    }

    /// A quick test that the control points are not within a distance w of a common line: its angle with the line
    /// through the end points would be at most 2w / |chord|.
    fn is_clearly_bent(&self, w: f64) -> bool {
        // Across the line, chord and gap are at most 2w long, so |chord × gap| ≤ 2w (|chord| + |gap|). The square of
        // this is at most 8w² (|chord|² + |gap|²).
        let start = self.start();
        let chord = self.end() - start;
        self.points.iter().any(|&p| {
            let gap = p - start;
            chord.cross(gap).size_squared() > 8.0 * w * w * (chord.dot(chord) + gap.dot(gap))
        })
    }

    /// The parameters at which a straight curve reverses by more than the tolerance, or `None` for a curve that is not
    /// straight.
    fn turns_of_straight(&self, tolerance: f64) -> Option<Vec<f64>> {
        let limit = (STRAIGHT_ULPS * ulp(self.max_abs())).max(NEARLY_STRAIGHT * tolerance);
        let chord = Chord::of(&self.points);
        if chord.width > limit.min(0.5 * tolerance) {
            return None;
        }
        // The curve and its chords are on both sides of the line.
        let tolerance = tolerance - (2.0 * chord.width).min(0.5 * tolerance);
        let (start, end) = (self.start(), self.end());
        // Along the line only the coordinate that varies most is needed.
        let axis = (0..P::DIMENSION).max_by(|&a, &b| {
            let size = |axis| chord.direction.coordinate(axis).abs();
            size(a).total_cmp(&size(b))
        })?;
        // Each reversal that is left out lies within the tolerance of an end of its chord.
        let mut turns = self.extrema_on(axis).to_vec();
        let near = |t: f64, p: P| (self.eval(t) - p).norm() <= tolerance;
        while turns.last().is_some_and(|&t| near(t, end)) {
            turns.pop();
        }
        let mut last = start;
        turns.retain(|&t| {
            let kept = !near(t, last);
            if kept {
                last = self.eval(t);
            }
            kept
        });
        Some(turns)
    }
}

/// Passes on the vertices of the curve with the given control points, for a tolerance that is checked; without the start
/// if the curve is joined to another one, whose last vertex it is.
// Without inlining (and without link-time optimisation), flattening the lines of a path takes 28 % longer.
#[cfg_attr(feature = "fast", inline)]
pub(crate) fn visit_vertices<P: Point>(
    points: &[P],
    joined: bool,
    tolerance: f64,
    mut vertex: impl FnMut(f64, P),
) {
    if !joined {
        vertex(0.0, points[0]);
    }
    if points.len() > 2 {
        Curve::from_slice(points).visit_inner_vertices(tolerance, &mut vertex);
    }
    vertex(1.0, points[points.len() - 1]);
}

/// Returns an error if flattening curves gives more vertices than the limit. `points` is the number of all control points
/// and `size` their largest coordinate.
pub(crate) fn check_vertices<P: Point, C: Borrow<Curve<P>>, I: Iterator<Item = C>>(
    (points, size): (usize, f64),
    curves: impl FnOnce() -> I,
    tolerance: f64,
    limit: usize,
) -> Result<(), Error> {
    // √(n(n−1)/8 · |Δ²P| / tolerance) equal steps are sufficient (Wang, 1984), and |Δ²P| ≤ 4√3 size; this is often a
    // large overestimate.
    let enough = points as f64 * ((size / tolerance).sqrt() + 8.0);
    let max = limit as f64;
    let count = |curve: C| match curve.borrow().degree() {
        1 => 1.0,
        _ => curve.borrow().chord_count(tolerance),
    };
    if enough <= max || curves().map(count).sum::<f64>() < max {
        return Ok(());
    }
    Err(Error::too_many("vertices", limit, limit.saturating_add(1)))
}
