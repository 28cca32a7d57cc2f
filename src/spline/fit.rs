//! Curve fitting: a spline through a sequence of sampled points.

use super::Spline;
use super::cubics::{FitCriteria, FitSamples, chord_lengths};
use crate::geometry::check::{check_finite, check_tolerance, max_abs};
use crate::geometry::error::Error;
use crate::geometry::point::Point;

/// A turn by more than this angle, in radians, is a corner.
const SURE_CORNER: f64 = 1.3;

/// A turn by more than this angle, in radians, is a corner if it is more than twice the turns next to it.
const MIN_CORNER: f64 = 0.6;

/// Directions are taken over this many tolerances, so that noise within the tolerance does not affect them.
const REACH: f64 = 4.0;

/// The number of points on each side from which a tangent is estimated.
const NEIGHBOURS: usize = 6;

impl<P: Point> Spline<P> {
    /// A spline of few cubics fitted to points in order, for example a freehand stroke or a dense polyline.
    ///
    /// Every point lies within `tolerance` of the spline, in order. The distance between the points is not bounded, but
    /// the handles are at most 1.5 times as long as the chord length of their points. The spline starts at the first
    /// point and ends at the last; its joints are input points. Corners are kept: turns by more than 75°, or by more
    /// than 35° if the turn is more than twice its neighbours, measured over four tolerances. The other joints are
    /// smooth. Tangents come from a parabola fitted to neighbouring points. Repeated points count once. A closed spline
    /// continues from the last point to the first, smoothly unless there is a corner. If all points are equal the
    /// result is a line of length 0. The time grows slightly faster than the number of points.
    ///
    /// # Errors
    /// [`Error::Count`] for fewer than 2 points, [`Error::NotFinite`] for a NaN or an infinity, [`Error::Range`] and
    /// [`Error::Tolerance`] as [`Curve::flatten`](crate::Curve::flatten).
    pub fn fit(points: &[P], tolerance: f64, closed: bool) -> Result<Self, Error> {
        if points.len() < 2 {
            return Err(Error::Count {
                what: "points",
                expected: "at least 2 points",
                got: points.len(),
            });
        }
        check_finite("points", points)?;
        check_tolerance(tolerance, max_abs(points))?;
        let mut kept = points.to_vec();
        kept.dedup();
        if closed && kept.first() != kept.last() {
            kept.push(kept[0]);
        }
        if kept.len() < 2 {
            let ends = if closed { 1 } else { 2 };
            return Ok(Self::from_parts(vec![kept[0]; ends], &[1], closed));
        }
        Ok(CurveFitter::new(&kept, tolerance, closed).fitted())
    }
}

/// The input points, translated to the origin and scaled to a size of about 1.
struct CurveFitter<'a, P: Point> {
    input: &'a [P],
    scale: f64,
    samples: FitSamples<P>,
    closed: bool,
}

impl<'a, P: Point> CurveFitter<'a, P> {
    fn new(input: &'a [P], tolerance: f64, closed: bool) -> Self {
        let scale = scale_of(input);
        let points = scaled(input, scale);
        let tolerance = tolerance * scale;
        let samples = FitSamples {
            lengths: chord_lengths(&points),
            tangents: Vec::new(),
            points,
            criteria: FitCriteria {
                // Reserve a part of the tolerance for the rounding of the result.
                tolerance: tolerance * (1.0 - ROUNDING_SHARE),
                between: false,
            },
        };
        Self {
            input,
            scale,
            samples,
            closed,
        }
    }

