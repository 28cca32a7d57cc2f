//! Flattening: approximation of a curve by a polyline.
//!
//! Flattening replaces a curve by chords. The tolerance is the maximum distance of any point of the curve from the
//! polyline; the number of chords is about √(size / tolerance). The algorithm takes, from each vertex, a chord that is
//! nearly as long as the tolerance allows. The maximum distance of the curve segment from its chord is known in closed
//! form up to degree 3 (see `cubic_deviation`) and has a close bound above (see `high_degree`), so a guessed step is
//! corrected once or twice and then accepted. Uneven curvature, inflections, cusps and reversals need no special cases.

mod as_cubics;
mod chords;
mod cubic_deviation;
mod deviation;
mod high_degree;
mod vertex_limit;

use super::Curve;
use super::straight::Chord;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::{CrossProduct, Point};
use crate::numeric::float::ulp;
use crate::numeric::list::Points;
use as_cubics::as_cubics;
use chords::walk_chords;
use cubic_deviation::CubicDeviation;
use glam::DVec3;
use high_degree::PieceDeviation;
use vertex_limit::check_vertices_within;
pub(crate) use vertex_limit::{MAX_VERTICES, VertexLimit, check_vertices};

/// Rounding of points on a line, and of the test for it, in ulps of the largest coordinate. A curve that deviates by
/// twice as much is certainly not straight.
const STRAIGHT_ULPS: f64 = 8.0;

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
    pub(crate) fn append(
        &mut self,
        curve: &Curve<P>,
        from: f64,
        tolerance: f64,
        limit: &mut VertexLimit,
    ) -> Result<(), Error> {
        let joined = !self.ts.is_empty();
        curve.walk_after(joined, tolerance, limit, |t, point| {
            self.ts.push(from + t);
            self.points.push(point);
        })
    }
}

impl<P: Point> Curve<P> {
    /// A polyline whose distance from every point of the curve is at most `tolerance`, in the unit of the input.
    ///
    /// The number of chords is at most one more, or a tenth more, than the minimum by longest-chord search. The first
    /// and the last vertex are the end points. Where a straight curve reverses there is a vertex (unless another vertex
    /// lies within the tolerance). A curve that is a point gives that point twice. Source of the distance: the cubic
    /// relative to its chord is s(1−s) times a linear function; see Filip, Magedson and Markot, "Surface algorithms
    /// using bounds on derivatives", CAGD 3 (1986), for bounds of this kind.
    ///
    /// # Errors
    /// [`Error::Range`] for a tolerance that is not above 0, [`Error::Tolerance`] for one below 4 ulps of the largest
    /// coordinate, [`Error::TooMany`] if more than 2²⁴ vertices are expected (an estimate, accurate to some per cent).
    ///
    /// Cost: up to degree 3 about 50 ns for each vertex. Above degree 3, n² steps for each segment that a cubic
    /// replaces, and n² for each vertex; if the tolerance is so coarse that replacement by cubics does not pay, about
    /// 20 n² steps for each vertex.
    pub fn flatten(&self, tolerance: f64) -> Result<Polyline<P>, Error> {
        self.check_flatten(tolerance)?;
        self.polyline(tolerance, &mut VertexLimit::new(MAX_VERTICES))
    }

    /// Same as [`flatten`](Self::flatten), but passes each vertex to `vertex` instead of collecting them.
    ///
    /// # Errors
    /// Same as `flatten`. All but [`Error::TooMany`] come before the first vertex; that one may come after some vertices,
    /// where the forecast of their number was too low.
    pub fn flatten_with(&self, tolerance: f64, vertex: impl FnMut(f64, P)) -> Result<(), Error> {
        self.check_flatten(tolerance)?;
        self.walk_after(
            false,
            tolerance,
            &mut VertexLimit::new(MAX_VERTICES),
            vertex,
        )
    }

    /// Returns an error before anything is allocated.
    fn check_flatten(&self, tolerance: f64) -> Result<(), Error> {
        check_tolerance(tolerance, self.max_abs())?;
        check_vertices(|| std::iter::once(self.clone()), tolerance)
    }

    /// Same as [`flatten`](Self::flatten) with the caller's limit on the number of vertices, for a tolerance that is
    /// already checked.
    pub(crate) fn flatten_within(
        &self,
        tolerance: f64,
        limit: &mut VertexLimit,
    ) -> Result<Polyline<P>, Error> {
        check_vertices_within(|| std::iter::once(self.clone()), tolerance, limit.max)?;
        self.polyline(tolerance, limit)
    }

