//! Curve fitting: a spline through a sequence of sampled points.

use super::Spline;
use super::corners::{angle_between, corners};
use super::cubics::{FitCriteria, FitSamples, chord_lengths};
use super::polyline::SampledPolyline;
use super::smoothing::smoothed;
use crate::geometry::check::{check_points, check_tolerance, max_abs};
use crate::geometry::error::Error;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::{CrossProduct, Point};
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
    pub corner_angle: f64,
    /// Whether the spline continues from the last point to the first: false by default.
    pub closed: bool,
}

impl FitOptions {
    /// The options with a tolerance and otherwise the defaults.
    pub const fn new(tolerance: f64) -> Self {
        Self {
            tolerance,
            corner_angle: DEFAULT_CORNER_ANGLE,
            closed: false,
        }
    }

    /// The options with another corner angle.
    #[must_use]
    pub const fn corner_angle(self, corner_angle: f64) -> Self {
        Self {
            corner_angle,
            ..self
        }
    }

    /// The options for a closed spline or an open one.
    #[must_use]
    pub const fn closed(self, closed: bool) -> Self {
        Self { closed, ..self }
    }
}

/// The default of the corner angle: 36°.
pub(crate) const DEFAULT_CORNER_ANGLE: f64 = PI / 5.0;

/// Joints are moved by at least and at most these parts of the tolerance.
const MIN_SHIFT: f64 = 0.05;
const MAX_SHIFT: f64 = 0.9;

impl<P: Point> Spline<P> {
    /// A spline of few cubics fitted to points in order, for example a freehand stroke or a dense polyline.
    ///
    /// Every point lies within the tolerance of the spline. The spline passes the points in order, except for noise: each
    /// point lies at most three tolerances from the part of the spline that follows the previous points. The distance
    /// between the points is not bounded, but the handles are at most 1.5 times as long as the chord length of their
    /// points. An open spline starts at the first point and ends at the last. The other joints are input points, or lie
    /// within the tolerance of one where the points have noise.
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
        let fitter = CurveFitter::new(&kept, tolerance, corner_angle, closed);
        let criteria = FitCriteria {
            // Reserve a part of the tolerance for the rounding of the result.
            tolerance: fitter.tolerance * (1.0 - ROUNDING_SHARE),
            between: false,
        };
        Ok(fitter.fitted(criteria, None))
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

    /// The angle by which the polyline turns at a point, over arms of at least some tolerances.
    pub(crate) fn turn_at(&self, k: usize, arm: f64) -> f64 {
        let period = self.polyline.period();
        let here = self.polyline.point(k);
        let is_far = |p: &P| (*p - here).norm() >= arm * self.tolerance;
        let [before, after] = [false, true].map(|ahead| {
            let (room, at) = match (self.polyline.is_closed(), ahead) {
                (true, _) => (period - 1, k + period),
                (false, true) => (period - 1 - k, k),
                (false, false) => (k, k),
            };
            let point = |steps: usize| {
                let index = if ahead { at + steps } else { at - steps };
                self.polyline.point(index)
            };
            (1..=room)
                .map(point)
                .find(is_far)
                .unwrap_or_else(|| point(room))
        });
        angle_between(here - before, after - here)
    }

    /// A spline within a distance of the polyline, with the given tangents before and after each point or smoothed ones.
    pub(crate) fn within(self, distance: f64, tangents: Option<Vec<[P; 2]>>) -> Spline<P> {
        let criteria = FitCriteria {
            tolerance: distance * self.normalized.scale,
            between: true,
        };
        self.fitted(criteria, tangents)
    }

    fn fitted(self, criteria: FitCriteria, tangents: Option<Vec<[P; 2]>>) -> Spline<P> {
        let points = &self.polyline.points;
        let last = points.len() - 1;
        let mut stops = vec![0];
        stops.extend(self.corners.iter().filter(|&&k| k > 0));
        stops.push(last);
        let (joints, tangents) = match tangents {
            Some(tangents) => (points.clone(), tangents),
            None => {
                let smoothed = self.smoothed();
                let at = |k: usize| smoothed[k % self.polyline.period()].tangents;
                let joints = (0..=last).map(|k| self.joint(k, &smoothed)).collect();
                (joints, (0..=last).map(at).collect())
            }
        };
        let samples = FitSamples {
            lengths: chord_lengths(&joints),
            tangents: tangents.iter().map(|pair| pair[1]).collect(),
            points: points.clone(),
            joints: joints.clone(),
            criteria,
        };
        let cubics = samples.cover_all(&tangents, &stops);
        assemble(&self.normalized, &cubics, self.polyline.is_closed(), |k| {
            if joints[k] == points[k] {
                self.input[k]
            } else {
                self.normalized.back(joints[k])
            }
        })
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

/// The part of the tolerance that is reserved for rounding.
pub(crate) const ROUNDING_SHARE: f64 = 1e-3;

/// A cubic whose handles are within this part of its length of its chord is a line.
const STRAIGHT: f64 = 1e-9;

/// The spline of fitted cubics, scaled back, with the given joints. Cubics that are straight become lines.
fn assemble<P: Point>(
    normalized: &Normalized<P>,
    cubics: &[(usize, [P; 2])],
    closed: bool,
    joint: impl Fn(usize) -> P,
) -> Spline<P> {
    let mut points = vec![joint(0)];
    let mut degrees = Vec::with_capacity(cubics.len());
    for &(to, handles) in cubics {
        let [p1, p2] = handles.map(|p| normalized.back(p));
        let (from, end) = (points[points.len() - 1], joint(to));
        if is_line([from, p1, p2, end]) {
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

/// Whether a cubic is straight and does not pass its ends.
pub(crate) fn is_line<P: Point>([a, b, c, d]: [P; 4]) -> bool {
    let chord = d - a;
    let square = chord.dot(chord);
    square > 0.0
        && [b, c].into_iter().all(|p| {
            let gap = p - a;
            (0.0..=square).contains(&gap.dot(chord)) && chord.cross(gap).size() <= STRAIGHT * square
        })
}
