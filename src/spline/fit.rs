//! Curve fitting: a spline through a sequence of sampled points.

use super::Spline;
use super::corners::{angle_between, corners};
use super::cubics::{
    FitCriteria, FitEffort, FitSamples, ROUNDING_SHARE, chord_lengths, is_straight,
};
use super::grid::{DecimalGrid, NormalizedGrid};
use super::polyline::{PointTree, SampledPolyline};
use super::smoothing::smoothed;
use crate::geometry::check::{check_points, check_tolerance, max_abs};
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::sort::sort_by;
use std::f64::consts::PI;

/// Options of [`Spline::fit`].
///
/// ```
/// use casteljau::spline::FitOptions;
///
/// let options = FitOptions::new(0.5).corner_angle(0.3).closed(true);
/// assert_eq!(options.tolerance, 0.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "camelCase")
)]
#[non_exhaustive]
pub struct FitOptions {
    /// The largest distance of a point from the spline, in the unit of the points.
    pub tolerance: f64,
    /// The smallest turn that is kept as a corner, in radians, above 0 and at most π: π/5 (36°) by default.
    #[cfg_attr(feature = "serde", serde(default = "default_corner_angle"))]
    pub corner_angle: f64,
    /// Whether the spline continues from the last point to the first: false by default.
    #[cfg_attr(feature = "serde", serde(default))]
    pub closed: bool,
    /// How much is computed: [`FitEffort::Fast`] by default.
    #[cfg_attr(feature = "serde", serde(default))]
    pub effort: FitEffort,
}

/// Methods that set one option, for chaining.
impl FitOptions {
    /// The options with a tolerance and otherwise the defaults.
    pub const fn new(tolerance: f64) -> Self {
        Self {
            tolerance,
            corner_angle: DEFAULT_CORNER_ANGLE,
            closed: false,
            effort: FitEffort::Fast,
        }
    }

    /// Sets the smallest turn that is kept as a corner, in radians.
    #[must_use]
    pub const fn corner_angle(self, corner_angle: f64) -> Self {
        Self {
            corner_angle,
            ..self
        }
    }

    /// Sets whether the spline is closed.
    #[must_use]
    pub const fn closed(self, closed: bool) -> Self {
        Self { closed, ..self }
    }

    /// Sets how much is computed.
    #[must_use]
    pub const fn effort(self, effort: FitEffort) -> Self {
        Self { effort, ..self }
    }
}

/// The default of the corner angle: 36°.
pub(crate) const DEFAULT_CORNER_ANGLE: f64 = PI / 5.0;

#[cfg(feature = "serde")]
pub(crate) const fn default_corner_angle() -> f64 {
    DEFAULT_CORNER_ANGLE
}

/// A smaller coordinate of a unit tangent is 0.
const MIN_COORDINATE: f64 = 1e-9;

/// Joints are moved by at least and at most these parts of the tolerance.
const MIN_SHIFT: f64 = 0.05;
const MAX_SHIFT: f64 = 0.9;

impl<P: Point> Spline<P> {
    /// A spline of few cubics fitted to points in order, for example a freehand stroke or a dense polyline.
    ///
    /// Every point lies within the tolerance of the spline. The spline passes the points in order, except for noise: each
    /// point lies at most three tolerances from the part of the spline that follows the previous points. Between two points
    /// at a distance L, if the spline steps back at neither, it lies within the tolerance plus L/6 of their edge (the height
    /// of an arc that turns by 74°), or plus a quarter of the tolerance if that is more. The handles are at most 1.5 times as
    /// long as the chord length of their points.
    ///
    /// An open spline starts at the first point and ends at the last; a closed spline starts at its first corner, or at the
    /// first point if it has no corners. The other joints are input points, or lie within the tolerance of one where the
    /// points have noise.
    ///
    /// Turns by more than the corner angle are kept as corners. They are measured over arms of 8, 16 and 32 tolerances, so noise within the tolerance adds no
    /// corners, and a bend that a smooth curve follows within the tolerance is not a corner. Where neighbouring points are
    /// more than 8 tolerances apart, a turn counts if it is more than twice the turns next to it or above 75°. The other
    /// joints are smooth. Tangents come from parabolas fitted to neighbouring points.
    ///
    /// Repeated points count once. A closed spline continues from the last point to the first, smoothly unless there is
    /// a corner. If all points are equal the result is a line of length 0. If the noise is larger than the tolerance, the
    /// spline has to follow the noise, with many segments. The time grows slightly faster than the number of points.
    ///
    /// # Errors
    /// [`Error::Count`] for fewer than 2 points, [`Error::NotFinite`] for a NaN or an infinity, [`Error::Range`] and
    /// [`Error::Tolerance`] as [`Curve::flatten`](crate::Curve::flatten), [`Error::Range`] for the corner angle.
    pub fn fit(points: &[P], options: &FitOptions) -> Result<Self, Error> {
        let FitOptions {
            tolerance,
            corner_angle,
            closed,
            effort,
        } = *options;
        if points.len() < 2 {
            return Err(Error::Count {
                what: "points",
                expected: "at least 2 points",
                got: points.len(),
            });
        }
        check_points("points", points)?;
        check_tolerance(tolerance, max_abs(points))?;
        check_corner_angle(corner_angle)?;
        let mut kept = points.to_vec();
        kept.dedup();
        if closed && kept.first() != kept.last() {
            kept.push(kept[0]);
        }
        if kept.len() < 2 {
            let ends = if closed { 1 } else { 2 };
            return Ok(Self::from_parts(vec![kept[0]; ends], &[1], closed));
        }
        let mut fitter = CurveFitter::new(&kept, tolerance, corner_angle, closed);
        fitter.effort = effort;
        // Reserve a part of the tolerance for the rounding of the result.
        fitter.criteria.tolerance = fitter.tolerance * (1.0 - ROUNDING_SHARE);
        Ok(fitter.fitted(None))
    }
}

