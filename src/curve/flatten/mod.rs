//! Flattening: approximation of a curve by a polyline.
//!
//! Flattening replaces a curve by chords. The tolerance is the maximum distance of any point of the curve from the
//! polyline; the number of chords is about √(size / tolerance). The algorithm takes, from each vertex, a chord that is
//! nearly as long as the tolerance allows. The maximum distance of the curve segment from its chord is known in closed
//! form up to degree 3 (see `cubic_deviation`) and has a close bound above (see `high_degree`), so a guessed step is
//! corrected once or twice and then accepted. Uneven curvature, inflections, cusps and reversals need no special cases.

mod as_cubics;
mod cubic_deviation;
mod deviation;
mod high_degree;

use super::Curve;
use crate::geometry::check::check_tolerance;
use crate::geometry::error::Error;
use crate::geometry::point::{CrossProduct, Point};
use crate::numeric::float::{ratio, ulp};
use crate::numeric::work_limit::WorkLimit;
use as_cubics::as_cubics;
use cubic_deviation::CubicDeviation;
use deviation::{Deviation, Fraction, fourth_root};
use glam::DVec3;
use high_degree::PieceDeviation;

/// Maximum number of vertices that flattening returns.
pub(crate) const MAX_VERTICES: usize = 1 << 24;

/// A chord is accepted if its squared deviation, as a part of the squared tolerance, is at least this. Chords grow with
/// the square root of the deviation, so there are at most 0.72^-¼ = 1.086 times as many as necessary. A correction aims
/// slightly below the tolerance.
const KEPT_FROM: f64 = 0.72;
const AIMED_AT: f64 = 0.92;

/// Maximum number of corrections of one chord; after them the longest safe step is taken.
const MAX_CORRECTIONS: usize = 8;

/// The extrapolated ratio of two steps is limited to this range. It only affects the first try of a step: next to a cusp
/// the ratio of two steps says nothing about the third.
const MIN_GROWTH: f64 = 0.6;
const MAX_GROWTH: f64 = 1.6;

/// A correction makes a step at most this many times longer, as [`fourth_root`] also limits it.
const MAX_LENGTHENING: f64 = 4.0;

/// Rounding of points on a line, and of the test for it, in ulps of the largest coordinate. A curve that deviates by
/// twice as much is certainly not straight.
const STRAIGHT_ULPS: f64 = 8.0;

/// Steps of the midpoint rule that estimates the number of chords.
const FORECAST_STEPS: usize = 1024;

/// Outside this range of coordinates, squares of products leave the range of f64, and a scaled copy of the curve is
/// used.
const PLAIN_RANGE: std::ops::Range<f64> = 1e-20..1e20;

/// The number of vertices that flattening may still make; each of them counts as a step.
pub(crate) struct VertexLimit {
    limit: usize,
    work: WorkLimit,
}

impl VertexLimit {
    pub(crate) fn new(limit: usize) -> Self {
        Self {
            limit,
            work: WorkLimit::new(limit),
        }
    }

    /// Counts a vertex; returns an error beyond the limit.
    #[inline]
    fn spend(&mut self) -> Result<(), Error> {
        if self.work.spend(1) {
            Ok(())
        } else {
            Err(too_many(self.limit))
        }
    }
}

