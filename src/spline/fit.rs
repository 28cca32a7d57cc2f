//! Which spline runs along a stroke?

use super::Spline;
use super::cubics::{FitCriteria, FitSamples, chord_lengths};
use crate::geometry::check::{check_finite, check_tolerance, max_abs};
use crate::geometry::error::Error;
use crate::geometry::point::Point;

/// A turn by more than this, in radians, is a corner.
const SURE_CORNER: f64 = 1.3;

/// A turn by more than this is one if it stands out: more than twice those next to it.
const MIN_CORNER: f64 = 0.6;

/// Directions are taken over this many tolerances, so that noise within the tolerance does not turn them.
const REACH: f64 = 4.0;

/// The points on each side that a tangent is taken from.
const NEIGHBOURS: usize = 6;

impl<P: Point> Spline<P> {
    /// A spline of few cubics along points in order: a stroke drawn by hand, a dense polyline.
    ///
    /// Every point lies within `tolerance` of the spline, in order; between the points nothing is promised, but the handles
    /// are no longer than the way of the points. The spline starts at the first point and ends at the last, and its joints are
    /// points. Corners stay corners: turns by more than 75°, or by 35° and twice as much as next to them, as
    /// seen over four tolerances; the other joints are smooth. Tangents come from a parabola through neighbours. Points that repeat
    /// count once. A closed spline leads from the last point back to the first, smoothly unless there is a corner.
    /// A single place gives a line without a length. The time grows a little faster than the number of points.
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

/// Points moved to the origin and scaled to about 1.
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
                // Rounding of the result takes its share.
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

    /// The point about REACH tolerances after another one; at least one step. `None` past the end, and where a closed
    /// stroke is shorter.
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

    /// The same before a point.
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

    /// The angle by which the points turn at one of them, and its neighbours there.
    fn turn(&self, k: usize) -> Option<(f64, usize, usize)> {
        let (before, after) = (self.before(k)?, self.after(k)?);
        let points = &self.samples.points;
        let (u, v) = (
            (points[k] - points[before]).normalize_or_zero(),
            (points[after] - points[k]).normalize_or_zero(),
        );
        // Of unit vectors: 2 asin(|u − v|/2), exact for small angles and large ones.
        let angle = 2.0 * ((u - v).length() * 0.5).min(1.0).asin();
        Some((angle, before, after))
    }

    /// The indices of corners; 0 only on a closed stroke.
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
            // The sharpest of its surroundings; of equal ones the first. From the inside out, this ends next to a
            // sharper one: for all points together a little more than one look at each.
            let (back, ahead) = ((k + last - before) % last, (after + last - k) % last);
            let blunter = |i: usize| angle(i) < here || angle(i) == here && i % last > k;
            let sharpest = (1..back.max(ahead))
                .all(|n| (n >= back || blunter(k + last - n)) && (n >= ahead || blunter(k + n)));
            (here > SURE_CORNER || stands_out) && sharpest
        };
        (0..last).filter(is_corner).collect()
    }

    /// The unit tangent at a point of a run: that of a parabola through it, along its neighbours.
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

    /// The tangent at the start of a closed stroke without a corner there.
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

/// Up to NEIGHBOURS steps to one side, evenly, as many as it takes to see past the tolerance.
fn steps_to(room: usize, far: impl Fn(usize) -> bool) -> impl Iterator<Item = usize> {
    let count = room.min(NEIGHBOURS);
    let mut reach = count;
    while reach < room && !far(reach) {
        reach = (2 * reach).min(room);
    }
    (1..=count).map(move |i| i * reach / count)
}

/// The unit tangent at 0 of v x + c x² by least squares through (d, x).
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

/// What rounding may take of the tolerance.
pub(crate) const ROUNDING_SHARE: f64 = 1e-3;

/// About the inverse of the size of some points, seen from the first: a power of two with a finite inverse.
pub(crate) fn scale_of<P: Point>(points: &[P]) -> f64 {
    let half = points[0] * 0.5;
    let reach = points
        .iter()
        .fold(0.0, |m: f64, &p| m.max((p * 0.5 - half).max_abs()));
    (-reach.log2().round()).clamp(-1000.0, 1000.0).exp2()
}

/// Points moved to the origin and scaled.
pub(crate) fn scaled<P: Point>(points: &[P], scale: f64) -> Vec<P> {
    let origin = points[0] * scale;
    points.iter().map(|&p| p * scale - origin).collect()
}

/// The spline of some cubics; their ends are given points.
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