pub(crate) fn check_corner_angle(angle: f64) -> Result<(), Error> {
    if angle > 0.0 && angle <= PI {
        return Ok(());
    }
    Err(Error::Range {
        what: "corner_angle",
        expected: "an angle above 0 and at most π",
        got: angle,
    })
}

/// The input points, translated to the origin and scaled to a size of about 1.
pub(crate) struct CurveFitter<'a, P: Point> {
    input: &'a [P],
    normalized: Normalized<P>,
    polyline: SampledPolyline<P>,
    /// Scaled as the points.
    tolerance: f64,
    corners: Vec<usize>,
    pub(crate) criteria: FitCriteria<P>,
    pub(crate) effort: FitEffort,
}

impl<'a, P: Point> CurveFitter<'a, P> {
    /// Expects at least two points; those of a closed polyline end with the first one.
    pub(crate) fn new(input: &'a [P], tolerance: f64, corner_angle: f64, closed: bool) -> Self {
        let normalized = Normalized::around(input[0], input);
        let polyline = SampledPolyline::new(normalized.points(input), closed);
        let tolerance = tolerance * normalized.scale;
        Self {
            input,
            normalized,
            tolerance,
            corners: corners(&polyline, tolerance, corner_angle),
            polyline,
            criteria: FitCriteria {
                tolerance,
                ..FitCriteria::default()
            },
            effort: FitEffort::Fast,
        }
    }

    /// The indices of the corners, in increasing order.
    pub(crate) fn corners(&self) -> &[usize] {
        &self.corners
    }

    pub(crate) fn add_corners(&mut self, indices: Vec<usize>) {
        self.corners.extend(indices);
        sort_by(&mut self.corners, |a, b| a.cmp(b));
        self.corners.dedup();
    }