fn too_many(limit: usize) -> Error {
    Error::TooMany {
        what: "vertices",
        limit,
        needed: limit.saturating_add(1),
    }
}

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
        left: &mut VertexLimit,
    ) -> Result<(), Error> {
        let joined = !self.ts.is_empty();
        if !joined {
            left.spend()?;
        }
        curve.walk(tolerance, left, |t, point| {
            if !(joined && t == 0.0) {
                self.ts.push(from + t);
                self.points.push(point);
            }
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
        let mut line = Polyline::default();
        line.append(self, 0.0, tolerance, &mut VertexLimit::new(MAX_VERTICES))?;
        Ok(line)
    }

    /// Same as [`flatten`](Self::flatten), but passes each vertex to `vertex` instead of collecting them.
    ///
    /// # Errors
    /// Same as `flatten`, all before the first vertex.
    pub fn flatten_with(&self, tolerance: f64, vertex: impl FnMut(f64, P)) -> Result<(), Error> {
        self.check_flatten(tolerance)?;
        let mut left = VertexLimit::new(MAX_VERTICES);
        left.spend()?;
        self.walk(tolerance, &mut left, vertex)
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
        left: &mut VertexLimit,
    ) -> Result<Polyline<P>, Error> {
        check_vertices_within(|| std::iter::once(self.clone()), tolerance, left.limit)?;
        let mut line = Polyline::default();
        line.append(self, 0.0, tolerance, left)?;
        Ok(line)
    }

    /// Estimate of the number of chords at a fine tolerance: ∫ √(|B′ × B″| / |B′|) dt / √(8 tolerance), by the midpoint
    /// rule; accurate to some per cent.
    fn expected_chords(&self, tolerance: f64) -> f64 {
        let size = self.max_abs();
        let scaled: crate::numeric::list::Points<P> =
            self.points.iter().map(|&p| p / size).collect();
        let first = Self { points: scaled }.derivative();
        let second = first.derivative();
        let density = |k: usize| {
            let t = (k as f64 + 0.5) / FORECAST_STEPS as f64;
            let (v, a) = (first.eval(t), second.eval(t));
            let speed = v.length();
            if speed > 0.0 {
                (v.cross(a).size_squared().sqrt() / speed).sqrt()
            } else {
                0.0
            }
        };
        let mut work = WorkLimit::new(FORECAST_STEPS);
        let _counted = work.spend(FORECAST_STEPS);
        let mean = (0..FORECAST_STEPS).map(density).sum::<f64>() / FORECAST_STEPS as f64;
        mean / (8.0 * AIMED_AT.sqrt() * (tolerance / size)).sqrt()
    }

    /// Passes on the vertices; the start, which a joined curve has already, is not counted.
    fn walk(
        &self,
        tolerance: f64,
        left: &mut VertexLimit,
        mut vertex: impl FnMut(f64, P),
    ) -> Result<(), Error> {
        let size = self.max_abs();
        let plain = PLAIN_RANGE.contains(&size);
        vertex(0.0, self.start());
        if !(plain && self.deviates_by(2.0 * STRAIGHT_ULPS * ulp(size)))
            && let Some(ts) = self.turns_of_straight(tolerance)
        {
            for t in ts {
                left.spend()?;
                vertex(t, self.eval(t));
            }
            left.spend()?;
            vertex(1.0, self.end());
            return Ok(());
        }
        let mut inside = |t: f64| vertex(t, if t == 1.0 { self.end() } else { self.eval(t) });
        // Reserve a part of the tolerance for the rounding of vertices.
        let budget = tolerance - 2.0 * ulp(size);
        if plain {
            walk_points(&self.points, budget, left, &mut inside)
        } else {
            let scaled: crate::numeric::list::Points<P> =
                self.points.iter().map(|&p| p / size).collect();
            walk_points(&scaled, budget / size, left, &mut inside)
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
        let farthest = |p: P, q: P| {
            if (q - start).max_abs() > (p - start).max_abs() {
                q
            } else {
                p
            }
        };
        let direction =
            (self.points.iter().fold(end, |p, &q| farthest(p, q)) - start).normalize_or_zero();
        let across = |p: P| ((p - start) - direction * (p - start).dot(direction)).max_abs();
        if self.points.iter().any(|&p| across(p) > noise) {
            return None;
        }
        // Along the line only the coordinate that varies most is needed.
        let axis = (0..P::DIMENSION).max_by(|&a, &b| {
            direction
                .coordinate(a)
                .abs()
                .total_cmp(&direction.coordinate(b).abs())
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

/// Returns an error if flattening all curves is expected to give more vertices than the limit.
pub(crate) fn check_vertices<P: Point, I: Iterator<Item = Curve<P>>>(
    curves: impl Fn() -> I,
    tolerance: f64,
) -> Result<(), Error> {
    check_vertices_within(curves, tolerance, MAX_VERTICES)
}

fn check_vertices_within<P: Point, I: Iterator<Item = Curve<P>>>(
    curves: impl Fn() -> I,
    tolerance: f64,
    limit: usize,
) -> Result<(), Error> {
    // √(n(n−1)/8 · |Δ²P| / tolerance) equal steps are sufficient (Wang, 1984), and |Δ²P| ≤ 4√3 size; this is often a
    // large overestimate.
    let enough = |c: Curve<P>| ratio(c.degree(), 1) * (c.max_abs() / tolerance).sqrt();
    let max = limit as f64;
    if curves().map(enough).sum::<f64>() <= max
        || curves().map(|c| c.expected_chords(tolerance)).sum::<f64>() < max
    {
        return Ok(());
    }
    Err(too_many(limit))
}

fn walk_points<P: Point>(
    points: &[P],
    tolerance: f64,
    left: &mut VertexLimit,
    vertex: &mut impl FnMut(f64),
) -> Result<(), Error> {
    if points.len() <= 4 {
        return walk_chords(&mut CubicDeviation::new(points, tolerance), left, vertex);
    }
    // Relative to the start, the deviations of a curve that is far smaller than its coordinates keep their digits.
    let relative = |&p: &P| (p - points[0]).to_3d();
    let points: crate::numeric::list::Points<DVec3> = points.iter().map(relative).collect();
    let Some((cubics, tolerance)) = as_cubics(&points, tolerance)? else {
        return walk_chords(&mut PieceDeviation::new(points, tolerance), left, vertex);
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
        walk_chords(&mut deviation, left, &mut inside)?;
    }
    Ok(())
}

/// Advances from vertex to vertex until t = 1.
fn walk_chords(
    deviation: &mut impl Deviation,
    left: &mut VertexLimit,
    vertex: &mut impl FnMut(f64),
) -> Result<(), Error> {
    let mut t = 0.0;
    deviation.start_at(t);
    let (mut previous, mut step): (f64, f64) = (f64::INFINITY, 0.0);
    loop {
        left.spend()?;
        let rest = 1.0 - t;
        // Extrapolate the ratio of the last two steps, within limits.
        let expected = step * (step / previous).clamp(MIN_GROWTH, MAX_GROWTH);
        previous = step;
        step = longest_step(deviation, deviation.guess(expected), rest);
        if step >= rest {
            vertex(1.0);
            return Ok(());
        }
        let next = t + step;
        t = if next > t { next } else { t.next_up() };
        vertex(t);
        deviation.start_at(t);
    }
}

/// A step that respects the tolerance and uses most of it, or the whole rest.
#[inline]
fn longest_step(deviation: &mut impl Deviation, guess: f64, rest: f64) -> f64 {
    let h = deviation.first_try(guess, rest);
    let squared = deviation.squared(h);
    if squared.bounded_by(1.0) && (h >= rest || !squared.bounded_by(KEPT_FROM)) {
        return h;
    }
    corrected_step(deviation, h, squared, rest)
}

/// [`longest_step`] after a first step `h` that was too long or too short.
fn corrected_step(
    deviation: &mut impl Deviation,
    mut h: f64,
    mut squared: Fraction,
    rest: f64,
) -> f64 {
    let (mut safe, mut unsafe_from) = (0.0, f64::INFINITY);
    for correction in 0.. {
        if squared.bounded_by(1.0) {
            if h >= rest || !squared.bounded_by(KEPT_FROM) {
                return h;
            }
            safe = h;
        } else {
            unsafe_from = h;
        }
        if (correction >= MAX_CORRECTIONS && safe > 0.0) || h < f64::EPSILON * f64::EPSILON {
            break;
        }
        let next = h * fourth_root(AIMED_AT * squared.under, squared.over);
        let between = next > safe && next < unsafe_from;
        h = if between {
            next
        } else {
            0.5 * (safe + unsafe_from.min(MAX_LENGTHENING * h))
        }
        .min(rest);
        squared = deviation.squared(h);
    }
    safe
}
