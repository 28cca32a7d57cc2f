//! Hausdorff distance of two curves.

use super::segment_tree::{Bounded, Heap};
use super::{nearest_parameter, nearest_with_steps};
use crate::bernstein::evaluate::evaluate;
use crate::curve::Curve;
use crate::curve::elevate::elevate_once;
use crate::curve::straight::Chord;
use crate::geometry::normalized::Normalized;
use crate::geometry::point::Point;
use crate::numeric::float::ulp;
use crate::numeric::list::Points;
use casteljau_kernels::numeric::work_limit::WorkLimit;

/// Maximum number of nearest points. Only coincident curves with different parametrizations need more.
const MAX_NEAREST_POINTS: usize = 600;

/// Maximum total of segments in the searches for nearest points, in each direction.
const MAX_STEPS: usize = 6000;

/// Relative amount by which the result may be too small.
const ACCURACY: f64 = 1e-9;

impl<P: Point> Curve<P> {
    /// The Hausdorff distance of two curves: the maximum distance of a point of either curve from the other curve.
    ///
    /// max(maxₜ minᵤ |A(t) − B(u)|, maxᵤ minₜ |A(t) − B(u)|), symmetric, in the unit of the points. 0 means that the
    /// curves are the same set of points, whatever their parametrization. The result is never too large, and too small
    /// by at most 10⁻⁹ of the distance or some ulps of the largest coordinate: segments are halved until the distance
    /// of two segments at equal parameters proves this. The proof is abandoned after 600 nearest points, or after 6000
    /// segments in the searches for them, in either direction. This happens only for curves that nearly coincide with
    /// different parametrizations and are above degree 3 or nearly straight; the result is then the largest distance
    /// found. In tests with curves that were less than 10⁻⁸ of their size apart it was at least three quarters of the
    /// true one. Points and straight curves are allowed.
    ///
    /// Source: Alt and Scharf, "Computing the Hausdorff distance between curved objects", IJCGA 18 (2008).
    ///
    /// ```
    /// use casteljau::{Curve, glam::DVec2};
    ///
    /// let line = Curve::new(&[(0.0, 0.0), (2.0, 0.0)].map(DVec2::from))?;
    /// let arch = Curve::new(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(DVec2::from))?;
    /// assert_eq!(line.hausdorff(&arch), 1.5);
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    pub fn hausdorff(&self, other: &Self) -> f64 {
        let size = self.max_abs().max(other.max_abs());
        let normalized = Normalized::new(self.start(), size);
        let scale = normalized.scale;
        let [a, b] = [self, other]
            .map(|curve| as_segment(normalized.points(&curve.points), ulp(size * scale)));
        let ulps = 2.0 * (a.len() + b.len()) as f64;
        let rounding = ulps * ulp(size * scale);
        let (high, wide) = elevated_alike(&a, &b);
        let mut greatest = 0.0;
        greatest = distance_to_curve([&a, &high], [&b, &wide], rounding, greatest);
        greatest = distance_to_curve([&b, &wide], [&a, &high], rounding, greatest);
        if greatest <= rounding {
            0.0
        } else {
            greatest / scale
        }
    }
}

/// Replaces a straight curve by the segment between its extreme points, whatever its parametrization.
fn as_segment<P: Point>(points: Points<P>, rounding: f64) -> Points<P> {
    let start = points[0];
    let chord = Chord::of(&points);
    if points.len() == 2 || chord.width > 8.0 * rounding {
        return points;
    }
    let project = |p: P| (p - start).dot(chord.direction);
    let curve = Curve::from_points(points);
    // The extreme points are ends, or points where the projection onto the chord turns.
    let turns = crate::curve::extrema::extrema_of(
        &curve
            .points
            .iter()
            .map(|&p| project(p))
            .collect::<Vec<f64>>(),
    );
    let (mut low, mut high) = (start, start);
    for t in turns.into_iter().chain([1.0]) {
        let p = curve.eval(t);
        if project(p) < project(low) {
            low = p;
        } else if project(p) > project(high) {
            high = p;
        }
    }
    [low, high].into_iter().collect()
}

/// Both curves, elevated to the higher of their degrees.
fn elevated_alike<P: Point>(a: &Points<P>, b: &Points<P>) -> (Points<P>, Points<P>) {
    let raised = |points: &Points<P>, count: usize| {
        let mut points = points.clone();
        while points.len() < count {
            elevate_once(&mut points);
        }
        points
    };
    (raised(a, b.len()), raised(b, a.len()))
}