    fn fitted(mut self) -> Spline<P> {
        let corners = self.corners();
        self.samples.tangents = vec![P::default(); self.input.len()];
        let mut cubics = Vec::new();
        let smooth = self.closed && corners.first() != Some(&0);
        let mut stops = corners;
        let last = self.input.len() - 1;
        stops.retain(|&k| k > 0 && k < last);
        stops.insert(0, 0);
        stops.push(last);
        for pair in stops.windows(2) {
            for k in pair[0]..=pair[1] {
                self.samples.tangents[k] = self.tangent(k, pair[0], pair[1]);
            }
            if smooth {
                let both = self.tangent_around();
                if pair[0] == 0 {
                    self.samples.tangents[0] = both;
                }
                if pair[1] == last {
                    self.samples.tangents[last] = both;
                }
            }
            self.samples.cover(pair[0], pair[1], &mut cubics);
        }
        assemble(self.input, self.scale, &cubics, self.closed)
    }

    /// The next point at a chord length of about REACH tolerances from point k, at least one point ahead. `None` past
    /// the end, and if a closed stroke is shorter.
    fn after(&self, k: usize) -> Option<usize> {
        let lengths = &self.samples.lengths;
        let last = lengths.len() - 1;
        let to = lengths[k] + REACH * self.samples.criteria.tolerance;
        let at = lengths.partition_point(|&arc| arc < to).max(k + 1);
        if at <= last {
            Some(at)
        } else if self.closed {
            let round = lengths.partition_point(|&arc| arc < to - lengths[last]);
            Some(round.max(1)).filter(|&at| at < k)
        } else {
            (k < last).then_some(last)
        }
    }

    /// The previous point at that distance; the counterpart of [`after`](Self::after).
    fn before(&self, k: usize) -> Option<usize> {
        let lengths = &self.samples.lengths;
        let last = lengths.len() - 1;
        let to = lengths[k] - REACH * self.samples.criteria.tolerance;
        let at = lengths.partition_point(|&arc| arc <= to).checked_sub(1);
        if let Some(at) = at.filter(|_| k > 0) {
            return Some(at.min(k - 1));
        }
        if self.closed {
            let round = lengths.partition_point(|&arc| arc <= to + lengths[last]);
            round
                .checked_sub(1)
                .map(|at| at.min(last - 1))
                .filter(|&at| at > k)
        } else {
            (k > 0).then_some(0)
        }
    }

    /// The turning angle at a point, and the two points before and after it from which the angle is measured.
    fn turn(&self, k: usize) -> Option<(f64, usize, usize)> {
        let (before, after) = (self.before(k)?, self.after(k)?);
        let points = &self.samples.points;
        let (u, v) = (
            (points[k] - points[before]).normalize_or_zero(),
            (points[after] - points[k]).normalize_or_zero(),
        );
        // The angle of unit vectors is 2 asin(|u − v|/2), which is accurate for small and for large angles.
        let angle = 2.0 * ((u - v).length() * 0.5).min(1.0).asin();
        Some((angle, before, after))
    }

    /// The indices of the corners; contains 0 only for a closed stroke.
    fn corners(&self) -> Vec<usize> {
        let last = self.input.len() - 1;
        let turns: Vec<Option<(f64, usize, usize)>> = (0..last)
            .map(|k| {
                if k > 0 || self.closed {
                    self.turn(k)
                } else {
                    None
                }
            })
            .collect();
        let angle = |k: usize| turns[k % last].map_or(0.0, |turn| turn.0);
        let is_corner = |&k: &usize| {
            let Some((here, before, after)) = turns[k] else {
                return false;
            };
            if here < MIN_CORNER {
                return false;
            }
            let stands_out = here > 2.0 * angle(before).max(angle(after));
            // A corner is the largest turn in its neighbourhood (the first of equal ones). The search runs outwards and
            // ends at the first larger turn, so on average it takes little more than one comparison per point.
            let (back, ahead) = ((k + last - before) % last, (after + last - k) % last);
            let blunter = |i: usize| angle(i) < here || angle(i) == here && i % last > k;
            let sharpest = (1..back.max(ahead))
                .all(|n| (n >= back || blunter(k + last - n)) && (n >= ahead || blunter(k + n)));
            (here > SURE_CORNER || stands_out) && sharpest
        };
        (0..last).filter(is_corner).collect()
    }