    fn polyline(&self, tolerance: f64, limit: &mut VertexLimit) -> Result<Polyline<P>, Error> {
        let mut line = Polyline::default();
        line.append(self, 0.0, tolerance, limit)?;
        Ok(line)
    }

    /// Passes on the vertices, without the start if the curve is joined to another one, whose last vertex it is.
    pub(crate) fn walk_after(
        &self,
        joined: bool,
        tolerance: f64,
        limit: &mut VertexLimit,
        mut vertex: impl FnMut(f64, P),
    ) -> Result<(), Error> {
        if !joined {
            limit.spend()?;
        }
        self.walk(tolerance, limit, |t, point| {
            if !(joined && t == 0.0) {
                vertex(t, point);
            }
        })
    }

    /// Passes on the vertices; the start, which a joined curve has already, is not counted.
    fn walk(
        &self,
        tolerance: f64,
        limit: &mut VertexLimit,
        mut vertex: impl FnMut(f64, P),
    ) -> Result<(), Error> {
        vertex(0.0, self.start());
        if self.points.len() == 2 {
            limit.spend()?;
            vertex(1.0, self.end());
            return Ok(());
        }
        let size = self.max_abs();
        let plain = PLAIN_RANGE.contains(&size);
        if !(plain && self.deviates_by(2.0 * STRAIGHT_ULPS * ulp(size)))
            && let Some(ts) = self.turns_of_straight(tolerance)
        {
            for t in ts {
                limit.spend()?;
                vertex(t, self.eval(t));
            }
            limit.spend()?;
            vertex(1.0, self.end());
            return Ok(());
        }
        let mut inside = |t: f64| vertex(t, if t == 1.0 { self.end() } else { self.eval(t) });
        // Reserve a part of the tolerance for the rounding of vertices.
        let budget = tolerance - 2.0 * ulp(size);
        if plain {
            walk_points(&self.points, budget, limit, &mut inside)
        } else {
            let scaled: Points<P> = self.points.iter().map(|&p| p / size).collect();
            walk_points(&scaled, budget / size, limit, &mut inside)
        }
    }

    /// Whether some control point is farther than a distance from the line through the end points. This is a quick test
    /// that a curve is not straight; it may fail to detect it if the end points are close.
    fn deviates_by(&self, distance: f64) -> bool {
        let start = self.start();
        let chord = self.end() - start;
        let min = distance * distance * chord.dot(chord);
        self.points
            .iter()
            .any(|&p| chord.cross(p - start).size_squared() > min)
    }

    /// The parameters at which a straight curve reverses, or `None` for a curve that is not straight.
    fn turns_of_straight(&self, tolerance: f64) -> Option<Vec<f64>> {
        // Rounding is subtracted from the tolerance.
        let noise = (STRAIGHT_ULPS * ulp(self.max_abs())).min(0.5 * tolerance);
        let tolerance = tolerance - noise;
        let (start, end) = (self.start(), self.end());
        let chord = Chord::of(&self.points);
        if chord.width > noise {
            return None;
        }
        // Along the line only the coordinate that varies most is needed.
        let axis = (0..P::DIMENSION).max_by(|&a, &b| {
            let size = |axis| chord.direction.coordinate(axis).abs();
            size(a).total_cmp(&size(b))
        })?;
        // Each reversal that is left out lies within the tolerance of an end of its chord.
        let mut turns = self.extrema_on(axis).to_vec();
        let near = |t: f64, p: P| (self.eval(t) - p).length() <= tolerance;
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

fn walk_points<P: Point>(
    points: &[P],
    tolerance: f64,
    limit: &mut VertexLimit,
    vertex: &mut impl FnMut(f64),
) -> Result<(), Error> {
    if points.len() <= 4 {
        return walk_chords(&mut CubicDeviation::new(points, tolerance), limit, vertex);
    }
    // Relative to the start, the deviations of a curve that is far smaller than its coordinates keep their digits.
    let relative = |&p: &P| (p - points[0]).to_3d();
    let points: Points<DVec3> = points.iter().map(relative).collect();
    let Some((cubics, tolerance)) = as_cubics(&points, tolerance)? else {
        return walk_chords(&mut PieceDeviation::new(points, tolerance), limit, vertex);
    };
    for cubic in cubics {
        let (from, length) = (cubic.from, cubic.to - cubic.from);
        let mut inside = |s: f64| {
            vertex(if s == 1.0 {
                cubic.to
            } else {
                from + length * s
            })
        };
        let mut deviation = CubicDeviation::new(&cubic.points, tolerance);
        walk_chords(&mut deviation, limit, &mut inside)?;
    }
    Ok(())
}