/// A segment of A with the parameters of the points of B that are nearest to its ends.
struct SegmentWithNearest<P: Point> {
    points: Points<P>,
    from: f64,
    to: f64,
}

/// The maximum distance of a point of A from B, if it is above `greatest`. Each curve is given twice: unchanged, and
/// elevated to the higher degree.
fn distance_to_curve<P: Point>(
    [original, a]: [&Points<P>; 2],
    [b, high]: [&Points<P>; 2],
    rounding: f64,
    mut greatest: f64,
) -> f64 {
    let mut work = WorkLimit::new(MAX_STEPS);
    let mut examine = |p: P, greatest: &mut f64| {
        let (u, steps) = nearest_with_steps(b, p);
        let within = work.spend(steps);
        *greatest = greatest.max((evaluate(b, u) - p).norm());
        (u, within)
    };
    let b_curve = Curve::from_slice(high);
    let straight = [original.len() == 2, b.len() == 2];
    let (from, _) = examine(a[0], &mut greatest);
    let (to, _) = examine(a[a.len() - 1], &mut greatest);
    let whole = SegmentWithNearest {
        points: a.clone(),
        from,
        to,
    };
    // The heap gives the smallest number first, so the upper bounds are stored with the opposite sign.
    let mut segments = Heap::new();
    segments.push(Bounded {
        min: -whole.max(&b_curve, straight),
        of: whole,
    });
    for _ in 0..MAX_NEAREST_POINTS {
        // The segment with the largest upper bound; if it cannot increase the result, none can.
        let Some(Bounded { min, of: segment }) = segments.pop() else {
            break;
        };
        if -min <= greatest * (1.0 + ACCURACY) + rounding {
            break;
        }
        let (left, right) = Curve::from_points(segment.points).halve();
        let (mid, within) = examine(right.points[0], &mut greatest);
        if !within {
            break;
        }
        for half in [
            SegmentWithNearest {
                points: left.points,
                from: segment.from,
                to: mid,
            },
            SegmentWithNearest {
                points: right.points,
                from: mid,
                to: segment.to,
            },
        ] {
            segments.push(Bounded {
                min: -half.max(&b_curve, straight),
                of: half,
            });
        }
    }
    greatest
}

impl<P: Point> SegmentWithNearest<P> {
    /// An upper bound on the distance of the segment's points from B: the maximum distance at equal parameters from the
    /// segment of B between the nearest points, or from one of its ends. For straight segments the bound does not
    /// depend on the parametrization.
    fn max(&self, b: &Curve<P>, straight: [bool; 2]) -> f64 {
        let along = b.part(self.from, self.to);
        let beside = match straight {
            [_, true] => self.distance_from_segment(b),
            [true, _] => self.straight_distance_from(&along),
            _ => f64::INFINITY,
        };
        let far = |to: &dyn Fn(usize) -> P| {
            let away = self
                .points
                .iter()
                .enumerate()
                .map(|(i, &p)| (p - to(i)).norm());
            away.fold(0.0, f64::max)
        };
        // The difference of curves of one degree lies in the convex hull of the differences of their control points.
        far(&|i| along.points[i])
            .min(far(&|_| along.start()))
            .min(far(&|_| along.end()))
            .min(beside)
    }

    /// The maximum distance of a control point from a line segment: the distance from a convex set is a convex
    /// function.
    fn distance_from_segment(&self, b: &Curve<P>) -> f64 {
        let segment = [b.start(), b.end()];
        let away = |&p: &P| (p - evaluate(&segment, nearest_parameter(&segment, p))).norm();
        self.points.iter().map(away).fold(0.0, f64::max)
    }

    /// The bound for a straight segment: the other one passes each of its points at most as far from the line as its
    /// control points are, or it ends before; then the missing length is added.
    fn straight_distance_from(&self, along: &Curve<P>) -> f64 {
        let (start, end) = (self.points[0], self.points[self.points.len() - 1]);
        let direction = (end - start).unit();
        let x = |p: P| (p - start).dot(direction);
        let off = |&p: &P| (p - start - direction * x(p)).norm();
        let beside = along.points.iter().map(off).fold(0.0, f64::max);
        let missing = x(along.start()).max(x(end) - x(along.end())).max(0.0);
        beside.hypot(missing)
    }
}