    /// The tree of the points, for [`turn_at`](Self::turn_at).
    pub(crate) fn tree(&self) -> PointTree<'_, P> {
        PointTree::new(&self.polyline.points[..self.polyline.period()])
    }

    /// The angle by which the polyline turns at a point, over arms of at least some tolerances.
    pub(crate) fn turn_at(&self, tree: &PointTree<P>, k: usize, arm: f64) -> f64 {
        let period = self.polyline.period();
        let here = self.polyline.point(k);
        let far = arm * self.tolerance;
        let closed = self.polyline.is_closed();
        let before = tree.last_beyond(here, far, 0..k);
        let after = tree.first_beyond(here, far, k + 1..period);
        // A closed polyline goes on around its start. Where no point is far away, an arm has all of them.
        let (before, after) = if closed {
            (
                before.or_else(|| tree.last_beyond(here, far, k + 1..period)),
                after.or_else(|| tree.first_beyond(here, far, 0..k)),
            )
        } else {
            (before, after)
        };
        let (first, last) = if closed {
            (k + 1, k + period - 1)
        } else {
            (0, period - 1)
        };
        let before = self.polyline.point(before.unwrap_or(first));
        let after = self.polyline.point(after.unwrap_or(last));
        angle_between(here - before, after - here)
    }

    /// Sets the greatest distance between the polyline and the spline, and the other criteria.
    pub(crate) fn require(&mut self, distance: f64, extrema: bool, grid: Option<DecimalGrid>) {
        let normalized = self.normalized;
        self.criteria = FitCriteria {
            tolerance: distance * normalized.scale,
            bound_edges: true,
            monotone: extrema,
            grid: grid.map(|grid| NormalizedGrid { grid, normalized }),
        };
    }

    /// The fitted spline, with the given tangents before and after each point or smoothed ones.
    pub(crate) fn fitted(self, tangents: Option<Vec<[P; 2]>>) -> Spline<P> {
        let period = self.polyline.period();
        let last = self.polyline.points.len() - 1;
        let (mut joints, mut tangents) = match tangents {
            Some(tangents) => (self.polyline.points.clone(), tangents),
            None => {
                let smoothed = self.smoothed();
                let at = |k: usize| smoothed[k % period].tangents;
                let joints = (0..=last).map(|k| self.joint(k, &smoothed)).collect();
                (joints, (0..=last).map(at).collect())
            }
        };
        if let Some(grid) = self.criteria.grid {
            for (joint, &point) in joints.iter_mut().zip(&self.polyline.points) {
                let rounded = grid.nearest(*joint);
                // A smoothed joint lies within the tolerance of its point, but rounding may move it farther away.
                let is_near = (rounded - point).norm() <= self.criteria.tolerance;
                *joint = if is_near {
                    rounded
                } else {
                    grid.nearest(point)
                };
            }
        }
        let mut stops = self.corners.clone();
        if self.criteria.monotone {
            stops.extend(self.align_extrema(&mut tangents));
            sort_by(&mut stops, |a, b| a.cmp(b));
            stops.dedup();
        }
        // A closed spline starts at a stop.
        let first = match stops.first() {
            Some(&stop) if self.polyline.is_closed() => stop,
            _ => 0,
        };
        stops.iter_mut().for_each(|stop| *stop -= first);
        stops.retain(|&stop| 0 < stop && stop < last);
        stops.insert(0, 0);
        stops.push(last);
        // The index on the polyline of the k-th point after the first stop.
        let around = |k: usize| {
            if k + first <= last {
                k + first
            } else {
                k + first - period
            }
        };
        let joints: Vec<P> = (0..=last).map(|k| joints[around(k)]).collect();
        let tangents: Vec<[P; 2]> = (0..=last).map(|k| tangents[around(k)]).collect();
        let points: Vec<P> = (0..=last)
            .map(|k| self.polyline.points[around(k)])
            .collect();
        let samples = FitSamples {
            lengths: chord_lengths(&joints),
            tangents: tangents.iter().map(|pair| pair[1]).collect(),
            points: points.clone(),
            joints: joints.clone(),
            criteria: self.criteria,
        };
        let cubics = samples.fit_between_stops(&tangents, &stops, self.effort);
        let on_grid = |p: P| self.criteria.grid.map_or(p, |on| on.grid.nearest(p));
        let joint = |k: usize| {
            // A joint that was not moved has the coordinates of the input, without the rounding of the normalization.
            on_grid(if joints[k] == points[k] {
                self.input[around(k)]
            } else {
                self.normalized.inverse(joints[k])
            })
        };
        // The difference keeps handles parallel to an axis.
        let offset = |k: usize, handle: P| (handle - joints[k]) / self.normalized.scale;
        let handle = |k: usize, handle: P| on_grid(joint(k) + offset(k, handle));
        let tolerance = self.criteria.tolerance / self.normalized.scale;
        let closed = self.polyline.is_closed();
        assemble(&cubics, closed, tolerance, joint, handle)
    }

    /// Makes tangents parallel to the axis at the points between which a coordinate of the tangent changes sign, at the
    /// nearest one or at both ends of a straight part. Returns the indices of these points.
    fn align_extrema(&self, tangents: &mut [[P; 2]]) -> Vec<usize> {
        let closed = self.polyline.is_closed();
        let (count, rounds) = (self.polyline.period(), if closed { 2 } else { 1 });
        let is_corner = |k: usize| self.corners.binary_search(&k).is_ok();
        let mut stops = Vec::new();
        for axis in 0..P::DIMENSION {
            let aligned = |tangent: P| tangent.with_coordinate(axis, 0.0).unit();
            for tangent in tangents.iter_mut().flatten() {
                if tangent.coordinate(axis).abs() < MIN_COORDINATE {
                    *tangent = aligned(*tangent);
                }
            }
            // The last tangent with a coordinate that is not 0, and the ends of the straight part after it.
            let mut before = (0, 0.0);
            let mut straight: Option<[usize; 2]> = None;
            // The second round of a closed polyline finds a change of sign across its start.
            for k in 0..rounds * count {
                let k = k % count;
                for side in [0, 1] {
                    let slope = tangents[k][side].coordinate(axis);
                    if slope == 0.0 {
                        straight = Some(straight.map_or([k, k], |[first, _]| [first, k]));
                        continue;
                    }
                    if before.1 * slope < 0.0 {
                        let nearest = if f64::abs(before.1) < slope.abs() {
                            before.0
                        } else {
                            k
                        };
                        if let Some(ends) = straight {
                            stops.extend(ends);
                        } else if !is_corner(nearest) {
                            tangents[nearest] = tangents[nearest].map(aligned);
                            stops.push(nearest);
                        }
                    }
                    (before, straight) = ((k, slope), None);
                }
            }
        }
        if closed {
            tangents[count] = tangents[0];
        }
        stops
    }

    /// The smoothed positions and the tangents on both sides of each point.
    fn smoothed(&self) -> Vec<SmoothedPoint<P>> {
        let period = self.polyline.period();
        let mut result = vec![SmoothedPoint::default(); period];
        for [first, last] in self.runs() {
            for (index, smoothed) in smoothed(&self.polyline, [first, last], self.tolerance) {
                let point = &mut result[index % period];
                // Without corners, the range extends beyond one round of a closed polyline.
                if last - first > period && index / period != 1 {
                    continue;
                }
                point.sum += smoothed.position;
                point.count += 1.0;
                // At a corner, one range ends with the tangent before it, and another starts with the tangent after it.
                if index > first {
                    point.tangents[0] = smoothed.tangent;
                }
                if index < last {
                    point.tangents[1] = smoothed.tangent;
                }
            }
        }
        result
    }

    /// The ranges of indices from corner to corner. A closed polyline without corners is one range of two rounds.
    fn runs(&self) -> Vec<[usize; 2]> {
        let period = self.polyline.period();
        let mut stops = self.corners.clone();
        if !self.polyline.is_closed() {
            stops.insert(0, 0);
            stops.push(period - 1);
        } else if let Some(&first) = stops.first() {
            stops.push(first + period);
        } else {
            // Each point of the round from `period` to 2 · `period` has at least half a round on both sides.
            stops = vec![period / 2, 2 * period + period / 2];
        }
        stops.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    }

    /// The position of a joint at a point: the smoothed one, if it differs clearly, but not farther away than the
    /// tolerance allows. The ends of an open polyline are kept.
    fn joint(&self, k: usize, smoothed: &[SmoothedPoint<P>]) -> P {
        let point = self.polyline.points[k];
        let is_end = k == 0 || k + 1 == self.polyline.points.len();
        let smoothed = smoothed[k % self.polyline.period()];
        let offset = smoothed.sum / smoothed.count - point;
        let distance = offset.norm();
        if is_end && !self.polyline.is_closed() || distance <= MIN_SHIFT * self.tolerance {
            return point;
        }
        point + offset * (MAX_SHIFT * self.tolerance / distance).min(1.0)
    }
}