    /// The unit tangent at point k of a run, from a parabola through that point fitted to its neighbours.
    fn tangent(&self, k: usize, first: usize, last: usize) -> P {
        let samples = &self.samples;
        let here = |index: usize| {
            (
                samples.points[index] - samples.points[k],
                samples.lengths[index] - samples.lengths[k],
            )
        };
        let reach = REACH * samples.criteria.tolerance;
        let far = |index: usize| (samples.lengths[index] - samples.lengths[k]).abs() >= reach;
        let before = steps_to(k - first, |n| far(k - n)).map(|n| here(k - n));
        let after = steps_to(last - k, |n| far(k + n)).map(|n| here(k + n));
        parabola(before.chain(after))
    }

    /// The tangent at the start of a closed stroke that has no corner there.
    fn tangent_around(&self) -> P {
        let samples = &self.samples;
        let last = samples.points.len() - 1;
        let count = NEIGHBOURS.min(last / 2).max(1);
        let ends = (1..=count).flat_map(|n| {
            [
                (samples.points[n] - samples.points[0], samples.lengths[n]),
                (
                    samples.points[last - n] - samples.points[last],
                    samples.lengths[last - n] - samples.lengths[last],
                ),
            ]
        });
        parabola(ends)
    }
}

/// Up to NEIGHBOURS evenly spaced steps to one side, over a range that extends beyond the tolerance.
fn steps_to(room: usize, far: impl Fn(usize) -> bool) -> impl Iterator<Item = usize> {
    let count = room.min(NEIGHBOURS);
    let mut reach = count;
    while reach < room && !far(reach) {
        reach = (2 * reach).min(room);
    }
    (1..=count).map(move |i| i * reach / count)
}

/// The direction of v for the least-squares fit d = v x + c x² to pairs (d, x): the unit tangent at x = 0.
fn parabola<P: Point>(points: impl Iterator<Item = (P, f64)>) -> P {
    let (mut s2, mut s3, mut s4) = (0.0, 0.0, 0.0);
    let (mut r1, mut r2) = (P::default(), P::default());
    for (d, x) in points {
        s2 += x * x;
        s3 += x * x * x;
        s4 += x * x * x * x;
        r1 += d * x;
        r2 += d * (x * x);
    }
    let determinant = s2 * s4 - s3 * s3;
    let slope = if determinant > 1e-9 * s2 * s4 {
        r1 * s4 - r2 * s3
    } else {
        r1
    };
    slope.normalize_or_zero()
}

/// The part of the tolerance that is reserved for rounding.
pub(crate) const ROUNDING_SHARE: f64 = 1e-3;

/// Approximately the inverse of the largest distance from the first point: a power of two with a finite inverse.
pub(crate) fn scale_of<P: Point>(points: &[P]) -> f64 {
    let half = points[0] * 0.5;
    let reach = points
        .iter()
        .fold(0.0, |m: f64, &p| m.max((p * 0.5 - half).max_abs()));
    (-reach.log2().round()).clamp(-1000.0, 1000.0).exp2()
}

/// The points translated so that the first one is the origin, and scaled.
pub(crate) fn scaled<P: Point>(points: &[P], scale: f64) -> Vec<P> {
    let origin = points[0] * scale;
    points.iter().map(|&p| p * scale - origin).collect()
}

/// The spline of fitted cubics, scaled back; the end points are taken from the input.
pub(crate) fn assemble<P: Point>(
    input: &[P],
    scale: f64,
    cubics: &[(usize, [P; 2])],
    closed: bool,
) -> Spline<P> {
    let back = |p: P| p / scale + input[0];
    let mut points = vec![input[0]];
    for &(to, [p1, p2]) in cubics {
        points.extend([back(p1), back(p2), input[to]]);
    }
    if closed {
        points.pop();
    }
    Spline::from_parts(points, &vec![3; cubics.len()], closed)
}