/// Sums over one range, or at a corner over the two ranges that meet there.
#[derive(Clone, Copy, Default)]
struct SmoothedPoint<P> {
    sum: P,
    count: f64,
    tangents: [P; 2],
}

/// The spline of fitted cubics: `joint` gives the joint at an index, `handle` a control point by the index of its joint
/// and its image. Cubics that are straight become lines, those that are points are left out.
fn assemble<P: Point>(
    cubics: &[(usize, [P; 2])],
    closed: bool,
    tolerance: f64,
    joint: impl Fn(usize) -> P,
    handle: impl Fn(usize, P) -> P,
) -> Spline<P> {
    let mut points = vec![joint(0)];
    let mut degrees = Vec::with_capacity(cubics.len());
    let mut from = 0;
    for &(to, [p1, p2]) in cubics {
        let (start, end) = (points[points.len() - 1], joint(to));
        let (p1, p2) = (handle(from, p1), handle(to, p2));
        from = to;
        // A cubic that is a point is kept only as the last one of a spline that would otherwise be empty.
        if [p1, p2, end] == [start; 3] && (to < cubics[cubics.len() - 1].0 || !degrees.is_empty()) {
            continue;
        }
        if is_straight(&[start, p1, p2, end], tolerance) {
            degrees.push(1);
        } else {
            points.extend([p1, p2]);
            degrees.push(3);
        }
        points.push(end);
    }
    if closed {
        points.pop();
    }
    Spline::from_parts(points, &degrees, closed)
}
